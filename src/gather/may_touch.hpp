/// \file
/// Spheres near each other, before contacts are measured.
#pragma once

#include "gather/tolerances.hpp"
#include "motion/state.hpp"

#include <span>

namespace carom {

/// Surroundings of a body, as the schedule of the run knows it.
class Neighbourhood {
public:
    /// Every sphere that may touch this one now; valid until the next call.
    virtual std::span<const BodyId> operator()(BodyId body) const = 0;
    /// A quick answer: whether certainly no contact of the body but that with `partner` is closed now; false where it
    /// takes more to know.
    virtual bool is_alone(BodyId body, Partner partner, const EpochTime& now) const = 0;

protected:
    ~Neighbourhood() = default;
};

/// may_touch for spheres whose centres are r apart now.
inline bool is_near(const State& state, BodyId body, BodyId other, const Vec3& r, double margin)
{
    const double square = r.squaredNorm(), reach = state.radius(body) + state.radius(other) + margin,
                 in_pieces = look_slack_in_pieces * reach, elsewhere = look_slack * reach;
    if (square > in_pieces * in_pieces) return false;  // nearly all
    return square <= elsewhere * elsewhere || state.bodies.is_in_piece(other) || state.bodies.is_in_piece(body);
}

/// may_touch of a sphere whose motion is damped, as all are then.
bool damped_may_touch(const State& state, BodyId body, const Flight& now, BodyId other, double margin);

/// Whether the surfaces of `body` and `other` may be less than `margin` apart [length]; true of some that are not.
/// \param now the flight of `body` as if it began at this moment
inline bool may_touch(const State& state, BodyId body, const Flight& now, BodyId other, double margin)
{
    if (state.drag > 0) [[unlikely]]
        return damped_may_touch(state, body, now, other, margin);
    if (state.bodies.kind(other) == MotionKind::bouncing) return true;
    const Flight& f = state.flight(other);
    const double dt = state.frame.between(f.start, now.start);
    Vec3 r = separation(state.frame, now.place, f.place) - dt * f.velocity;
    if (f.acceleration != Accelerations::none) r -= (0.5 * dt * dt) * state.acceleration(f);
    return is_near(state, body, other, r, margin);
}

}  // namespace carom
