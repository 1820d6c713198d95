/// \file
/// The times at which runs are held against the reference.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace carom::study {

/// Equal intervals, but a sample that falls on an impact of the reference is taken just before and just after it: there
/// an exact run may show the velocity on either side. The smaller difference counts.
struct SampleTimes {
    std::vector<double> grid;         ///< the samples [time]
    std::vector<double> asked;        ///< the moments at which states are taken, ascending [time]
    std::vector<std::size_t> sample;  ///< of each moment: the index of its sample, or of the sample that it stands for

    /// Whether the next moment belongs to the same sample.
    bool goes_on(std::size_t moment) const
    {
        return moment + 1 < sample.size() && sample[moment + 1] == sample[moment];
    }
};

/// These samples, those on an impact on both sides. \param interval between samples, of what is on an impact [time]
/// \param impacts of the reference, ascending [time]
SampleTimes beside_impacts(const std::vector<double>& grid, double interval, std::span<const double> impacts);
/// `intervals` equal ones from 0 to `end`. \param impacts of the reference, ascending [time]
SampleTimes sample_times(double end, std::size_t intervals, std::span<const double> impacts);

}  // namespace carom::study
