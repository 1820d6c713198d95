#include "study/audit/series.hpp"

namespace carom::study {

WrittenSeries write_out(const SeriesRecord& series, const SeriesStart& start, double end, double slowest)
{
    WrittenSeries written;
    double time = start.time, speed = series.normal_speed;
    Vec3 place = start.place, along = series.velocity;
    // Ends: speeds shrink by restitution < 1, and a flight that time cannot resolve ends it too.
    while (speed >= slowest && time < end) {
        written.flights.push_back(
            {time, place, along + speed * start.normal, series.acceleration - series.gravity * start.normal, true});
        const double flight = 2 * speed / series.gravity;
        if (!(time + flight > time) || time + flight >= end) return written;
        time += flight;
        place += flight * (along + (flight / 2) * series.acceleration);
        const Vec3 before = along + flight * series.acceleration - speed * start.normal;
        const double closing = speed;
        along = series.tangential * (along + flight * series.acceleration);
        speed *= series.restitution;
        written.bounces.push_back({time, closing, (along + speed * start.normal - before).norm()});
    }
    if (time < end) {
        written.flights.push_back({time, place, along, series.acceleration, false});
        written.has_tail = true;
    }
    return written;
}

}  // namespace carom::study
