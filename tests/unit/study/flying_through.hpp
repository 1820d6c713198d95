/// \file
/// An engine that ignores contacts, as a contestant of `carom stress`: bodies fly through everything. It shows that a
/// rule can be failed, and all that an engine beside has to hand in.
#pragma once

#include "study/stress.hpp"

#include <carom/checks.hpp>
#include <carom/metrics.hpp>

#include <algorithm>
#include <limits>
#include <vector>

namespace carom::test {

inline std::vector<BodyState> flown_through(const Scene& scene, double time)
{
    std::vector<BodyState> states = initial_states(scene);
    for (std::size_t i = 0; i < states.size(); ++i) {
        if (scene.spheres[i].fixed) continue;
        states[i].position += time * states[i].velocity + time * time / 2 * scene.gravity;
        states[i].velocity += time * scene.gravity;
    }
    return states;
}

inline CheckReport fly_through(const Scene& scene)
{
    constexpr double looks = 500;  // at overlaps, closest at the start: a bullet is gone soon
    CheckReport report;
    RunStudy& study = report.run.study;
    study.method = "dummy";
    Outcome& outcome = study.outcome;
    outcome.time = scene.end_time;
    outcome.final = flown_through(scene, scene.end_time);
    for (int k = 1; k <= looks; ++k) {
        const std::vector<BodyState> states = flown_through(scene, scene.end_time * (k / looks) * (k / looks));
        outcome.max_penetration = std::max(outcome.max_penetration, max_penetration(scene, states));
        study.max_kinetic_energy = std::max(study.max_kinetic_energy, kinetic_energy(scene, states));
        study.max_energy_change =
            std::max(study.max_energy_change, std::abs(energy_difference(scene, states, initial_states(scene))));
    }
    study.max_penetration = outcome.max_penetration;
    study.escaped = escaped(scene, outcome.final);
    for (const Check& check : scene.checks) {
        CheckSight& sight = report.run.sights.emplace_back();
        if (check.type == CheckType::position)
            sight.position = flown_through(scene, check.time)[static_cast<std::size_t>(check.body)].position;
        // Elsewhere and later it flies just the same; but there is nothing that could be turned round.
        const bool turns = check.type == CheckType::reversed;
        if (turns || check.type == CheckType::moved || check.type == CheckType::moved_origin ||
            check.type == CheckType::later)
            sight.repeat = Repeat{outcome, turns ? std::numeric_limits<double>::infinity() : 0, turns};
    }
    report.results = evaluate_checks(scene, report.run);
    return report;
}

inline stress::Contestant flying_through()
{
    return {"dummy", false, {CheckType::rest_time}, [](const Scene& scene, const std::function<bool()>&) {
                return fly_through(scene);
            }};
}

}  // namespace carom::test
