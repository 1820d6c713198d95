/// \file
/// Height, rate and acceleration in units in which their products neither overflow nor underflow, and the discriminant
/// made of them.
#pragma once

#include "toi/bounded.hpp"
#include "toi/scaling.hpp"
#include "toi/tolerances.hpp"

#include <limits>

namespace carom {

/// Relative error of one operation, at most.
template <class Number>
inline constexpr double operation_error = double_operation_error;
template <>
inline constexpr double operation_error<DoubleDouble> = double_double_operation_error;

inline double scaled(double x, int exponent)
{
    return std::ldexp(x, exponent);
}
inline double root_of(double x)
{
    return x > 0 ? std::sqrt(x) : 0;
}
inline DoubleDouble root_of(DoubleDouble x)
{
    return sqrt(x);
}
inline double difference_with_square(double h, double w, double g)
{
    return difference_of_products(w, w, 2 * g, h);
}
inline DoubleDouble difference_with_square(DoubleDouble h, DoubleDouble w, DoubleDouble g)
{
    return w * w - (DoubleDouble(2) * g) * h;
}

template <class Number>
struct PlaneNumbers {
    BoundedNumber<Number> h, w, g;
    BoundedNumber<Number> pull;  ///< -g in a unit of its own: beside a large w it may underflow as g
    int time = 0;                ///< 2^time is the unit of time of h, w, g
    int pull_time = 0;           ///< that of a speed divided by `pull`
    int speed_shift = 0;         ///< speeds are multiplied by 2^speed_shift
};

inline bool is_moderate_or_zero(double x)
{
    return x == 0 || is_moderate(x);
}

inline int floor_half(int x)
{
    return x >= 0 ? x / 2 : -((1 - x) / 2);
}

/// Heights of order 1, and a time in which the larger of w and g is of order 1.
template <class Number>
PlaneNumbers<Number> plane_numbers(const BoundedNumber<Number>& h, const BoundedNumber<Number>& w,
                                   const BoundedNumber<Number>& g)
{
    const double sizes[3] = {h.size(), w.size(), g.size()};
    if (is_moderate_or_zero(sizes[0]) && is_moderate_or_zero(sizes[1]) && is_moderate_or_zero(sizes[2])) {
        BoundedNumber<Number> pull = g;
        pull.value = -g.value;
        return {h, w, g, pull, 0, 0, 0};
    }
    // From h = 0 the only length is that of the way to the apex.
    const int length = sizes[0] > 0   ? exponent_of(sizes[0])
                       : sizes[2] > 0 ? 2 * exponent_of(sizes[1]) - exponent_of(sizes[2])
                                      : exponent_of(sizes[1]);
    int time = std::numeric_limits<int>::max();
    if (sizes[1] > 0) time = length - exponent_of(sizes[1]);
    if (sizes[2] > 0) time = std::min(time, floor_half(length - exponent_of(sizes[2])));
    const auto in_units = [](const BoundedNumber<Number>& x, int shift) {
        BoundedNumber<Number> out = x;
        out.value = scaled(x.value, shift);
        out.error = std::ldexp(x.error, shift) + plane_underflow;
        return out;
    };
    const int own = exponent_of(sizes[2]);
    PlaneNumbers<Number> n{in_units(h, -length),
                           in_units(w, time - length),
                           in_units(g, 2 * time - length),
                           in_units(g, -own),
                           time,
                           length - time - own,
                           time - length};
    n.pull.value = -n.pull.value;
    return n;
}

/// w^2 - 2 g h. Each product carries two roundings, the difference one more.
template <class Number>
BoundedNumber<Number> plane_discriminant(const PlaneNumbers<Number>& n)
{
    const double h = std::abs(head(n.h.value)), w = std::abs(head(n.w.value)), g = std::abs(head(n.g.value));
    const double rounding = plane_d_operations * operation_error<Number> * (w * w + 2 * g * h);
    const double input = (2 * w + n.w.error) * n.w.error + 2 * (g * n.h.error + (h + n.h.error) * n.g.error);
    return {difference_with_square(n.h.value, n.w.value, n.g.value), rounding + padded(input)};
}

/// Relative error of |w| + sqrt(D) = `sum`; at least 1 where the bounds are too wide for the formula.
template <class Number>
double sum_error(const BoundedNumber<Number>& w, const BoundedNumber<Number>& d, double sum)
{
    if (!(head(d.value) >= quotient_holds_from * d.error) || !(sum > 0)) return 1;
    const double root = std::sqrt(head(d.value));
    return (w.error + (root > 0 ? d.error / root : 0)) / sum;
}

template <class Number>
double upper_root(const BoundedNumber<Number>& d)
{
    return std::sqrt(std::max(head(d.value), 0.0) + 2 * d.error);
}
template <class Number>
double lower_root(const BoundedNumber<Number>& d)
{
    return std::sqrt(std::max(head(d.value) - 2 * d.error, 0.0));
}

}  // namespace carom
