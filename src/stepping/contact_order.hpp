/// \file
/// The order in which the contacts of one phase are visited. Correcting one may spoil another, so it matters.
#pragma once

#include "stepping/contact.hpp"

#include <carom/method.hpp>

#include <cstdint>
#include <vector>

namespace carom::stepping {

/// The finaliser of SplitMix64: numbers that differ in a bit become numbers without relation.
constexpr std::uint64_t mix_bits(std::uint64_t z)
{
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
    z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
    return z ^ (z >> 31);
}

class ContactArranger {
public:
    ContactArranger(ContactOrder order, std::uint64_t seed) : order_(order), state_(seed) {}

    /// \param contacts in index order (pairs by a, b; then walls by sphere, plane), as detection leaves them.
    void arrange(std::vector<Contact>& contacts);

    /// Next number of the generator, all 64 bits random (SplitMix64: Steele, Lea, Flood, Fast splittable pseudorandom
    /// number generators, OOPSLA 2014).
    std::uint64_t draw();

    ContactOrder order() const { return order_; }

private:
    ContactOrder order_;
    std::uint64_t state_;
};

}  // namespace carom::stepping
