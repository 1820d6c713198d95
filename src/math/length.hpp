/// \file
/// The length of a vector whose square may leave the range of doubles.
#pragma once

#include <carom/types.hpp>

#include <cmath>

namespace carom {

/// |a|, the same bits as sqrt(a.a) where no square overflows or underflows.
inline double length(const Vec3& a)
{
    constexpr double small = 0x1p-900, large = 0x1p900;
    const double square = a.squaredNorm();
    if (square > small && square < large) return std::sqrt(square);
    const double largest = a.cwiseAbs().maxCoeff();
    if (!(largest > 0)) return largest;
    int exponent = 0;
    std::frexp(largest, &exponent);
    const Vec3 scaled(std::ldexp(a.x(), -exponent), std::ldexp(a.y(), -exponent), std::ldexp(a.z(), -exponent));
    return std::ldexp(std::sqrt(scaled.squaredNorm()), exponent);
}

}  // namespace carom
