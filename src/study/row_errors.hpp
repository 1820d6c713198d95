/// \file
/// The errors of a run against the reference, collected as it shows its states.
#pragma once

#include "reference/reference.hpp"
#include "study/compensated_sum.hpp"
#include "study/deepest_overlap.hpp"
#include "study/sample_times.hpp"

#include <carom/study.hpp>

#include <optional>
#include <span>

namespace carom::study {

/// Sums are over what the reference covers. What it is made of outlives it.
class RowErrors {
public:
    RowErrors(const Scene& scene, const Reference& reference, const SampleTimes& times);

    /// States at a moment of the sample times, in their order.
    void sample(std::size_t moment, double time, std::span<const BodyState> states);

    /// When the run parted from the reference, the end of the reference if it did not: contacts are of interest up to
    /// here [time].
    double horizon() const { return divergence_time_.value_or(reference_.until); }

    /// Errors, jitter, divergence, overlaps at samples and the series. Once.
    void put_into(CompareRow& row);

private:
    /// Differences at one sample.
    struct Difference {
        Deviation position, velocity;
        double energy = 0;
    };
    void keep_series(std::span<const BodyState> states);
    void compare(std::size_t moment, double time, std::span<const BodyState> states, bool ends_sample);
    void add(const Difference& difference, double time);

    const Scene& scene_;
    const Reference& reference_;
    const SampleTimes& times_;
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

}  // namespace carom::study
