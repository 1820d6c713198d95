#include "motion/series.hpp"

#include "motion/tolerances.hpp"

#include <array>

namespace carom {

namespace {

/// The effect of n bounces, for a first flight of time T1: each bounce scales the flight time by e and the tangential
/// velocity by alpha. All sums are of positive terms, so nothing cancels: time = T1 g, v' = alpha^n v + a T1 d, shift =
/// v T1 p + a T1^2 q.
struct Bounces {
    double e = 1;      ///< e^n
    double alpha = 1;  ///< alpha^n
    double g = 0, d = 0, p = 0, q = 0;
};

/// The effect of `a`, then of `b`.
Bounces followed(const Bounces& a, const Bounces& b)
{
    return {a.e * b.e,
            a.alpha * b.alpha,
            a.g + a.e * b.g,
            b.alpha * a.d + a.e * b.d,
            a.p + a.alpha * a.e * b.p,
            a.q + a.d * a.e * b.p + a.e * a.e * b.q};
}

Bounces all_of_them(double e, double alpha)
{
    const double flights = 1 / (1 - e);
    const double p = 1 / (1 - alpha * e);
    return {
        0, alpha < 1 ? 0.0 : 1.0, flights, alpha < 1 ? 0.0 : flights, p, (alpha * e * p + 0.5) / ((1 - e) * (1 + e))};
}

SeriesState after(const Series& s, const Bounces& n, double rest)
{
    const double t1 = s.first_flight();
    SeriesState state;
    const Vec3 velocity = n.alpha * s.velocity + (t1 * n.d) * s.acceleration;
    const double v = s.normal_speed * n.e;
    state.height = rest * (v - 0.5 * s.gravity * rest);
    state.normal_speed = v - s.gravity * rest;
    state.shift =
        (t1 * n.p) * s.velocity + (t1 * t1 * n.q) * s.acceleration + rest * (velocity + (0.5 * rest) * s.acceleration);
    state.velocity = velocity + rest * s.acceleration;
    if (state.height < 0) state.height = 0;  // rounding at the very end of a flight
    return state;
}

}  // namespace

SeriesState state_in(const Series& s, double tau)
{
    const double t1 = s.first_flight();
    // Powers of the bounce: 1, 2, 4, ... of them, as long as they fit into tau.
    std::array<Bounces, most_doublings> power;
    power[0] = {s.restitution, s.tangential, 1, s.tangential, 1, 0.5};
    int n = 1;
    while (n < most_doublings && t1 * power[n - 1].g <= tau && power[n - 1].e > 0) {
        power[n] = followed(power[n - 1], power[n - 1]);
        ++n;
    }
    Bounces done;
    for (int i = n - 1; i >= 0; --i) {
        const Bounces further = followed(done, power[i]);
        if (t1 * further.g <= tau) done = further;
    }
    return after(s, done, tau - t1 * done.g);
}

SeriesState state_at_end(const Series& s)
{
    SeriesState end = after(s, all_of_them(s.restitution, s.tangential), 0);
    end.height = 0;
    end.normal_speed = 0;
    return end;
}

}  // namespace carom
