/// \file
/// The length of a vector whose square may leave the range of doubles.
#pragma once

#include "math/tolerances.hpp"

#include <carom/types.hpp>

#include <cmath>

namespace carom {

/// |a|, the same bits as sqrt(a.a) where no square overflows or underflows.
inline double length(const Vec3& a)
{
    const double square = a.squaredNorm();
    if (square > smallest_safe_square && square < largest_safe_square) return std::sqrt(square);
    const double largest = a.cwiseAbs().maxCoeff();
    if (!(largest > 0)) return largest;
    int exponent = 0;
    std::frexp(largest, &exponent);
    const Vec3 scaled(std::ldexp(a.x(), -exponent), std::ldexp(a.y(), -exponent), std::ldexp(a.z(), -exponent));
    return std::ldexp(std::sqrt(scaled.squaredNorm()), exponent);
}

}  // namespace carom
