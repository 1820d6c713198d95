#include "stepping/pair_pass.hpp"

#include "stepping/tolerances.hpp"

#include <algorithm>

namespace carom::stepping {

void PairPass::begin(System& system, const std::vector<Contact>& overlapping)
{
    order_.emplace(system.arranger);
    at_begin_ = system.bodies.position;
    for (const BodyId i : touched_) list_[index(i)].is_made = false;
    touched_.clear();
    listed_.clear();
    moved_.clear();
    lists_hold_ = true;
    margin_ = list_reach * deepest_penetration(overlapping);
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

void PairPass::look_again(System& system, BodyId i, const Visit& now)
{
    const std::vector<Vec3>& position = system.bodies.position;
    if (lists_hold_ && (position[index(i)] - at_begin_[index(i)]).squaredNorm() > margin_ * margin_) {
        give_up_lists(system);
        if (!list_[index(i)].is_made) moved_.move(i, position[index(i)]);
    } else if (!lists_hold_) {
        moved_.move(i, position[index(i)]);
    }
    if (lists_hold_) {
        for (const BodyId j : neighbours(system, i)) look_at(system, i, j, now);
    } else {
        moved_.for_each_near(system.detector, position[index(i)], system.bodies.radius[index(i)], [&](BodyId j) {
            if (j != i) look_at(system, i, j, now);
        });
    }
}

void PairPass::look_at(System& system, BodyId i, BodyId j, const Visit& now)
{
    if (system.detector.is_fixed(index(i)) && system.detector.is_fixed(index(j))) return;
    ++system.detector.tests;
    if (!overlaps(system.bodies, index(i), index(j))) return;
    const BodyId a = std::min(i, j), b = std::max(i, j);
    const double radius_sum = system.bodies.radius[index(a)] + system.bodies.radius[index(b)];
    const double gap =
        order_->asks_for_gap() ? sphere_gap(at_begin_[index(a)], at_begin_[index(b)], radius_sum).value : 0;
    const Visit visit = order_->visit(a, b, gap);
    if (!(visit > now)) return;
    late_.push_back(visit);
    std::push_heap(late_.begin(), late_.end(), later);
}

std::span<const BodyId> PairPass::neighbours(const System& system, BodyId i)
{
    List& list = list_[index(i)];
    if (!list.is_made) {
        // Two that touch now were apart by two margins at most, and a rounding, when the pass began.
        const Vec3& p = at_begin_[index(i)];
        const double reach = (system.bodies.radius[index(i)] + 2 * margin_) * (1 + cell_slack);
        list = {listed_.size(), listed_.size(), true};
        system.detector.for_each_near(p, reach, [&](BodyId j) {
            const Vec3 d = p - at_begin_[index(j)];
            if (j != i && overlap(d.x(), d.y(), d.z(), reach + system.bodies.radius[index(j)])) listed_.push_back(j);
        });
        list.end = listed_.size();
        touched_.push_back(i);
    }
    return std::span(listed_).subspan(list.begin, list.end - list.begin);
}

void PairPass::give_up_lists(const System& system)
{
    lists_hold_ = false;
    for (const BodyId i : touched_) moved_.move(i, system.bodies.position[index(i)]);
}

}  // namespace carom::stepping
