#include "io/named_value.hpp"
#include "io/scene_draft.hpp"

#include <limits>

namespace carom::io {

namespace {

constexpr std::uint64_t most = std::numeric_limits<int>::max();

void read_lcp(ObjectView& view, LcpOptions& lcp)
{
    lcp.law = read_named<LcpLaw>(view, "law", lcp_law_names).value_or(lcp.law);
    lcp.solver = read_named<LcpSolver>(view, "solver", lcp_solver_names).value_or(lcp.solver);
    lcp.sweeps = static_cast<int>(view.integer("sweeps", 1, most).value_or(static_cast<std::uint64_t>(lcp.sweeps)));
}

/// Keys that an operator other than lcp would silently ignore.
void refuse_lcp_options(ObjectView& view)
{
    for (const char* key : {"law", "solver", "sweeps"})
        if (view.has(key)) view.problem(key, "is for the operator \"lcp\" (remove it, or take that operator)");
}

}  // namespace

void read_impact(ObjectView& root, SceneDraft& draft)
{
    const auto section = root.find("impact");
    if (!section) return;
    ImpactOptions& impact = draft.scene.impact;
    const auto named = [&](const Place& place) {
        return as_named<ImpactOperator>(place, impact_operator_names, root.problems());
    };
    if (section->value->kind == Json::Kind::string) {
        impact.impact_operator = named(*section).value_or(impact.impact_operator);
        return;
    }
    if (section->value->kind != Json::Kind::object) {
        root.problem("impact", "must be the name of an operator or an object, is " + describe(*section->value));
        return;
    }
    const std::size_t before = root.problems().count();
    ObjectView view(*section, root.problems());
    if (const auto place = view.find("operator"))
        impact.impact_operator = named(*place).value_or(impact.impact_operator);
    const bool operator_known = root.problems().count() == before;
    impact.tie = view.number("tie", not_negative);
    impact.on_cap = read_named<OnCap>(view, "on_cap", on_cap_names).value_or(impact.on_cap);
    if (impact.impact_operator == ImpactOperator::lcp || !operator_known)
        read_lcp(view, impact.lcp);
    else
        refuse_lcp_options(view);
    view.finish();
}

}  // namespace carom::io
