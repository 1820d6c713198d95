#include "stepping/contact_order.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

namespace carom::stepping {

std::uint64_t ContactArranger::draw()
{
    state_ += 0x9e3779b97f4a7c15;
    return mix_bits(state_);
}

void ContactArranger::arrange(std::vector<Contact>& contacts)
{
    if (contacts.size() < 2) return;
    switch (order_) {
        case ContactOrder::index:
        case ContactOrder::jacobi:
        case ContactOrder::shock:  // by ContactLevels, which knows the bodies
            return;
        case ContactOrder::reverse:
            std::reverse(contacts.begin(), contacts.end());
            return;
        case ContactOrder::random:
            // Fisher-Yates. The modulo's bias is below 1e-9 for any list that fits in memory.
            for (std::size_t k = contacts.size() - 1; k > 0; --k) std::swap(contacts[k], contacts[draw() % (k + 1)]);
            return;
        case ContactOrder::deepest:
            std::sort(contacts.begin(), contacts.end(), [](const Contact& x, const Contact& y) {
                return std::tie(x.gap, x.a, x.b) < std::tie(y.gap, y.a, y.b);
            });
            return;
    }
}

}  // namespace carom::stepping
