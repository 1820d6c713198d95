#include "motion/kinematics.hpp"

#include "toi/damped_plane.hpp"
#include "toi/damped_sphere_sphere.hpp"

namespace carom {

ContactTime DampedKinematics::pair_time(const State& state, BodyId a, BodyId b, const EpochTime& limit)
{
    const PairMotion m = damped_pair_motion(state, a, b);
    // A bound of the way without drag is one with it.
    if (meet_too_late(state, a, b, m, limit)) return {};
    const bool is_curved = m.acceleration_a != m.acceleration_b;
    const auto persists = [&] { return state.bodies.contacts().between(a, Partner::sphere(b)); };
    if (is_curved && persists()) return {};
    const std::optional<double> low = is_curved ? low_return(state, a, b, m) : std::nullopt;
    const Accelerations& accelerations = state.bodies.accelerations();
    const Vec3 acceleration =
        is_curved ? Vec3(accelerations[m.acceleration_a] - accelerations[m.acceleration_b]) : Vec3(Vec3::Zero());
    const Root root = low ? Root{RootKind::impact, *low, 0}
                          : damped_sphere_sphere_root({m.r, m.v, acceleration, m.contact_distance}, state.drag);
    if (root.kind == RootKind::none || (!is_curved && persists())) return {};
    return {true, time_up_to(state.frame, m.from, root.t, limit), false, false};
}

ContactTime DampedKinematics::plane_time(const State& state, const Moving& sphere, int p, const EpochTime& limit)
{
    if (recedes(state, sphere, p)) return {};
    const PlaneMotion m = plane_motion(state, sphere, p);
    const Root root = damped_plane_root(m.h, m.w, m.g, state.drag);
    if (root.kind == RootKind::none) return {};
    return {true, time_up_to(state.frame, sphere.flight.start, root.t, limit)};
}

}  // namespace carom
