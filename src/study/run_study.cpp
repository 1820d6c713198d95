#include <carom/study.hpp>

#include "study/clock.hpp"
#include "study/deepest_overlap.hpp"
#include "study/drag_work.hpp"
#include "study/largest.hpp"
#include "study/lift_watch.hpp"
#include "study/tolerances.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace carom {

std::size_t look_intervals(std::size_t spheres)
{
    return std::clamp(study::most_spheres_looked_at / std::max<std::size_t>(spheres, 1), study::fewest_looks,
                      study_intervals);
}

RunStudy run_study(const Scene& scene, const Method& method, const RunStudyOptions& options)
{
    RunStudy result;
    result.method = std::string(name(method));
    const std::vector<BodyState> start = initial_states(scene);
    const bool event_driven = std::holds_alternative<EventDriven>(method);
    const double until = std::isnan(options.run.until) ? scene.end_time : options.run.until;

    const bool dear = scene.spheres.size() > study::few_to_look_at;
    study::DeepestOverlap overlap(scene);
    study::Stopwatch watch;
    double largest_change = 0, largest_drift = 0, largest_kinetic = kinetic_energy(scene, start), deepest = 0;
    study::DragWork drag_work(scene);
    const bool is_damped = scene.drag > 0, knows_drag = event_driven || !is_damped;
    const auto look = [&](std::span<const BodyState> states, double time) {
        const double change = energy_difference(scene, states, start);
        study::keep_largest(largest_change, std::abs(change));
        study::keep_largest(largest_drift, std::abs(is_damped ? change + drag_work.taken(time) : change));
        study::keep_largest(largest_kinetic, kinetic_energy(scene, states));
        if (event_driven) deepest = std::max(deepest, overlap.of(states));
    };
    Observer observer;
    // The energy of a discrete method may be at its worst in between, and a look costs as much as a step or two.
    const std::size_t usual = event_driven ? look_intervals(scene.spheres.size()) : study_intervals;
    std::vector<double> grid = sample_grid(until, options.intervals.value_or(usual));
    grid.pop_back();  // the end is looked at when it is there, wherever it is
    std::set_union(grid.begin(), grid.end(), options.more_times.begin(), options.more_times.end(),
                   std::back_inserter(observer.sample_times));
    observer.on_event = options.on_event;
    observer.on_frame = options.on_frame;
    observer.on_flight = options.on_flight;
    study::LiftWatch lift_watch(scene);
    if (event_driven && (lift_watch.has_work() || is_damped)) {
        observer.on_frame = [&](const RunFrame& frame) {
            lift_watch.on_frame(frame);
            drag_work.on_frame(frame);
            if (options.on_frame) options.on_frame(frame);
        };
        observer.on_flight = [&](const FlightRecord& flight) {
            lift_watch.on_flight(flight);
            if (is_damped) drag_work.on_flight(flight);
            if (options.on_flight) options.on_flight(flight);
        };
    }
    observer.on_progress = options.on_progress;
    observer.on_sample = [&](std::size_t, double time, std::span<const BodyState> states) {
        if (dear) watch.pause();
        look(states, time);
        if (options.on_state) options.on_state(time, states);
        if (dear) watch.resume();
    };
    result.outcome = simulate(scene, method, options.run, observer);
    watch.pause();
    result.cpu_seconds = watch.cpu();
    result.wall_seconds = watch.wall();

    const Outcome& outcome = result.outcome;
    look(outcome.final, outcome.time);
    result.initial_energy = total_energy(scene, start);
    result.final_energy = total_energy(scene, outcome.final);
    // Without motion there is no scale for a drift, and no drift either.
    if (knows_drag && contacts_conserve_energy(scene))
        result.max_relative_drift = largest_kinetic == 0 ? 0 : largest_drift / largest_kinetic;
    if (knows_drag) result.drag_energy = is_damped ? drag_work.taken(outcome.time) : 0;
    result.max_energy_change = largest_change;
    result.max_kinetic_energy = largest_kinetic;
    result.initial_momentum = momentum(scene, start);
    result.final_momentum = momentum(scene, outcome.final);
    result.max_penetration = std::max(outcome.max_penetration, deepest);
    result.lifts = lift_watch.lifts();
    result.escaped = escaped(scene, outcome.final);
    for (const double impulse : outcome.plane_impulses)
        result.plane_forces.push_back(outcome.time > 0 ? std::optional(impulse / outcome.time) : std::nullopt);
    return result;
}

}  // namespace carom
