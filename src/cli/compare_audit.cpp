#include "cli/compare_audit.hpp"

#include "study/share.hpp"
#include "study/words.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace carom::cli {

namespace {

/// A share in per cent: three digits, which are what some thousand cases can tell.
std::string percent(double share)
{
    return fmt::format("{:.3g}", 100 * share);
}

}  // namespace

std::string share_cell(const std::optional<Audit>& audit, std::int64_t Audit::*part, std::int64_t Audit::*whole)
{
    if (!audit || (*audit).*whole == 0) return "-";
    if ((*audit).*part == 0) return "0";
    return percent(study::wilson_share((*audit).*part, (*audit).*whole).value) + " %";
}

std::string share_with_interval(const std::optional<Audit>& audit, std::int64_t Audit::*part)
{
    if (!audit || audit->audited == 0) return "-";
    const study::Share share = study::wilson_share((*audit).*part, audit->audited);
    return fmt::format("{} % ({}-{})", percent(share.value), percent(share.low), percent(share.high));
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
    return text + fmt::format(
                      ", from the exact state, one at a time; not asked about: {} closing slower than v_c, {} "
                      "contacts that last\n",
                      audit.slow, audit.persistent);
}

}  // namespace carom::cli
