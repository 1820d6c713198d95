/// \file
/// Exact numbers: whatever sums and products of doubles give, without rounding, overflow or underflow.
///
/// A dyadic rational, an integer times a power of two. It does what Shewchuk's floating-point expansions do (Discrete
/// Comput. Geom. 18 (1997)), and needs no range: the square of 1e-200 and the product of two subnormals are exact, too.
/// For signs that double-double cannot tell. A sum or product of short numbers takes some 50 ns.
#pragma once

#include "math/double_double.hpp"

#include <cstdint>
#include <vector>

namespace carom {

class Dyadic {
public:
    Dyadic() = default;  ///< 0
    /// \pre finite
    Dyadic(double value);        // NOLINT: every double is a dyadic rational
    Dyadic(DoubleDouble value);  // NOLINT
    explicit Dyadic(std::int64_t value);

    /// The sign, -1, 0 or 1: always right.
    int sign() const { return sign_; }

    /// The value times 2^shift, to 2^-104 of itself; infinite beyond the range of doubles.
    DoubleDouble rounded(int shift = 0) const;

    /// Exponent e with 2^(e-1) <= |value| < 2^e, as frexp has it; 0 for 0.
    int exponent() const;

    Dyadic operator-() const;
    friend Dyadic operator+(const Dyadic& a, const Dyadic& b);
    friend Dyadic operator-(const Dyadic& a, const Dyadic& b) { return a + (-b); }
    friend Dyadic operator*(const Dyadic& a, const Dyadic& b);

private:
    using Limbs = std::vector<std::uint32_t>;

    Dyadic(int sign, Limbs limbs, std::int64_t exponent);
    static Limbs sum(const Dyadic& a, const Dyadic& b, std::int64_t exponent);
    static int compare_magnitudes(const Dyadic& a, const Dyadic& b);
    static Limbs difference(const Dyadic& larger, const Dyadic& smaller, std::int64_t exponent);
    std::int64_t top() const { return exponent_ + static_cast<std::int64_t>(limbs_.size()); }
    std::uint32_t limb_at(std::int64_t place) const;

    /// sign * sum of limbs_[i] 2^(32 (i + exponent_)); neither the first nor the last limb is 0.
    int sign_ = 0;
    Limbs limbs_;
    std::int64_t exponent_ = 0;
};

/// Three exact components.
struct Dyadic3 {
    Dyadic x, y, z;
};
inline Dyadic3 exact(const DoubleDouble3& a)
{
    return {a.x, a.y, a.z};
}
inline Dyadic dot(const Dyadic3& a, const Dyadic3& b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

}  // namespace carom
