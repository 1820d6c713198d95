/// \file
/// A series of bounces on one plane, summed in closed form by the event method, written out bounce by bounce.
#pragma once

#include "study/audit/truth.hpp"

#include <carom/flight.hpp>

#include <vector>

namespace carom::study {

/// Where a series begins: just after the impact that began it.
struct SeriesStart {
    double time = 0;             ///< [time]
    Vec3 place = Vec3::Zero();   ///< of the centre [length]
    Vec3 normal = Vec3::Zero();  ///< unit, out of the plane
};

struct SeriesBounce {
    double time = 0;           ///< [time]
    double closing_speed = 0;  ///< [length/time]
    double speed_change = 0;   ///< |dv| [length/time]
};

struct WrittenSeries {
    std::vector<TruthFlight> flights;
    std::vector<SeriesBounce> bounces;
    bool has_tail = false;  ///< bounces slower than the slowest follow: the last flight stands for them
};

/// The flights of a series, and the bounces between them, from its start to `end`, as long as they leave with
/// `slowest` or more; what follows is a flight along the plane that is not free.
WrittenSeries write_out(const SeriesRecord& series, const SeriesStart& start, double end, double slowest);

}  // namespace carom::study
