#include "event_driven/state.hpp"

namespace carom {

State::State(const Scene& s)
    : scene(s), frame(make_frame(s)), accelerations(s), laws(s), rest(rest_thresholds(s)), stamps(s.spheres.size(), 0)
{
    flights.reserve(s.spheres.size());
    radii.reserve(s.spheres.size());
    for (const auto& sphere : s.spheres) {
        radii.push_back(sphere.radius);
        flights.push_back(
            {{0, 0}, place_at(frame, sphere.position), sphere.velocity, accelerations.free(), -1, Mode::flying});
        if (!sphere.fixed) continue;
        flights.back().velocity = Vec3::Zero();
        flights.back().acceleration = Accelerations::none;
        flights.back().mode = Mode::fixed;
    }
}

}  // namespace carom
