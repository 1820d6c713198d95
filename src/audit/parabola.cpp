#include "audit/parabola.hpp"

#include "audit/tolerances.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace carom::audit {

Vec3 Parabola::place_at(double t) const
{
    const double s = t - time;
    return place + s * velocity + (s * s / 2) * acceleration;
}

std::optional<Parabola> fitted(std::span<const Sighting> sightings, const Vec3& acceleration, double time_error)
{
    const std::size_t n = sightings.size();
    Parabola p;
    p.time = sightings.back().time;
    p.acceleration = acceleration;
    // Without its curve the flight is a line, times counted from the last sighting.
    std::array<Vec3, fitted_frames> line;
    double mean = 0;
    Vec3 centre = Vec3::Zero();
    for (std::size_t k = 0; k < n; ++k) {
        const double s = sightings[k].time - p.time;
        line[k] = sightings[k].place - (s * s / 2) * acceleration;
        mean += s / static_cast<double>(n);
        centre += line[k] / static_cast<double>(n);
        p.place_error = std::max(p.place_error, sightings[k].error);
    }
    double spread = 0, lever = 0;
    for (std::size_t k = 0; k < n; ++k) {
        const double s = sightings[k].time - p.time - mean;
        spread += s * s;
        lever += std::abs(s);
        p.velocity += s * line[k];
    }
    p.velocity /= spread;
    p.place = centre - mean * p.velocity;
    p.middle = p.time + mean;
    p.place_error += time_error * (p.velocity.norm() + std::abs(mean) * acceleration.norm());
    p.velocity_error = p.place_error * lever / spread;
    if (n < fitted_frames) return p;
    const double part = (sightings[1].time - sightings[0].time) / (sightings[2].time - sightings[0].time);
    const double off = (line[1] - (1 - part) * line[0] - part * line[2]).norm();
    return off <= 2 * p.place_error ? std::optional(p) : std::nullopt;
}

Parabola given_at(Parabola flight, double time)
{
    flight.place = flight.place_at(time);
    flight.velocity = flight.velocity_at(time);
    flight.time = time;
    return flight;
}

Parabola standing(const Vec3& place)
{
    Parabola p;
    p.place = place;
    return p;
}

Parabola relative(const Parabola& a, const Parabola& b)
{
    Parabola p;
    p.time = a.time;
    p.place = a.place - b.place_at(a.time);
    p.velocity = a.velocity - b.velocity_at(a.time);
    p.acceleration = a.acceleration - b.acceleration;
    p.middle = a.time;
    p.place_error = a.error_at(a.time) + b.error_at(a.time);
    p.velocity_error = a.velocity_error + b.velocity_error;
    return p;
}

bool is_same(const Parabola& before, const Parabola& after)
{
    const double t = after.time;
    return (after.place - before.place_at(t)).norm() <= before.error_at(t) + after.error_at(t) &&
           (after.velocity - before.velocity_at(t)).norm() <= before.velocity_error + after.velocity_error;
}

std::optional<Turn> turn_between(const Parabola& before, const Parabola& after)
{
    const double t = after.time;
    const Vec3 apart = after.place - before.place_at(t), change = after.velocity - before.velocity_at(t);
    const double place_error = before.error_at(t) + after.error_at(t);
    const double velocity_error = before.velocity_error + after.velocity_error;
    const double size = change.norm();
    if (size <= velocity_error) return std::nullopt;
    const double ago = apart.dot(change) / (size * size);
    Turn turn{change, t - ago, (place_error + std::abs(ago) * velocity_error) / size, false};
    turn.is_single = (apart - ago * change).norm() <= place_error + std::abs(ago) * velocity_error;
    return turn;
}

}  // namespace carom::audit
