#include "cli/cli.hpp"
#include "cli/exit_codes.hpp"
#include "cli/response.hpp"
#include "cli/tables.hpp"
#include "core/names.hpp"

#include <carom/features.hpp>
#include <carom/io.hpp>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <ostream>

namespace carom::cli {

namespace {

struct Explanation {
    Features needed;
    const Kernel* kernel = nullptr;
    std::string broad_phase, reference;
    std::string why_gravity, why_pairs, why_drag, why_kernel;
};

std::string broad_phase_of(const Scene& scene)
{
    if (scene.spheres.size() < 2) return "none: one sphere has no neighbours";
    switch (event_broad_phase(scene)) {
        case BroadPhase::all_pairs:
            return "all pairs: the spheres are few";
        case BroadPhase::neighbour_lists:
            return fmt::format("neighbour lists: the spheres are many, of like size, and fill {:.3g} of their box",
                               packing_fraction(scene));
        case BroadPhase::automatic:
        case BroadPhase::cell_grid:
            break;
    }
    return "cell grid: the spheres are many, but sparse or of unlike size";
}

std::string reference_of(const Scene& scene)
{
    if (scene.spheres.size() < 2) return "closed form: a single sphere among planes";
    return "multiprecision: an independent event integrator in 50 and 100 digits; where a run gets chaotic it ends, "
           "and "
           "comparisons measure errors up to there";
}

Explanation explain(const Scene& scene, const std::string& forced)
{
    Explanation e;
    e.needed = needs(scene);
    e.kernel = &choose_kernel(scene, forced);
    e.broad_phase = broad_phase_of(scene);
    e.reference = reference_of(scene);
    e.why_gravity = e.needed.gravity ? "gravity is not 0" : "gravity is 0";
    e.why_drag = e.needed.drag ? "drag is above 0" : "drag is 0";
    e.why_pairs = fmt::format("there {} {} sphere{}", scene.spheres.size() == 1 ? "is" : "are", scene.spheres.size(),
                              scene.spheres.size() == 1 ? "" : "s");
    e.why_kernel = forced.empty() ? "the cheapest that covers the needs" : "forced, and it covers the needs";
    return e;
}

using Json = nlohmann::ordered_json;

/// With every default filled in; a tie that depends on the run is null.
Json impact_json(const ImpactOptions& impact)
{
    Json json = {{"operator", name_of(impact.impact_operator, impact_operator_names)},
                 {"tie", impact.tie ? Json(*impact.tie) : Json()},
                 {"on_cap", name_of(impact.on_cap, on_cap_names)}};
    if (impact.impact_operator == ImpactOperator::lcp) {
        json["law"] = name_of(impact.lcp.law, lcp_law_names);
        json["solver"] = name_of(impact.lcp.solver, lcp_solver_names);
        json["sweeps"] = impact.lcp.sweeps;
    }
    return json;
}

Json rest_json(const Scene& scene)
{
    const RestThresholds rest = rest_thresholds(scene);
    return {{"policy", name_of(scene.rest.policy, rest_policy_names)},
            {"closing_speed", rest.closing_speed},
            {"window", rest.window},
            {"numeric_step", rest.numeric_step},
            {"gap_tolerance", rest.gap_tolerance},
            {"series_below", scene.rest.series_below}};
}

Json guard_json(const Scene& scene)
{
    return {{"on", scene.guard.on},
            {"impacts", scene.guard.impacts},
            {"window", scene.guard.window.value_or(rest_thresholds(scene).numeric_step)},
            {"fallback", name_of(scene.guard.fallback, guard_fallback_names)}};
}

std::string as_json(const Scene& scene, const Explanation& e)
{
    Json list = Json::array();
    for (const Kernel& kernel : kernels())
        list.push_back(
            {{"name", kernel.name}, {"covers", covers(kernel.features, e.needed)}, {"leaves_out", kernel.leaves_out}});
    const Json json = {{"format", "carom-explain/1"},
                       {"scene", scene.name},
                       {"needs", {{"gravity", e.needed.gravity}, {"pairs", e.needed.pairs}, {"drag", e.needed.drag}}},
                       {"kernel", e.kernel->name},
                       {"why", e.why_kernel},
                       {"kernels", list},
                       {"impact", impact_json(scene.impact)},
                       {"rest", rest_json(scene)},
                       {"guard", guard_json(scene)},
                       {"broad_phase", e.broad_phase},
                       {"reference", e.reference}};
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string as_text(const Scene& scene, const Explanation& e)
{
    const auto yes = [](bool value) { return value ? "yes" : "no"; };
    std::string text = fmt::format("{} ({})\n", scene.name, bodies(scene));
    text += fmt::format("needs gravity   {:<4} {}\n", yes(e.needed.gravity), e.why_gravity);
    text += fmt::format("needs pairs     {:<4} {}\n", yes(e.needed.pairs), e.why_pairs);
    text += fmt::format("needs drag      {:<4} {}\n", yes(e.needed.drag), e.why_drag);
    text +=
        fmt::format("kernel          {}: {}; it leaves out {}\n", e.kernel->name, e.why_kernel, e.kernel->leaves_out);
    for (const Kernel& kernel : kernels())
        text += fmt::format("                {:<8} {}\n", kernel.name,
                            covers(kernel.features, e.needed) ? "covers this scene" : "lacks what this scene needs");
    text += fmt::format("impact          {}\n", impact_words(scene));
    text += fmt::format("rest            {}\n", rest_words(scene));
    text += fmt::format("guard           {}\n", guard_words(scene));
    text += fmt::format("broad phase     {}\n", e.broad_phase);
    text += fmt::format("reference       {}\n", e.reference);
    return text;
}

}  // namespace

int do_explain(const ExplainArguments& args, const GlobalArguments& global, const Console& console)
{
    const auto file = find_scene(args.scene, scene_folder());
    const Scene scene = with_response(read_with_options(file, args.allow_overlap, args.set, global), {}, file.string());
    const Explanation explanation = explain(scene, args.kernel);
    console.out << (global.json ? as_json(scene, explanation) : as_text(scene, explanation));
    return exit_ok;
}

}  // namespace carom::cli
