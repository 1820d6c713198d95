/// \file
/// How a sphere on one plane stops bouncing: at rest by arithmetic, or by the closed sum of a Zeno series.
#pragma once

#include "gather/may_touch.hpp"
#include "hold/tolerances.hpp"
#include "queue/key.hpp"

#include <cmath>
#include <optional>

namespace carom {

/// Is a sphere that leaves a plane with normal speed w in fact in persistent contact? True where the next bounce would
/// be lower than the rounding of its own position, and where nothing presses and nothing of the speed is left.
/// \param scale radius + cell size, which its position rounds to [length] \param gravity towards the plane
/// [length/time^2]
inline bool is_rest(double scale, const Vec3& velocity, double w, double gravity)
{
    // w^2/g, in an order that stays within doubles however weak gravity is.
    if (gravity > 0) return w * (w / gravity) <= 2 * rest_height * scale;
    if (gravity < 0) return false;
    return w <= no_normal_speed * std::sqrt(velocity.squaredNorm());
}

/// Is the next bounce one of those that are summed in closed form, not events of their own? (Under drag they are
/// events: see `damped_bounces`.)
inline bool is_low(const State& state, BodyId body, double w, double gravity, const ContactLaw& law)
{
    return gravity > 0 && (law.restitution < 1 || state.drag > 0) && state.scene.rest.policy != RestPolicy::micro &&
           w * (w / gravity) < 2 * state.scene.rest.series_below * state.radius(body);
}

/// How low bounces on a plane go on under drag, which leaves them no closed sum: until rounding ends them, or a
/// threshold because too many are to come.
struct DampedBounces {
    /// They end by themselves, and nothing else is near: the guard leaves them alone.
    bool die_out = false;
    /// Time by which a threshold ends them early at most, if one does [time].
    std::optional<double> early{};
};
/// \param flight of the sphere after a low bounce, which leaves with normal speed w
DampedBounces damped_bounces(const State& state, const Key& key, const Flight& flight, double w, double gravity,
                             const ContactLaw& law, const Neighbourhood& neighbourhood);

/// The series that begins with normal speed w.
Series make_series(const State& state, const Flight& flight, int plane, double w, double gravity,
                   const ContactLaw& law);

/// Does nothing else meet the ball that the series sweeps before it ends?
bool series_is_clear(const State& state, BodyId body, const Flight& flight, const Bouncing& bouncing,
                     const Neighbourhood& neighbourhood);

}  // namespace carom
