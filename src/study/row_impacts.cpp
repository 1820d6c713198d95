#include "study/row_impacts.hpp"

#include "scene/tolerances.hpp"
#include "study/absorbed.hpp"
#include "study/tolerances.hpp"

#include <carom/metrics.hpp>

#include <algorithm>
#include <limits>

namespace carom::study {

namespace {

/// The largest root mean square speed of the reference at a sample [length/time].
double speed_scale(const Reference& reference)
{
    double speed = 0;
    for (const auto& states : reference.samples) {
        const std::vector<BodyState> still(states.size());
        speed = std::max(speed, velocity_deviation(states, still).rms);
    }
    return speed;
}

/// How far apart the times of one impact may be in two runs.
double match_width(const RowTask& task)
{
    if (const StepOptions* step = step_options(task.method)) return match_steps * step->dt;
    // The event method has no step: what is not yet diverged may be early or late by its distance over its speed.
    const double speed = speed_scale(task.reference);
    const double drift = speed > 0 ? divergence_threshold(task.scene) / speed : 0;
    return std::max(match_part_of_run * task.run.until, drift);
}

/// How far an impact of the event method may be from that of the reference to be in time: what the reference knows, or
/// what counts as touching, at the speed of the scene.
double in_time(const RowTask& task)
{
    const double speed = speed_scale(task.reference);
    const double distance = std::max(task.reference.bound, declared_contact * smallest_radius(task.scene));
    return speed > 0 ? distance / speed : std::numeric_limits<double>::infinity();
}

/// The impacts of an event-driven run beside those of the reference, as the audit counts.
Audit audit_of(const MatchResult& match)
{
    Audit audit;
    audit.audited = match.expected - match.absorbed;
    audit.missed = match.missed - match.mistimed;
    audit.late = match.late + match.mistimed;
    audit.found = audit.audited - audit.missed - audit.late;
    audit.looked_at = match.found;
    audit.invented = std::max<std::int64_t>(0, match.invented - match.mistimed);
    return audit;
}

}  // namespace

RowImpacts::RowImpacts(const RowTask& task)
    : task_(task), width_(match_width(task)), v_c_(rest_thresholds(task.scene).closing_speed)
{
}

bool RowImpacts::is_slow(const Event& event) const
{
    return is_event() && event.time <= task_.truth.until &&
           -gap_rate_before(task_.scene, task_.truth, event.normal, event.a, event.b, event.time) < v_c_;
}

void RowImpacts::add(const Event& event, double horizon)
{
    // Nobody asks about impacts after the divergence; a jittering stack has millions.
    if (event.time > horizon + width_) return;
    if (event.kind == EventKind::impact) found_.push_back({event.time, event.a, event.b, is_slow(event)});
    if (event.kind == EventKind::rest) rests_.push_back({event.time, event.a, event.b});
}

void RowImpacts::end_open_series(const Outcome& outcome)
{
    for (auto last = found_.rbegin(); last != found_.rend(); ++last)
        if (outcome.final[static_cast<std::size_t>(last->a)].mode == Mode::series)
            rests_.push_back({outcome.time, last->a, last->b});
}

void RowImpacts::put_into(CompareRow& row, double horizon) const
{
    const StepOptions* step = step_options(task_.method);
    const ExpectedImpacts expected =
        expected_impacts(task_.reference, step != nullptr ? shortest_flight_steps * step->dt : 0);
    const IsAbsorbed absorbed = [&](const Pair& pair, double time) {
        return is_absorbed(task_.scene, task_.truth, pair.first, pair.second, time);
    };
    const MatchWindow window{width_, horizon, is_event() ? in_time(task_) : std::numeric_limits<double>::infinity()};
    const MatchResult match = match_impacts(expected, found_, rests_, window, is_event() ? absorbed : IsAbsorbed());
    if (is_event()) {
        row.audit = audit_of(match);
        row.absorbed_impacts = match.absorbed;
    }
    row.missed_impacts = match.missed;
    row.invented_impacts = match.invented;
    row.mistimed_impacts = match.mistimed;
    row.reference_impacts = match.expected;
    row.missed = match.missed_list;
    row.invented = match.invented_list;
}

}  // namespace carom::study
