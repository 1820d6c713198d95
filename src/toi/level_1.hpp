/// \file
/// Level 1 of a sphere-sphere query: the formulas of level 0 in double-double, and the exact value wherever a sign is
/// open or cancellation has eaten the digits (level 2).
#pragma once

#include "toi/bounded.hpp"
#include "toi/enclosure.hpp"
#include "toi/exact_signs.hpp"
#include "toi/scaling.hpp"
#include "toi/tolerances.hpp"

namespace carom {

/// The exact values of B, C, D in the unit of the query. Lengths were multiplied by 2^-length, speeds by 2^-speed; here
/// they are as they came.
struct ExactSphere {
    static constexpr bool available = true;
    const DoubleDouble3& r;
    const DoubleDouble3& v;
    const DoubleDouble& s;
    int length = 0, speed = 0;

    int exponent_of_b() const { return exact_approach(exact(r), exact(v)).exponent() - length - speed; }
    int exponent_of_c() const { return exact_gap(exact(r), s).exponent() - 2 * length; }
    Bounded b(int more = 0) const { return settled(exact_approach(exact(r), exact(v)), more - length - speed); }
    Bounded c(int more = 0) const { return settled(exact_gap(exact(r), s), more - 2 * length); }
    Bounded d(int more = 0) const
    {
        return settled(exact_discriminant(exact(r), exact(v), s), 2 * (more - length - speed));
    }
};

/// For callers that know their numbers only to within an error: nothing can be settled.
struct NoExactSphere {
    static constexpr bool available = false;
    int exponent_of_b() const { return 0; }
    int exponent_of_c() const { return 0; }
    Bounded b(int = 0) const { return {}; }
    Bounded c(int = 0) const { return {}; }
    Bounded d(int = 0) const { return {}; }
};

/// The query, scaled; each quantity in double-double with its bound.
struct SphereLevel1 {
    DoubleDouble3 r, v;
    DoubleDouble s;
    SphereInputError e;

    Bounded b() const;
    Bounded c() const;
    Bounded d() const;
};

/// The largest relative error that the time formula may have with these values; above 1/4 it is useless.
double time_error(const Bounded& b, const Bounded& c, const Bounded& d, double root, double denominator);

/// In plain double, for values whose bounds are wide: all that is certain if there is an impact at all.
void widest_times(const Bounded& b, const Bounded& c, const Bounded& d, Enclosure<DoubleDouble>& out);

/// Another unit of time. A time beyond the range of doubles is none.
void rescale_time(Enclosure<DoubleDouble>& out, int exponent);

/// \pre the larger of r and S and the largest of v lie within 2^-100 .. 2^100.
template <class Exact>
Enclosure<DoubleDouble> solve_level_1(const SphereLevel1& q, const Exact& exact_values)
{
    Enclosure<DoubleDouble> out;
    out.level = 1;
    const auto none = [&] {
        out.decided = Decision::none;
        return out;
    };
    const auto settle = [&](Bounded& x, double scale, auto&& value) {
        if constexpr (Exact::available) {
            if (!is_blunt(x, scale)) return;
            if (x.open) out.level = 2;
            x = value();
        }
    };

    Bounded b = q.b();
    settle(b, std::abs(b.value.high), [&] { return exact_values.b(); });
    if (b.at_least_zero()) return none();

    Bounded c = q.c();
    settle(c, std::abs(c.value.high), [&] { return exact_values.c(); });
    if (b.is_negative() && c.at_most_zero()) {
        out.decided = Decision::impact;
        return out;
    }

    Bounded d = q.d();
    const double approach = -b.value.high;
    settle(d, std::sqrt(std::abs(d.value.high)) * approach, [&] { return exact_values.d(); });
    if (d.at_most_zero()) return none();  // an exact double root only grazes: the gap never shrinks below 0

    // Small values would underflow: a unit of their own for B and the root of D, which are of one order, and for C.
    int b_shift = 0, c_shift = 0;
    if constexpr (Exact::available) {
        if (approach < own_unit_below) {
            b_shift = -exact_values.exponent_of_b();
            b = exact_values.b(b_shift);
            d = exact_values.d(b_shift);
        }
        if (c.value.high < own_unit_below) {
            c_shift = -exact_values.exponent_of_c();
            c = exact_values.c(c_shift);
        }
    }

    out.decided = b.is_negative() && d.is_positive() ? Decision::impact : Decision::ambiguous;
    const DoubleDouble root = sqrt(d.value), denominator = root - b.value;
    const double relative = time_error(b, c, d, root.high, denominator.high);
    if (out.decided == Decision::impact && c.is_positive() && relative < quotient_holds_within) {
        out.t = c.value / denominator;
        const DoubleDouble width = out.t * DoubleDouble(relative);
        out.t_lo = out.t - width;
        out.t_hi = out.t + (width + width);
    } else {
        widest_times(b, c, d, out);
    }
    if (b_shift != c_shift) rescale_time(out, b_shift - c_shift);
    return out;
}

}  // namespace carom
