#include "study/row.hpp"

#include "study/clock.hpp"
#include "study/compensated_sum.hpp"
#include "study/deepest_overlap.hpp"
#include "study/largest.hpp"
#include "study/lift_watch.hpp"
#include "study/row_impacts.hpp"
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

/// Collects a run as it goes. Sums are over what the reference covers.
class Recorder {
public:
    explicit Recorder(const RowTask& task) : task_(task), impacts_(task), overlap_(task.scene)
    {
        for (const auto& states : task.reference.samples)
            keep_largest(reference_kinetic_, kinetic_energy(task.scene, states));
    }

    void event(const Event& event) { impacts_.add(event, horizon()); }

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
    void keep_series(std::span<const BodyState> states);
    void compare(std::size_t moment, double time, std::span<const BodyState> states, bool ends_sample);
    void add(const Difference& difference, double time);

    const RowTask& task_;
    RowImpacts impacts_;
    DeepestOverlap overlap_;
    double reference_kinetic_ = 0;
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
    if (task_.reference.until > 0) {
        impacts_.end_open_series(outcome);
        impacts_.put_into(row, std::min(horizon(), outcome.time));
    }
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
