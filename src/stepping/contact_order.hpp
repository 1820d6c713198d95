/// \file
/// The order in which the contacts of one phase are visited. Correcting one may spoil another, so it matters.
#pragma once

#include "stepping/contact.hpp"

#include <carom/method.hpp>

#include <cstdint>
#include <vector>

namespace carom::stepping {

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
