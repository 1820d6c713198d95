#include "study/row_errors.hpp"

#include "study/largest.hpp"
#include "study/row.hpp"

#include <cmath>

namespace carom::study {

RowErrors::RowErrors(const Scene& scene, const Reference& reference, const SampleTimes& times)
    : scene_(scene), reference_(reference), times_(times), overlap_(scene)
{
    for (const auto& states : reference.samples) keep_largest(reference_kinetic_, kinetic_energy(scene, states));
}

void RowErrors::sample(std::size_t moment, double time, std::span<const BodyState> states)
{
    const bool ends_sample = !times_.goes_on(moment);
    if (ends_sample) keep_series(states);
    if (moment < reference_.samples.size()) compare(moment, time, states, ends_sample);
}

void RowErrors::keep_series(std::span<const BodyState> states)
{
    series_.energy.push_back(total_energy(scene_, states));
    series_.penetration.push_back(overlap_.of(states));
    if (states.size() > max_track_spheres) return;
    auto& frame = series_.tracks.emplace_back();
    for (const BodyState& s : states) {
        const Eigen::Vector3f x = s.position.cast<float>();
        frame.push_back({x[0], x[1], x[2]});
    }
}

void RowErrors::compare(std::size_t moment, double time, std::span<const BodyState> states, bool ends_sample)
{
    const std::vector<BodyState>& truth = reference_.samples[moment];
    Difference difference{position_deviation(states, truth), velocity_deviation(states, truth),
                          energy_difference(scene_, states, truth) / reference_kinetic_};
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
    if (times_.sample[moment] + 1 == times_.grid.size()) last_position_ = difference.position;
}

void RowErrors::add(const Difference& difference, double time)
{
    position_squares_.add(difference.position.rms * difference.position.rms);
    velocity_squares_.add(difference.velocity.rms * difference.velocity.rms);
    keep_largest(position_max_, difference.position.max);
    keep_largest(energy_max_, std::abs(difference.energy));
    series_.position_max.push_back(difference.position.max);
    series_.energy_error.push_back(difference.energy);
    if (!divergence_time_ && !(difference.position.max <= divergence_threshold(scene_))) divergence_time_ = time;
    ++compared_;
}

void RowErrors::put_into(CompareRow& row)
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
    row.reference_bound = reference_.bound;
    for (const double depth : series_.penetration) keep_largest(row.overlap_left, depth);
    row.series = std::move(series_);
}

}  // namespace carom::study
