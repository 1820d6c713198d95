#include "stepping/pair_pass.hpp"

#include <algorithm>

namespace carom::stepping {

void PairPass::begin(System& system, const std::vector<Contact>& overlapping)
{
    order_.emplace(system.arranger);
    moved_.clear();
    if (order_->asks_for_gap()) at_begin_ = system.bodies.position;
    late_.clear();
    known_.clear();
    for (const Contact& c : overlapping) known_.push_back(order_->visit(c.a, c.b, c.gap));
    if (!std::is_sorted(known_.begin(), known_.end())) std::sort(known_.begin(), known_.end());
}

Visit PairPass::pop_late()
{
    std::pop_heap(late_.begin(), late_.end(), later);
    const Visit visit = late_.back();
    late_.pop_back();
    return visit;
}

void PairPass::look_again(System& system, BodyId i, const Vec3& before, const Visit& now)
{
    const Bodies& bodies = system.bodies;
    const std::size_t at = index(i);
    moved_.move(i, before, bodies.position[at]);
    moved_.for_each_near(system.detector, bodies.position[at], bodies.radius[at], [&](BodyId j) {
        if (j == i) return;
        if (system.detector.is_fixed(at) && system.detector.is_fixed(index(j))) return;
        ++system.detector.tests;
        if (!overlaps(bodies, at, index(j))) return;
        const BodyId a = std::min(i, j), b = std::max(i, j);
        const double radius_sum = bodies.radius[index(a)] + bodies.radius[index(b)];
        const double gap =
            order_->asks_for_gap() ? sphere_gap(at_begin_[index(a)], at_begin_[index(b)], radius_sum).value : 0;
        const Visit visit = order_->visit(a, b, gap);
        if (!(visit > now)) return;
        late_.push_back(visit);
        std::push_heap(late_.begin(), late_.end(), later);
    });
}

}  // namespace carom::stepping
