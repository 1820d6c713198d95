/// \file
/// The order of one pass over all pairs of bodies, overlapping or not: each pair has its rank before the pass begins.
#pragma once

#include "stepping/contact.hpp"
#include "stepping/contact_order.hpp"

#include <bit>
#include <cmath>
#include <compare>
#include <cstdint>

namespace carom::stepping {

/// A pair and its place in the order of a pass.
struct Visit {
    std::uint64_t rank = 0;  ///< smaller goes first; equal ones in index order, or its reverse
    std::uint64_t pair = 0;  ///< a << 32 | b, or its complement for ContactOrder::reverse
    BodyId a = no_body, b = no_body;

    friend std::strong_ordering operator<=>(const Visit& x, const Visit& y)
    {
        if (const auto by_rank = x.rank <=> y.rank; by_rank != 0) return by_rank;
        return x.pair <=> y.pair;
    }
    friend bool operator==(const Visit& x, const Visit& y) { return (x <=> y) == 0; }
};

class PassOrder {
public:
    /// Draws a number for ContactOrder::random.
    explicit PassOrder(ContactArranger& arranger)
        : order_(arranger.order()), salt_(order_ == ContactOrder::random ? arranger.draw() : 0)
    {
    }

    /// \param gap at the begin of the pass, which decides for ContactOrder::deepest [length]
    Visit visit(BodyId a, BodyId b, double gap) const
    {
        const std::uint64_t pair = static_cast<std::uint64_t>(a) << 32 | static_cast<std::uint64_t>(b);
        switch (order_) {
            case ContactOrder::index:
            case ContactOrder::jacobi:
                return {0, pair, a, b};
            case ContactOrder::reverse:
                return {0, ~pair, a, b};
            case ContactOrder::random:
                return {mix_bits(salt_ + mix_bits(pair)), pair, a, b};
            case ContactOrder::deepest:
                return {order_of_bits(gap), pair, a, b};
        }
        return {0, pair, a, b};
    }

    bool asks_for_gap() const { return order_ == ContactOrder::deepest; }

private:
    /// Bit patterns that are ordered like the values.
    static std::uint64_t order_of_bits(double value)
    {
        value += 0.0;  // one zero
        const auto bits = std::bit_cast<std::uint64_t>(value);
        return std::signbit(value) ? ~bits : bits | std::bit_cast<std::uint64_t>(-0.0);
    }

    ContactOrder order_;
    std::uint64_t salt_;  ///< of this pass
};

}  // namespace carom::stepping
