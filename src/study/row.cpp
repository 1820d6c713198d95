#include "study/row.hpp"

#include "scene/tolerances.hpp"
#include "study/absorbed.hpp"
#include "study/clock.hpp"
#include "study/compensated_sum.hpp"
#include "study/deepest_overlap.hpp"
#include "study/largest.hpp"
#include "study/lift_watch.hpp"
#include "study/matching.hpp"
#include "study/tolerances.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace carom::study {

double divergence_threshold(const Scene& scene)
{
    return divergence * smallest_radius(scene);
}

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

/// Collects a run as it goes. Sums are over what the reference covers.
class Recorder {
public:
    explicit Recorder(const RowTask& task) : task_(task), width_(match_width(task)), overlap_(task.scene)
    {
        for (const auto& states : task.reference.samples)
            keep_largest(reference_kinetic_, kinetic_energy(task.scene, states));
    }

    void event(const Event& event)
    {
        // Nobody asks about impacts after the divergence; a jittering stack has millions.
        if (event.time > horizon() + width_) return;
        if (event.kind == EventKind::impact) found_.push_back({event.time, event.a, event.b, is_slow(event)});
        if (event.kind == EventKind::rest) rests_.push_back({event.time, event.a, event.b});
    }

    void sample(std::size_t moment, double time, std::span<const BodyState> states)
    {
        const bool ends_sample = !task_.times.goes_on(moment);
        if (ends_sample) keep_series(states);
        if (moment < task_.reference.samples.size()) compare(moment, time, states, ends_sample);
    }

    double horizon() const { return divergence_time_.value_or(task_.reference.until); }

    void finish(CompareRow& row, const Outcome& outcome);

private:
    /// Differences at one sample.
    struct Difference {
        Deviation position, velocity;
        double energy = 0;
    };
    /// The event method alone has v_c.
    bool is_slow(const Event& event) const
    {
        return step_options(task_.method) == nullptr &&
               -gap_rate_before(task_.scene, task_.truth, event.normal, event.a, event.b, event.time) < v_c_;
    }
    void keep_series(std::span<const BodyState> states);
    void compare(std::size_t moment, double time, std::span<const BodyState> states, bool ends_sample);
    void add(const Difference& difference, double time);
    void match(CompareRow& row, const Outcome& outcome);

    const RowTask& task_;
    double width_;
    double v_c_ = rest_thresholds(task_.scene).closing_speed;
    DeepestOverlap overlap_;
    double reference_kinetic_ = 0;
    std::vector<FoundImpact> found_, rests_;
    RowSeries series_;
    CompensatedSum position_squares_, velocity_squares_, jitter_squares_;
    double position_max_ = 0, energy_max_ = 0;
    std::size_t compared_ = 0, resting_ = 0;
    std::optional<Difference> before_impact_;  // at the moment before, of the same sample
    std::optional<double> divergence_time_;
    std::optional<Deviation> last_position_;  // at `until`
};

void Recorder::keep_series(std::span<const BodyState> states)
{
    series_.energy.push_back(total_energy(task_.scene, states));
    series_.penetration.push_back(overlap_.of(states));
    if (states.size() > max_track_spheres) return;
    auto& frame = series_.tracks.emplace_back();
    for (const BodyState& s : states) {
        const Eigen::Vector3f x = s.position.cast<float>();
        frame.push_back({x[0], x[1], x[2]});
    }
}

void Recorder::compare(std::size_t moment, double time, std::span<const BodyState> states, bool ends_sample)
{
    const std::vector<BodyState>& truth = task_.reference.samples[moment];
    Difference difference{position_deviation(states, truth), velocity_deviation(states, truth),
                          energy_difference(task_.scene, states, truth) / reference_kinetic_};
    if (before_impact_) {
        // The sample falls on an impact: of just before and just after the smaller difference counts.
        if (!(difference.position.max <= before_impact_->position.max)) difference.position = before_impact_->position;
        if (!(difference.velocity.rms <= before_impact_->velocity.rms)) difference.velocity = before_impact_->velocity;
        if (!(std::abs(difference.energy) <= std::abs(before_impact_->energy)))
            difference.energy = before_impact_->energy;
        before_impact_.reset();
    }
    if (!ends_sample) {
        before_impact_ = difference;
        return;
    }
    add(difference, time);
    for (std::size_t i = 0; i < states.size(); ++i) {
        if (truth[i].mode != Mode::resting) continue;
        jitter_squares_.add(states[i].velocity.squaredNorm());
        ++resting_;
    }
    if (task_.times.sample[moment] + 1 == task_.times.grid.size()) last_position_ = difference.position;
}

void Recorder::add(const Difference& difference, double time)
{
    position_squares_.add(difference.position.rms * difference.position.rms);
    velocity_squares_.add(difference.velocity.rms * difference.velocity.rms);
    keep_largest(position_max_, difference.position.max);
    keep_largest(energy_max_, std::abs(difference.energy));
    series_.position_max.push_back(difference.position.max);
    series_.energy_error.push_back(difference.energy);
    if (!divergence_time_ && !(difference.position.max <= divergence_threshold(task_.scene))) divergence_time_ = time;
    ++compared_;
}

void Recorder::match(CompareRow& row, const Outcome& outcome)
{
    const StepOptions* step = step_options(task_.method);
    const ExpectedImpacts expected =
        expected_impacts(task_.scene, task_.reference, step != nullptr ? shortest_flight_steps * step->dt : 0);
    // A series that is still going on at the end of the run stands for its bounces as a finished one does.
    for (auto last = found_.rbegin(); last != found_.rend(); ++last)
        if (outcome.final[static_cast<std::size_t>(last->a)].mode == Mode::series)
            rests_.push_back({outcome.time, last->a, last->b});
    const IsAbsorbed absorbed = [&](const Pair& pair, double time) {
        return is_absorbed(task_.scene, task_.truth, pair.first, pair.second, time);
    };
    const MatchWindow window{width_, std::min(horizon(), outcome.time),
                             step == nullptr ? in_time(task_) : std::numeric_limits<double>::infinity()};
    const MatchResult match =
        match_impacts(expected, found_, rests_, window, step == nullptr ? absorbed : IsAbsorbed());
    if (step == nullptr) {
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

void Recorder::finish(CompareRow& row, const Outcome& outcome)
{
    if (compared_ > 1) {  // at the start nobody is off
        const auto n = static_cast<double>(compared_);
        row.position_rms = std::sqrt(position_squares_.value() / n);
        row.velocity_rms = std::sqrt(velocity_squares_.value() / n);
        row.position_max = position_max_;
        if (reference_kinetic_ > 0) row.energy_error = energy_max_;
    }
    if (last_position_) {
        row.position_final_rms = last_position_->rms;
        row.position_final_max = last_position_->max;
    }
    if (resting_ > 0) row.rest_jitter = std::sqrt(jitter_squares_.value() / static_cast<double>(resting_));
    row.divergence_time = divergence_time_;
    row.reference_bound = task_.reference.bound;
    if (task_.reference.until > 0) match(row, outcome);
    row.max_penetration = outcome.max_penetration;
    for (const double depth : series_.penetration) keep_largest(row.overlap_left, depth);
    if (std::holds_alternative<EventDriven>(task_.method)) keep_largest(row.max_penetration, row.overlap_left);
    row.series = std::move(series_);
}

}  // namespace

RecordedRow record_row(const RowTask& task)
{
    RecordedRow result;
    Recorder recorder(task);
    Stopwatch watch;
    Observer observer;
    observer.sample_times = task.times.asked;
    observer.on_progress = task.on_progress;
    observer.on_event = [&](const Event& event) { recorder.event(event); };
    observer.on_sample = [&](std::size_t k, double time, std::span<const BodyState> states) {
        watch.pause();
        recorder.sample(k, time, states);
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
    recorder.finish(row, outcome);
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
