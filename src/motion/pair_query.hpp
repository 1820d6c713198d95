/// \file
/// The time at which two spheres in free flight touch, for certified runs: in double-double and, on demand, exactly.
#pragma once

#include "motion/relative.hpp"
#include "toi/level_1.hpp"

namespace carom {

/// Two spheres in uniform relative motion from the later of their starts.
class PairQuery {
public:
    PairQuery(const State& state, const Flight& a, BodyId id_a, const Flight& b, BodyId id_b)
        : state_(state), a_(a), b_(b), s_(two_sum(state.radius(id_a), state.radius(id_b)))
    {
        const Relative<DoubleDouble> motion = relative_motion<DoubleDouble>(state, a, b);
        from = motion.from;
        r_ = as_vector(motion.r);
        v_ = as_vector(motion.v);
        error_.r = double_double_error * (largest(r_) + state.frame.cell_size);
        if (a.start == b.start) return;
        const Flight& older = a.start < b.start ? a : b;
        const double t = state.frame.between(older.start, from);
        const double speed = largest(older.velocity) + t * largest(state.acceleration(older));
        error_.r += double_double_error * 2 * t * speed;
        error_.v = double_double_error * (largest(v_) + speed);
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

    /// The answer for flights of one start that are roundings themselves. \param error of the flights, beside that of
    /// the arithmetic
    Enclosure<DoubleDouble> enclose_rounded(const SphereInputError& error) const
    {
        return carom::enclose(r_, v_, s_, error);
    }

    /// Depth of the overlap at `from`, 0 where the exact gap is >= 0 [length].
    double overlap() const
    {
        const DoubleDouble r2 = dot(r_, r_), s2 = s_ * s_;
        Bounded c{r2 - s2, double_double_error * (r2.high + s2.high)};
        if (c.open) c.sign = exact_gap(exact_r(), Dyadic(s_)).sign();
        return c.sign >= 0 ? 0 : -c.value.high / (2 * s_.high);
    }

    /// The exact sign of d|r|/dt at `from`. \pre one start
    int approach_sign() const
    {
        const Vec3 v = a_.velocity - b_.velocity;
        const double p[3] = {r_.x.high * v.x(), r_.y.high * v.y(), r_.z.high * v.z()};
        const double sum = p[0] + p[1] + p[2], scale = std::abs(p[0]) + std::abs(p[1]) + std::abs(p[2]);
        // v is rounded once, and so may be far from a difference that nearly cancels: its own scale counts, too.
        if (std::abs(sum) > approach_rounding * (scale + largest(r_) * (largest(a_.velocity) + largest(b_.velocity))))
            return sum < 0 ? -1 : 1;
        return exact_approach(exact_r(), exact_v()).sign();
    }

    EpochTime from{};

private:
    /// Exact values for solve_level_1, as those of ExactSphere in toi/level_1.hpp.
    struct Exactly {
        static constexpr bool available = true;
        const PairQuery& pair;
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

    Dyadic3 exact_r() const { return as_vector(relative_motion<Dyadic>(state_, a_, b_).r); }
    Dyadic3 exact_v() const { return as_vector(relative_motion<Dyadic>(state_, a_, b_).v); }

    const State& state_;
    const Flight &a_, &b_;
    DoubleDouble s_;
    DoubleDouble3 r_, v_;
    SphereInputError error_;
};

}  // namespace carom
