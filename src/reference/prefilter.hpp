/// \file
/// Pairs that cannot meet, told in double with margins far above its rounding. It only ever saves work.
#pragma once

#include <carom/types.hpp>

#include "reference/damping.hpp"

#include <Eigen/Geometry>
#include <cmath>

namespace carom::reference {

/// A flight rounded to double.
struct Shadow {
    double t = 0, radius = 0;
    Vec3 x = Vec3::Zero(), v = Vec3::Zero(), a = Vec3::Zero();
    double wander = 0;  ///< how far from that parabola it may be in its step [length]
    double drag = 0;    ///< of the flight [1/time]

    /// Acceleration once it has this velocity; it fades from there [length/time^2].
    Vec3 fading(const Vec3& velocity) const { return a - drag * velocity; }
};

/// Relative motion of two spheres from `now` on, with bounds for what rounding did to it.
struct Approach {
    Vec3 r, v, acceleration;
    double sum, wander, slack, v_slack;

    Approach(const Shadow& a, const Shadow& b, double now)
        : acceleration(a.a - b.a), sum(a.radius + b.radius), wander(a.wander + b.wander)
    {
        const Damped<double> da = damped(a.drag, now - a.t), db = damped(b.drag, now - b.t);
        const Vec3 xa = a.x + a.v * da.s + a.a * da.q, xb = b.x + b.v * db.s + b.a * db.q;
        const Vec3 va = a.v + a.fading(a.v) * da.s, vb = b.v + b.fading(b.v) * db.s;
        r = xa - xb;
        v = va - vb;
        // With one drag the way is v s + acceleration q, shorter than without it; a polynomial has what drag makes of
        // it.
        if (a.drag != b.drag) acceleration = a.fading(va).cwiseAbs() + b.fading(vb).cwiseAbs();
        v_slack = shadow_error * (size(va) + size(vb) + (size(a.a) + size(b.a)) * now);
        slack = shadow_error * (size(xa) + size(xb) + sum) + v_slack * now + wander;
    }

    bool apart(double gap) const { return distance() - slack > (sum + gap) * outside; }

    /// True if the surfaces certainly do not meet within `horizon`: too far, receding, or passing by.
    bool misses(double horizon) const
    {
        const double far = distance(), error = errors_a_product * (slack * size(v) + v_slack * size(r)) + underflow;
        const double speed = size(v) + v_slack + size(acceleration) * horizon / 2;
        if (far - sum * outside - slack > speed * horizon * longer) return true;
        if (acceleration != Vec3::Zero() || wander > 0) return false;  // what follows is about straight lines
        if (r.dot(v) > error) return true;
        const double moment = r.cross(v).stableNorm();
        return std::isfinite(moment) && moment - error > sum * (v.stableNorm() + v_slack) * outside;
    }

private:
    /// Between |v| and sqrt(3) |v|.
    static double size(const Vec3& v) { return v.lpNorm<1>(); }
    /// |r|, or 0 where its square leaves the range of double.
    double distance() const
    {
        const double square = r.squaredNorm();
        return square > least_square && square < 1 / least_square ? std::sqrt(square) : 0;
    }
};

}  // namespace carom::reference
