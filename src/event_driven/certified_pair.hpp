/// \file
/// When two spheres in free flight touch, for certified runs.
#pragma once

#include "event_driven/certified_place.hpp"
#include "event_driven/certified_time.hpp"

namespace carom {

/// Two spheres in uniform relative motion from the later of their starts, in double-double and, on demand, exactly.
class PairFromLaterStart {
public:
    PairFromLaterStart(const State& state, BodyId a, BodyId b)
        : state_(state), a_(at_start(state, a)), b_(at_start(state, b)), s_(two_sum(state.radius(a), state.radius(b)))
    {
        a_is_older_ = a_.flight.start < b_.flight.start;
        from = std::max(a_.flight.start, b_.flight.start);
        const Flown& older = a_is_older_ ? a_ : b_;
        const DoubleDouble dt = lifted_between(state.frame, older.flight.start, from);
        const Vec3& g = state.accelerations[older.flight.acceleration];
        r_ = lifted_separation(state.frame, a_, b_);
        v_ = {two_sum(a_.flight.velocity.x(), -b_.flight.velocity.x()),
              two_sum(a_.flight.velocity.y(), -b_.flight.velocity.y()),
              two_sum(a_.flight.velocity.z(), -b_.flight.velocity.z())};
        const double t = dt.high;
        error_.r = dd_error * (largest(r_) + state.frame.cell_size);
        if (t == 0) return;
        const DoubleDouble half = dt * DoubleDouble(0.5);
        const auto moved_by = [&](double v0, double acceleration) {
            return dt * (DoubleDouble(v0) + half * DoubleDouble(acceleration));
        };
        const Vec3& v0 = older.flight.velocity;
        const DoubleDouble3 shift{moved_by(v0.x(), g.x()), moved_by(v0.y(), g.y()), moved_by(v0.z(), g.z())};
        const DoubleDouble3 gain{dt * DoubleDouble(g.x()), dt * DoubleDouble(g.y()), dt * DoubleDouble(g.z())};
        r_ = a_is_older_ ? r_ + shift : r_ - shift;
        v_ = a_is_older_ ? v_ + gain : v_ - gain;
        const double speed = largest(v0) + t * largest(g);
        error_.r += dd_error * (largest(r_) + t * speed);
        error_.v = dd_error * (largest(v_) + speed);
    }

    Enclosure<DoubleDouble> enclose() const
    {
        const double length = std::max({largest(r_), s_.high, error_.r}), speed = std::max(largest(v_), error_.v);
        Enclosure<DoubleDouble> out;
        if (!(speed > 0)) return out;
        const bool moderate = is_moderate(length) && is_moderate(speed);
        const int l = moderate ? 0 : exponent_of(length), w = moderate ? 0 : exponent_of(speed);
        const SphereLevel1 query{
            scaled(r_, -l), scaled(v_, -w), scaled(s_, -l), {std::ldexp(error_.r, -l), std::ldexp(error_.v, -w), 0}};
        out = solve_level_1(query, Exactly{*this, l, w});
        if (l != w) rescale_time(out, l - w);
        return out;
    }

    EpochTime from;

private:
    /// See ExactSphere of toi/level_1.hpp.
    struct Exactly {
        static constexpr bool available = true;
        const PairFromLaterStart& pair;
        int length, speed;

        Dyadic approach() const { return exact_approach(pair.exact_r(), pair.exact_v()); }
        Dyadic gap() const { return exact_gap(pair.exact_r(), Dyadic(pair.s_)); }
        Dyadic discriminant() const { return exact_discriminant(pair.exact_r(), pair.exact_v(), Dyadic(pair.s_)); }
        int exponent_of_b() const { return approach().exponent() - length - speed; }
        int exponent_of_c() const { return gap().exponent() - 2 * length; }
        Bounded b(int more = 0) const { return settled(approach(), more - length - speed); }
        Bounded c(int more = 0) const { return settled(gap(), more - 2 * length); }
        Bounded d(int more = 0) const { return settled(discriminant(), 2 * (more - length - speed)); }
    };

    Dyadic3 exact_r() const
    {
        const Flown& older = a_is_older_ ? a_ : b_;
        const Dyadic dt = exact_between(state_.frame, older.flight.start, from);
        const Dyadic half = dt * Dyadic(0.5);
        const Vec3 &g = state_.accelerations[older.flight.acceleration], &v0 = older.flight.velocity;
        const auto moved_by = [&](int k) { return dt * (Dyadic(v0[k]) + half * Dyadic(g[k])); };
        const Dyadic3 r = exact_separation(state_.frame, a_, b_);
        return a_is_older_ ? Dyadic3{r.x + moved_by(0), r.y + moved_by(1), r.z + moved_by(2)}
                           : Dyadic3{r.x - moved_by(0), r.y - moved_by(1), r.z - moved_by(2)};
    }
    Dyadic3 exact_v() const
    {
        const Flown& older = a_is_older_ ? a_ : b_;
        const Dyadic dt = exact_between(state_.frame, older.flight.start, from);
        const Vec3& g = state_.accelerations[older.flight.acceleration];
        const Dyadic3 v = exact_difference(a_.flight.velocity, b_.flight.velocity);
        return a_is_older_ ? Dyadic3{v.x + dt * Dyadic(g.x()), v.y + dt * Dyadic(g.y()), v.z + dt * Dyadic(g.z())}
                           : Dyadic3{v.x - dt * Dyadic(g.x()), v.y - dt * Dyadic(g.y()), v.z - dt * Dyadic(g.z())};
    }

    const State& state_;
    Flown a_, b_;
    bool a_is_older_ = false;
    DoubleDouble s_;
    DoubleDouble3 r_, v_;
    SphereInputError error_;
};

}  // namespace carom
