#include "event_driven/state.hpp"

#include "math/double_double.hpp"

namespace carom {

namespace {

/// What a place lacks of the position that it was made from.
Vec3 lost_by(const Frame& frame, const Place& place, const Vec3& position)
{
    Vec3 low;
    for (int k = 0; k < 3; ++k) {
        const double cells = static_cast<double>(place.cell[k]) * frame.cell_size;
        low[k] = static_cast<double>(DoubleDouble(two_sum(position[k], -cells)) - DoubleDouble(place.local[k]));
    }
    return low;
}

}  // namespace

State::State(const Scene& s, bool certified)
    : scene(s),
      frame(make_frame(s)),
      accelerations(s),
      laws(s),
      rest(rest_thresholds(s)),
      stamps(s.spheres.size(), 0),
      recent(frame, rest.window, s.spheres.size()),
      loses_energy(laws.lose_energy()),
      rebound_gap(
          loses_energy && s.rest.policy == RestPolicy::contact && !certified ? rest.closing_speed * rest.window / 4 : 0)
{
    flights.reserve(s.spheres.size());
    radii.reserve(s.spheres.size());
    for (const auto& sphere : s.spheres) {
        radii.push_back(sphere.radius);
        flights.push_back(
            {{0, 0}, place_at(frame, sphere.position), sphere.velocity, accelerations.free(), -1, Mode::flying});
        if (certified) low.push_back(lost_by(frame, flights.back().place, sphere.position));
        if (!sphere.fixed) continue;
        flights.back().velocity = Vec3::Zero();
        flights.back().acceleration = Accelerations::none;
        flights.back().mode = Mode::fixed;
    }
}

}  // namespace carom
