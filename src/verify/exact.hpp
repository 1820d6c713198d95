/// \file
/// Exact sums, differences and products of doubles: expansions (Shewchuk, Adaptive precision floating-point arithmetic
/// and fast robust geometric predicates, Discrete Comput. Geom. 18 (1997)). Slow, and asked only where double-double
/// cannot tell a sign. The verifier has its own: it shares nothing with the engine.
#pragma once

#include "math/error_free.hpp"

#include <vector>

namespace carom::verification {

class Exact {
public:
    Exact() = default;
    Exact(double value)  // NOLINT: a double is exact
    {
        if (value != 0) parts_.push_back(value);
    }
    Exact(double high, double low) : Exact(Exact(high) + Exact(low)) {}

    int sign() const { return parts_.empty() ? 0 : parts_.back() > 0 ? 1 : -1; }
    /// False if a product left the range in which products of doubles are exact: the sign means nothing then.
    bool sound() const { return sound_; }

    Exact operator-() const
    {
        Exact negative = *this;
        for (double& part : negative.parts_) part = -part;
        return negative;
    }
    friend Exact operator+(const Exact& a, const Exact& b)
    {
        Exact sum = a;
        sum.sound_ = a.sound_ && b.sound_;
        for (const double part : b.parts_) sum.grow(part);
        return sum;
    }
    friend Exact operator-(const Exact& a, const Exact& b) { return a + (-b); }
    friend Exact operator*(const Exact& a, const Exact& b)
    {
        Exact product;
        product.sound_ = a.sound_ && b.sound_;
        for (const double x : a.parts_)
            for (const double y : b.parts_) {
                const Sum p = two_product(x, y);
                if (!(std::abs(p.high) > smallest && std::abs(p.high) < largest)) product.sound_ = false;
                product.grow(p.low);
                product.grow(p.high);
            }
        return product;
    }

private:
    static constexpr double smallest = 0x1p-900, largest = 0x1p900;

    /// Parts never overlap and grow in size (grow-expansion with zeros left out).
    void grow(double value)
    {
        std::size_t kept = 0;
        double carry = value;
        for (const double part : parts_) {
            const Sum s = two_sum(carry, part);
            carry = s.high;
            if (s.low != 0) parts_[kept++] = s.low;
        }
        parts_.resize(kept);
        if (carry != 0) parts_.push_back(carry);
    }

    std::vector<double> parts_;
    bool sound_ = true;
};

}  // namespace carom::verification
