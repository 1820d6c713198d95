#include "study/sample_times.hpp"

#include "study/tolerances.hpp"

#include <carom/simulate.hpp>

#include <algorithm>

namespace carom::study {

SampleTimes beside_impacts(const std::vector<double>& grid, double interval, std::span<const double> impacts)
{
    SampleTimes times;
    times.grid = grid;
    const double aside = on_impact * interval, end = grid.back();
    for (std::size_t k = 0; k < grid.size(); ++k) {
        const double time = grid[k];
        const auto add = [&](double moment) {
            if (moment < 0 || moment > end) return;
            times.asked.push_back(moment);
            times.sample.push_back(k);
        };
        const auto near = std::lower_bound(impacts.begin(), impacts.end(), time - aside);
        if (near == impacts.end() || *near > time + aside) {
            add(time);
        } else {
            add(time - 2 * aside);
            add(time + 2 * aside);
        }
    }
    return times;
}

SampleTimes sample_times(double end, std::size_t intervals, std::span<const double> impacts)
{
    return beside_impacts(sample_grid(end, intervals), end / static_cast<double>(intervals), impacts);
}

}  // namespace carom::study
