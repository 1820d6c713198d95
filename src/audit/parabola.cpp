#include "audit/parabola.hpp"

#include "audit/tolerances.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace carom::audit {

Damping<double> Pull::over(double duration) const
{
    if (drag == 0) return {1, duration, duration * duration / 2};
    const Damping<double> d = damping(drag, std::abs(duration));
    if (duration >= 0) return d;
    // Backwards, without the cancellation that the formulas have at -t.
    return {1 / d.decay, -d.way / d.decay, (-duration * d.way - d.fall) / d.decay};
}

double Pull::duration_of(double way) const
{
    if (drag == 0) return way;
    return drag * way < 1 ? -std::log1p(-drag * way) / drag : std::numeric_limits<double>::infinity();
}

Vec3 Parabola::place_at(double t) const
{
    return place + displacement(velocity, pull.acceleration, pull.over(t - time));
}

Vec3 Parabola::velocity_at(double t) const
{
    return velocity_after(velocity, pull.acceleration, pull.over(t - time));
}

double Parabola::error_at(double t) const
{
    return place_error + std::abs(pull.over(t - time).way - pull.over(middle - time).way) * velocity_error;
}

double Parabola::bend(double from, double to) const
{
    const double g = pull.acceleration.norm();
    return g + pull.drag * (velocity_at(std::min(from, to)).norm() + g * std::abs(to - from));
}

std::optional<Parabola> fitted(std::span<const Sighting> sightings, const Pull& pull, double time_error)
{
    const std::size_t n = sightings.size();
    Parabola p;
    p.time = sightings.back().time;
    p.pull = pull;
    // Without its curve the flight is a line in the ways of `Damping`, counted from the last sighting.
    std::array<Vec3, fitted_frames> line;
    std::array<double, fitted_frames> ways{};
    double mean = 0;
    Vec3 centre = Vec3::Zero();
    for (std::size_t k = 0; k < n; ++k) {
        const Damping<double> d = pull.over(sightings[k].time - p.time);
        ways[k] = d.way;
        line[k] = sightings[k].place - d.fall * pull.acceleration;
        mean += d.way / static_cast<double>(n);
        centre += line[k] / static_cast<double>(n);
        p.place_error = std::max(p.place_error, sightings[k].error);
    }
    double spread = 0, lever = 0;
    for (std::size_t k = 0; k < n; ++k) {
        const double s = ways[k] - mean;
        spread += s * s;
        lever += std::abs(s);
        p.velocity += s * line[k];
    }
    p.velocity /= spread;
    p.place = centre - mean * p.velocity;
    p.middle = p.time + pull.duration_of(mean);
    const double fastest = p.velocity.norm() * pull.over(sightings[0].time - p.time).decay;
    p.place_error += time_error * (fastest + std::abs(mean) * pull.acceleration.norm());
    p.velocity_error = p.place_error * lever / spread;
    if (n < fitted_frames) return p;
    const double part = (ways[1] - ways[0]) / (ways[2] - ways[0]);
    const double off = (line[1] - (1 - part) * line[0] - part * line[2]).norm();
    return off <= 2 * p.place_error ? std::optional(p) : std::nullopt;
}

Bend bend_of(std::span<const Sighting> sightings, const Pull& pull, double time_error)
{
    const double first = sightings[1].time - sightings[0].time, second = sightings[2].time - sightings[1].time;
    const Vec3 way = sightings[2].place - sightings[0].place;
    const double speed = way.norm() / (first + second);
    const double error = sightings[0].error + sightings[1].error + sightings[2].error + 3 * time_error * speed;
    const double pulled = (pull.acceleration - pull.drag / (first + second) * way).norm();
    const double bent = pulled * first * second / 2;  // height of the middle one over the chord of the others
    if (bent <= 2 * error) return Bend::hidden;
    const double part = first / (first + second);
    const Vec3 off = sightings[1].place - sightings[0].place - part * way;
    return off.norm() <= error && way.norm() > error ? Bend::straight : Bend::shown;
}

Parabola given_at(Parabola flight, double time)
{
    const Parabola as_it_is = flight;
    flight.place = as_it_is.place_at(time);
    flight.velocity = as_it_is.velocity_at(time);
    flight.velocity_error = as_it_is.velocity_error_at(time);
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
    p.pull = {a.pull.acceleration - b.pull.acceleration, a.pull.drag};
    p.middle = a.time;
    p.place_error = a.error_at(a.time) + b.error_at(a.time);
    p.velocity_error = a.velocity_error + b.velocity_error_at(a.time);
    return p;
}

namespace {

/// Two flights under one pull, at the time at which the second is given: one apart from the other.
struct Apart {
    Vec3 place = Vec3::Zero(), velocity = Vec3::Zero();  ///< of the second, less those of the first
    double place_error = 0, velocity_error = 0;
};

Apart apart(const Parabola& before, const Parabola& after)
{
    const double t = after.time;
    return {after.place - before.place_at(t), after.velocity - before.velocity_at(t),
            before.error_at(t) + after.error_at(t), before.velocity_error_at(t) + after.velocity_error};
}

}  // namespace

bool is_same(const Parabola& before, const Parabola& after)
{
    const Apart a = apart(before, after);
    return a.place.norm() <= a.place_error && a.velocity.norm() <= a.velocity_error;
}

bool is_displaced(const Parabola& before, const Parabola& after, double duration)
{
    const Apart a = apart(before, after);
    const double hidden = std::abs(after.pull.over(-duration).way) * a.velocity_error;
    return a.velocity.norm() <= a.velocity_error && a.place.norm() > a.place_error + hidden;
}

std::optional<Turn> turn_between(const Parabola& before, const Parabola& after)
{
    const Apart a = apart(before, after);
    const double size = a.velocity.norm();
    if (size <= a.velocity_error) return std::nullopt;
    // Under one pull flights part on a line in the way of `Damping`: so much way ago they were nearest.
    const double ago = a.place.dot(a.velocity) / (size * size);
    const double found = after.pull.duration_of(-ago);
    const double since = std::isfinite(found) ? found : -ago;  // never: as late as without drag, which no contact is
    const double error = a.place_error + std::abs(ago) * a.velocity_error;
    const double decay = std::min(1.0, after.pull.over(since).decay);
    Turn turn;
    turn.time = after.time + since;
    turn.change = after.velocity_at(turn.time) - before.velocity_at(turn.time);
    turn.error = decay > 0 ? error / size / decay : std::numeric_limits<double>::max();
    turn.is_single = (a.place - ago * a.velocity).norm() <= error;
    return turn;
}

}  // namespace carom::audit
