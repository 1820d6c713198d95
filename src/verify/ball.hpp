/// \file
/// A body as pairs see it: a sphere on its flight, or the ball that a series stays in.
#pragma once

#include "verify/bounces.hpp"
#include "verify/flights.hpp"
#include "verify/run_data.hpp"

namespace carom::verification {

struct Ball {
    Path path;
    Vec3 acceleration;  ///< [cells/epoch^2]
    double radius;      ///< [cells]
    bool is_swept;
};

inline Ball ball_of(const RunData& data, const Flights& flights, BodyId body)
{
    const Path path = flights.path(body);
    if (path.mode != Mode::series) return {path, data.acceleration(path), data.radius(body), false};
    const Wall& wall = data.wall(path.support);
    const Swept all = swept(path, data.radius(body), flights.series.at(body), side_of(wall, path) * wall.normal);
    return {all.path, data.acceleration(all.path), all.radius, true};
}

}  // namespace carom::verification
