#include "cli/compare_audit.hpp"

#include "cli/limits.hpp"
#include "study/share.hpp"
#include "study/words.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace carom::cli {

std::string share_cell(const std::optional<Audit>& audit, std::int64_t Audit::*part, std::int64_t Audit::*whole)
{
    if (!audit || (*audit).*whole == 0) return "-";
    if ((*audit).*part == 0) return "0";
    const std::string text =
        fmt::format("{:.3g} %", per_cent * study::wilson_share((*audit).*part, (*audit).*whole).value);
    return text;
}

std::string share_with_interval(const std::optional<Audit>& audit, std::int64_t Audit::*part)
{
    if (!audit || audit->audited == 0) return "-";
    const study::Share share = study::wilson_share((*audit).*part, audit->audited);
    const std::string text =
        fmt::format("{:.3g} % ({:.3g}-{:.3g})", per_cent * share.value, per_cent * share.low, per_cent * share.high);
    return text;
}

std::string audit_line(const Comparison& comparison)
{
    const AuditSummary& audit = comparison.audit;
    const bool asked = std::any_of(comparison.rows.begin(), comparison.rows.end(),
                                   [](const CompareRow& row) { return row.dt && row.audit; });
    if (!asked) return "";
    std::string text =
        audit.drawn < audit.contacts
            ? fmt::format("Audit: {} of {} impacts up to t = {}, drawn at random", audit.drawn, audit.contacts,
                          study::time_text(audit.until, ""))
            : fmt::format("Audit: {} impacts up to t = {}", audit.contacts, study::time_text(audit.until, ""));
    if (audit.phases > 1) text += fmt::format(", each at {} phases of the step", audit.phases);
    return text + fmt::format(
                      ", from the exact state, one at a time; not asked about: {} closing slower than v_c, {} "
                      "contacts that last\n",
                      audit.slow, audit.persistent);
}

}  // namespace carom::cli
