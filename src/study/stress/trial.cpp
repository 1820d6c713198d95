#include "study/stress/trial.hpp"

#include "study/largest.hpp"

#include <carom/metrics.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace carom::stress {

namespace {

constexpr double longest_run = 20;  ///< a discrete run that takes longer is given up [s]

/// An event in whichever order the method names the two.
bool is_between(const Event& event, const ExpectedImpact& impact)
{
    return event.kind == EventKind::impact && std::min(event.a, event.b) == std::min(impact.a, impact.b) &&
           std::max(event.a, event.b) == std::max(impact.a, impact.b);
}

/// Relative to the larger of the kinetic energies.
double energy_change(const Scene& scene, std::span<const BodyState> start, std::span<const BodyState> end)
{
    const double scale = std::max(kinetic_energy(scene, start), kinetic_energy(scene, end));
    return scale > 0 ? std::abs(energy_difference(scene, end, start)) / scale : 0;
}

}  // namespace

void note_figure(Evidence& evidence, double value, const std::string& where)
{
    const double before = evidence.figure;
    study::keep_largest(evidence.figure, value);
    if (!(evidence.figure == before) && !std::isnan(before)) evidence.worst = where;
}

void take_note(const Scene& scene, const Outcome& outcome, Evidence& evidence)
{
    const bool finite = std::all_of(outcome.final.begin(), outcome.final.end(), [](const BodyState& s) {
        return s.position.allFinite() && s.velocity.allFinite();
    });
    if (outcome.status != Status::reached_end)
        evidence.stopped = outcome.message.empty() ? name(outcome.status) : outcome.message;
    else if (!finite)
        evidence.stopped = "ended in numbers that are not finite";
    study::keep_largest(evidence.penetration, outcome.max_penetration / smallest_radius(scene));
    if (conserves_energy(scene))
        study::keep_largest(evidence.energy, energy_change(scene, initial_states(scene), outcome.final));
}

Observer observed(Patience& patience)
{
    Observer observer;
    observer.on_progress = [&patience](double) { return patience.lasts(); };
    return observer;
}

Evidence measure(const std::vector<Trial>& trials, std::string_view method, Patience& patience)
{
    Evidence evidence;
    for (const Trial& trial : trials) {
        if (patience.ended()) break;
        std::vector<std::optional<double>> first(trial.first.size());
        Observer observer = observed(patience);
        observer.on_event = [&](const Event& event) {
            for (std::size_t k = 0; k < first.size(); ++k)
                if (!first[k] && is_between(event, trial.first[k])) first[k] = event.time;
        };
        RunOptions options;
        options.max_seconds = longest_run;
        const Outcome outcome =
            simulate(trial.scene, make_method(method, StepOptions{.dt = trial.dt}), options, observer);
        take_note(trial.scene, outcome, evidence);
        if (trial.impacts) {
            const std::int64_t surplus = outcome.counts.impacts - *trial.impacts;
            evidence.expected += *trial.impacts;
            evidence.missed += std::max<std::int64_t>(0, -surplus);
            evidence.invented += std::max<std::int64_t>(0, surplus);
            if (trial.count_is_figure)
                note_figure(evidence, std::abs(static_cast<double>(surplus)), trial.label + ", count");
        }
        for (std::size_t k = 0; k < first.size(); ++k)
            note_figure(evidence,
                        first[k] ? std::abs(*first[k] - trial.first[k].time) / trial.first[k].scale
                                 : std::numeric_limits<double>::infinity(),
                        trial.label + ", time");
        for (const ExpectedState& expected : trial.states) {
            const BodyState& found = outcome.final[static_cast<std::size_t>(expected.body)];
            if (expected.length > 0)
                note_figure(evidence, (found.position - expected.position).stableNorm() / expected.length,
                            trial.label + ", position");
            if (expected.speed > 0)
                note_figure(evidence, (found.velocity - expected.velocity).stableNorm() / expected.speed,
                            trial.label + ", velocity");
        }
    }
    return evidence;
}

}  // namespace carom::stress
