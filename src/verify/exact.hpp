/// \file
/// Exact sums, differences and products of doubles: expansions (Shewchuk, Adaptive precision floating-point arithmetic
/// and fast robust geometric predicates, Discrete Comput. Geom. 18 (1997)). Slow, and asked only where double-double
/// cannot tell a sign. The verifier has its own: it shares nothing with the engine.
#pragma once

#include "math/error_free.hpp"
#include "verify/tolerances.hpp"

#include <algorithm>
#include <array>

namespace carom::verification {

class Exact {
public:
    Exact() = default;
    Exact(double value)  // NOLINT: a double is exact
    {
        if (value != 0) parts_[count_++] = value;
    }
    Exact(double high, double low) : Exact(Exact(high) + Exact(low)) {}

    Exact(const Exact& other) : count_(other.count_), sound_(other.sound_)
    {
        std::copy_n(other.parts_.begin(), count_, parts_.begin());
    }
    Exact& operator=(const Exact& other)
    {
        count_ = other.count_;
        sound_ = other.sound_;
        std::copy_n(other.parts_.begin(), count_, parts_.begin());
        return *this;
    }

    int sign() const { return count_ == 0 ? 0 : parts_[count_ - 1] > 0 ? 1 : -1; }
    /// False if a product left the range in which products of doubles are exact, or a sum has too many parts: the sign
    /// means nothing then.
    bool sound() const { return sound_; }

    Exact operator-() const
    {
        Exact negative = *this;
        for (std::size_t i = 0; i < count_; ++i) negative.parts_[i] = -parts_[i];
        return negative;
    }
    friend Exact operator+(const Exact& a, const Exact& b)
    {
        Exact sum = a;
        sum.sound_ = a.sound_ && b.sound_;
        for (std::size_t i = 0; i < b.count_; ++i) sum.grow(b.parts_[i]);
        return sum;
    }
    friend Exact operator-(const Exact& a, const Exact& b) { return a + (-b); }
    friend Exact operator*(const Exact& a, const Exact& b)
    {
        Exact product;
        product.sound_ = a.sound_ && b.sound_;
        for (std::size_t i = 0; i < a.count_; ++i)
            for (std::size_t j = 0; j < b.count_; ++j) {
                const Sum p = two_product(a.parts_[i], b.parts_[j]);
                if (!(std::abs(p.high) > smallest_exact_product && std::abs(p.high) < largest_exact_product))
                    product.sound_ = false;
                product.grow(p.low);
                product.grow(p.high);
            }
        return product;
    }

private:
    /// Parts never overlap and grow in size (grow-expansion with zeros left out).
    void grow(double value)
    {
        std::size_t kept = 0;
        double carry = value;
        for (std::size_t i = 0; i < count_; ++i) {
            const Sum s = two_sum(carry, parts_[i]);
            carry = s.high;
            if (s.low != 0) parts_[kept++] = s.low;
        }
        count_ = kept;
        if (carry == 0) return;
        if (count_ == most_exact_parts) {
            sound_ = false;
            return;
        }
        parts_[count_++] = carry;
    }

    std::array<double, most_exact_parts> parts_;
    std::size_t count_ = 0;
    bool sound_ = true;
};

}  // namespace carom::verification
