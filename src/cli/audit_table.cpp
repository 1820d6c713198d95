#include "cli/limits.hpp"
#include "cli/tables.hpp"
#include "core/names.hpp"
#include "study/words.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace carom::cli {

namespace {

std::string share(std::int64_t part, std::int64_t whole)
{
    if (whole == 0) return fmt::format("{}", part);
    return fmt::format("{} ({:.4g} %)", part, per_cent * static_cast<double>(part) / static_cast<double>(whole));
}

std::string note(const audit::Finding& finding)
{
    switch (finding.kind) {
        case audit::FindingKind::late:
            return fmt::format("{}{:.6g} later", finding.at_least ? "at least " : "", finding.by);
        case audit::FindingKind::early:
            return fmt::format("{:.6g} earlier", finding.by);
        case audit::FindingKind::invented:
            return finding.change > 0 ? fmt::format("velocity changes by {:.6g}", finding.change) : "leaves its flight";
        default:
            return "";
    }
}

std::string summary(const audit::TraceAudit& audit)
{
    const audit::BodyIntervals& bodies = audit.bodies;
    std::vector<std::vector<std::string>> rows{
        {"trace", fmt::format("{} frames, t = {:.10g} to {:.10g}{}", audit.frames, audit.begin, audit.end,
                              audit.whole ? "" : ", and no further")},
        {"places", fmt::format("known to {:.2g}", audit.place_error)},
        {"intervals", fmt::format("{}, one for each sphere that can move", bodies.all)},
        {"  decided", share(bodies.decided, bodies.all)},
        {"  no flight before",
         share(bodies.without_flight, bodies.all) + ": lasting contact, or contacts close together"},
        {"  on straight lines", share(bodies.straight, bodies.all) + ": within a method's steps (--step), or carried"},
        {"  too coarse", share(bodies.coarse, bodies.all) + ": unknown to more than 0.01 radii"},
        {"  several", share(bodies.several, bodies.all) + ": a change that other contacts may explain"},
        {"touches", fmt::format("{}", audit.touches.all)},
        {"  found", fmt::format("{}", audit.touches.found)}};
    for (std::size_t k = 0; k < audit::finding_kind_names.size(); ++k) {
        const auto kind = static_cast<audit::FindingKind>(k);
        const bool of_touches = kind != audit::FindingKind::invented && kind != audit::FindingKind::overlap;
        rows.push_back({(of_touches ? "  " : "") + std::string(audit::finding_kind_names[k]),
                        fmt::format("{}", audit.count(kind))});
    }
    rows.back().back() += audit.overlaps > 0 ? fmt::format(", at most {:.4g} deep", audit.deepest) : "";
    rows.push_back(
        {"undecided", fmt::format("{} touches: {} with other contacts, {} without flights after them, {} that "
                                  "may only graze",
                                  audit.undecided(), audit.touches.several, audit.touches.unsettled, audit.grazing)});
    return aligned(rows, 2);
}

}  // namespace

std::string audit_table(const Scene& scene, const audit::TraceAudit& audit)
{
    std::string text = summary(audit);
    if (audit.findings.empty()) return text;
    std::vector<std::vector<std::string>> rows{{"finding", "a", "b", "t", "depth", ""}};
    for (std::size_t k = 0; k < std::min(audit.findings.size(), most_listed_findings); ++k) {
        const audit::Finding& finding = audit.findings[k];
        rows.push_back({std::string(name_of(finding.kind, audit::finding_kind_names)), scene.body_name(finding.a),
                        finding.b == no_body ? "-" : scene.body_name(finding.b), fmt::format("{:.10g}", finding.time),
                        finding.depth > 0 ? fmt::format("{:.4g}", finding.depth) : "-", note(finding)});
    }
    text += "\n" + aligned(rows, 3);
    if (audit.found_wrong() > static_cast<std::int64_t>(rows.size()) - 1)
        text += fmt::format("and {} more\n", audit.found_wrong() - static_cast<std::int64_t>(rows.size()) + 1);
    return text;
}

}  // namespace carom::cli
