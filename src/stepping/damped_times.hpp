/// \file
/// Motion under gravity and linear drag, dv/dt = a - k v, in closed form: with s = (1 - exp(-k t)) / k and
/// q = (t - s) / k the way in the time t is v s + a q and the change of velocity s (a - k v). Without drag s = t and
/// q = t^2 / 2.
#pragma once

#include <carom/types.hpp>

namespace carom::stepping {

/// Worth of a time to a velocity and to an acceleration.
struct DampedTimes {
    double s = 0;  ///< [time]
    double q = 0;  ///< [time^2]
};

/// To rounding, for every k t: nothing is lost where it is small. \param drag k >= 0 [1/time] \param time below 0: back
/// in time
DampedTimes damped_times(double drag, double time);

/// Where the motion from place p, with velocity v and acceleration a there, is after these times [length].
inline Vec3 place_after(const DampedTimes& times, const Vec3& p, const Vec3& v, const Vec3& a)
{
    return p + times.s * v + times.q * a;
}

/// Its velocity then [length/time].
inline Vec3 velocity_after(const DampedTimes& times, double drag, const Vec3& v, const Vec3& a)
{
    return drag == 0 ? Vec3(v + times.s * a) : Vec3(v + times.s * (a - drag * v));
}

}  // namespace carom::stepping
