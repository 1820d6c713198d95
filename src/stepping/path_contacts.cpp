#include "stepping/path_contacts.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <tuple>

namespace carom::stepping {

namespace {

bool later(const Pending& x, const Pending& y)
{
    return std::tie(x.time, x.rank, x.a, x.b) > std::tie(y.time, y.rank, y.a, y.b);
}

/// Smaller goes first. Bit patterns of doubles >= 0 are ordered like their values.
std::int64_t rank(System& system, BodyId a, BodyId b, double depth)
{
    switch (system.arranger.order()) {
        case ContactOrder::index:
        case ContactOrder::jacobi:
        case ContactOrder::shock:
            return 0;
        case ContactOrder::reverse:
            return -((std::int64_t{a} << 31) + b);
        case ContactOrder::random:
            return static_cast<std::int64_t>(system.arranger.draw() >> 1);
        case ContactOrder::deepest:
            return -std::bit_cast<std::int64_t>(std::abs(depth));
    }
    return 0;
}

}  // namespace

Gap PathContacts::gap_at(const System& system, BodyId a, BodyId b, double time) const
{
    const auto& radius = system.bodies.radius;
    const Vec3 pa = paths.place(system.bodies, a, time);
    if (system.detector.is_wall(b)) return wall_gap(system.detector.wall(b), pa, radius[index(a)]);
    return sphere_gap(pa, paths.place(system.bodies, b, time), radius[index(a)] + radius[index(b)]);
}

Gap PathContacts::gap_at_targets(const System& system, BodyId a, BodyId b) const
{
    const auto& radius = system.bodies.radius;
    const Vec3& pa = paths.target[index(a)];
    if (system.detector.is_wall(b)) return wall_gap(system.detector.wall(b), pa, radius[index(a)]);
    return sphere_gap(pa, paths.target[index(b)], radius[index(a)] + radius[index(b)]);
}

double PathContacts::gap_rate(const System& system, BodyId a, BodyId b, const Vec3& normal, double time) const
{
    const Vec3 v = paths.velocity(system.bodies, a, time);
    return (system.detector.is_wall(b) ? v : Vec3(v - paths.velocity(system.bodies, b, time))).dot(normal);
}

void PathContacts::foresee(System& system, BodyId a, BodyId b, double time, double depth)
{
    queue_.push_back({time, rank(system, a, b, depth), a, b, stamp(system, a, b)});
    std::push_heap(queue_.begin(), queue_.end(), later);
}

Pending PathContacts::pop()
{
    std::pop_heap(queue_.begin(), queue_.end(), later);
    const Pending next = queue_.back();
    queue_.pop_back();
    return next;
}

void PathContacts::stop(System& system, BodyId a, BodyId b, double time)
{
    paths.stop_at(system.bodies, a, time);
    if (!system.detector.is_wall(b)) paths.stop_at(system.bodies, b, time);
}

}  // namespace carom::stepping
