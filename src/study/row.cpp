#include "study/row.hpp"

#include "study/clock.hpp"
#include "study/largest.hpp"
#include "study/lift_watch.hpp"
#include "study/row_errors.hpp"
#include "study/row_impacts.hpp"
#include "study/tolerances.hpp"

#include <algorithm>

namespace carom::study {

double divergence_threshold(const Scene& scene)
{
    return divergence * smallest_radius(scene);
}

RecordedRow record_row(const RowTask& task)
{
    RecordedRow result;
    RowErrors errors(task.scene, task.reference, task.times);
    RowImpacts impacts(task);
    Stopwatch watch;
    Observer observer;
    observer.sample_times = task.times.asked;
    observer.on_progress = task.on_progress;
    observer.on_event = [&](const Event& event) { impacts.add(event, errors.horizon()); };
    observer.on_sample = [&](std::size_t k, double time, std::span<const BodyState> states) {
        watch.pause();
        errors.sample(k, time, states);
        watch.resume();
    };
    LiftWatch lift_watch(task.scene);
    if (std::holds_alternative<EventDriven>(task.method) && lift_watch.has_work()) {
        observer.on_frame = [&](const RunFrame& frame) { lift_watch.on_frame(frame); };
        observer.on_flight = [&](const FlightRecord& flight) { lift_watch.on_flight(flight); };
    }
    const Outcome outcome = simulate(task.scene, task.method, task.run, observer);
    watch.pause();
    result.cpu_seconds = watch.cpu();
    result.interrupted = outcome.status == Status::interrupted;
    if (result.interrupted) return result;

    CompareRow& row = result.row;
    const double horizon = std::min(errors.horizon(), outcome.time);
    errors.put_into(row);
    if (task.reference.until > 0) {
        impacts.end_open_series(outcome);
        impacts.put_into(row, horizon);
    }
    row.max_penetration = outcome.max_penetration;
    if (std::holds_alternative<EventDriven>(task.method)) keep_largest(row.max_penetration, row.overlap_left);
    row.impacts = outcome.counts.impacts;
    row.steps = outcome.counts.steps;
    row.root_solves = outcome.counts.root_solves;
    row.pair_tests = outcome.counts.pair_tests;
    row.status = outcome.status;
    row.message = outcome.message;
    row.time = outcome.time;
    row.lifts = lift_watch.lifts();
    return result;
}

}  // namespace carom::study
