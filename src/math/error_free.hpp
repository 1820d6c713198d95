/// \file
/// Error-free transformations: the rounding error of one double operation, as a double.
/// Sources: Knuth (two_sum), Dekker 1971 (fast_two_sum), fma (two_product); Kahan's difference of products, bound 1.5
/// ulp by Jeannerod, Louvet, Muller, Math. Comp. 82 (2013).
#pragma once

#include "math/tolerances.hpp"

#include <cmath>

namespace carom {

/// high + low, |low| <= u |high|; exactly what was summed or multiplied unless an exponent overflows or underflows.
struct Sum {
    double high, low;
};

/// a + b exactly.
inline Sum two_sum(double a, double b)
{
    const double s = a + b, b_part = s - a;
    return {s, (a - (s - b_part)) + (b - b_part)};
}

/// a + b exactly, if |a| >= |b| or a = 0.
inline Sum fast_two_sum(double a, double b)
{
    const double s = a + b;
    return {s, b - (s - a)};
}

/// a b exactly.
inline Sum two_product(double a, double b)
{
    const double p = a * b;
    return {p, std::fma(a, b, -p)};
}

/// a b - c d within 1.5 ulp, whatever cancels.
inline double difference_of_products(double a, double b, double c, double d)
{
    const double cd = c * d;
    const double error = std::fma(-c, d, cd);
    return std::fma(a, b, -cd) + error;
}

}  // namespace carom
