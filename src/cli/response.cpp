#include "cli/response.hpp"

#include "cli/choices.hpp"
#include "core/names.hpp"
#include "motion/tolerances.hpp"

#include <fmt/format.h>

namespace carom::cli {

namespace {

std::vector<std::string> guard_words_known()
{
    std::vector<std::string> words = words_of(guard_fallback_names);
    words.insert(words.begin(), {"on", "off"});
    return words;
}

}  // namespace

Scene with_response(Scene scene, const GivenOptions& given, const std::string& file)
{
    const Choices choices(given, scene.run, file + ": /run");
    if (choices.has("impact")) {
        const std::string word = choices.word("impact", words_of(impact_operator_names));
        scene.impact.impact_operator = *value_named<ImpactOperator>(word, impact_operator_names);
    }
    if (choices.has("guard")) {
        const std::string word = choices.word("guard", guard_words_known());
        scene.guard.on = word != "off";
        scene.guard.fallback = value_named<GuardFallback>(word, guard_fallback_names).value_or(scene.guard.fallback);
    }
    return scene;
}

std::string impact_words(const Scene& scene)
{
    const ImpactOptions& impact = scene.impact;
    std::string text(name_of(impact.impact_operator, impact_operator_names));
    if (impact.impact_operator == ImpactOperator::lcp) {
        text += fmt::format(" ({}, {}", name_of(impact.lcp.law, lcp_law_names),
                            name_of(impact.lcp.solver, lcp_solver_names));
        if (impact.lcp.solver == LcpSolver::gauss_seidel) text += fmt::format(", {} sweeps", impact.lcp.sweeps);
        text += ")";
    }
    if (impact.on_cap == OnCap::stop) text += ", nothing beyond its bound";
    return text + (impact.tie ? fmt::format(", tie {:.3g} r", *impact.tie)
                              : fmt::format(", tie {:.3g} r, 0 in certified runs", default_tie));
}

std::string rest_words(const Scene& scene)
{
    const RestThresholds rest = rest_thresholds(scene);
    return fmt::format(
        "policy {}; closing speed {:.3g}, window {:.3g}, numeric step {:.3g}, gap tolerance {:.3g}, series below "
        "{:.3g} r",
        name_of(scene.rest.policy, rest_policy_names), rest.closing_speed, rest.window, rest.numeric_step,
        rest.gap_tolerance, scene.rest.series_below);
}

std::string guard_words(const Scene& scene)
{
    if (!scene.guard.on) return "off: a run ends where inelastic impacts accumulate";
    return fmt::format("more than {} impacts a body within {:.3g}; then {} for one window", scene.guard.impacts,
                       scene.guard.window.value_or(rest_thresholds(scene).numeric_step),
                       name_of(scene.guard.fallback, guard_fallback_names));
}

}  // namespace carom::cli
