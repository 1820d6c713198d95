#include "audit/report.hpp"

namespace carom::audit {

std::int64_t TraceAudit::count(FindingKind kind) const
{
    switch (kind) {
        case FindingKind::missed:
            return touches.missed;
        case FindingKind::late:
            return touches.late;
        case FindingKind::early:
            return touches.early;
        case FindingKind::invented:
            return invented;
        case FindingKind::overlap:
            return overlaps;
    }
    return 0;
}

std::int64_t TraceAudit::found_wrong() const
{
    return touches.missed + touches.late + touches.early + invented + overlaps;
}

}  // namespace carom::audit
