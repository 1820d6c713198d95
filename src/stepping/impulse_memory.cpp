#include "stepping/impulse_memory.hpp"

#include <algorithm>

namespace carom::stepping {

double ImpulseMemory::recall(const Contact& contact) const
{
    const std::pair<BodyId, BodyId> bodies{contact.a, contact.b};
    const auto entry = std::lower_bound(entries_.begin(), entries_.end(), bodies,
                                        [](const Entry& e, const auto& wanted) { return e.bodies < wanted; });
    return entry != entries_.end() && entry->bodies == bodies ? entry->impulse : 0;
}

void ImpulseMemory::sort()
{
    std::sort(entries_.begin(), entries_.end(), [](const Entry& x, const Entry& y) { return x.bodies < y.bodies; });
}

}  // namespace carom::stepping
