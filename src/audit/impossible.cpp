#include "audit/impossible.hpp"

#include "audit/answer.hpp"
#include "audit/tolerances.hpp"

namespace carom::audit {

bool is_coarse(const Scene& scene, const Interval& interval, std::size_t sphere)
{
    return interval.motions[sphere].before->error_at(interval.end) > coarse_error * scene.spheres[sphere].radius;
}

bool may_end_a_step(const BodyMotion& motion)
{
    if (motion.bend != Bend::hidden || !motion.before) return false;
    const Parabola& before = *motion.before;
    const double time = motion.after ? motion.after->time : before.time;
    const Vec3 velocity = before.velocity_at(time);
    const Vec3 pull = before.pull.acceleration - before.pull.drag * velocity;
    if (pull.isZero(0)) return false;
    const Vec3 down = pull.normalized();
    const auto aside = [&](const Vec3& v) { return (v - v.dot(down) * down).norm(); };
    if (!motion.after) return aside(motion.off) <= motion.off_error;
    const Vec3 change = motion.after->velocity - velocity;
    const double error = before.velocity_error_at(time) + motion.after->velocity_error;
    return change.dot(down) >= -error && aside(change) <= error && aside(motion.off) <= motion.off_error;
}

bool is_pulled_back(const Scene& scene, const Interval& interval, std::size_t sphere, const Around& around)
{
    const BodyMotion& motion = interval.motions[sphere];
    const std::set<BodyId> partners = possible_partners(scene, static_cast<BodyId>(sphere), interval, around);
    if (partners.size() != 1 || *partners.begin() < static_cast<BodyId>(scene.spheres.size())) return false;
    const std::optional<Turn> turn = turn_of(motion);
    // The change must lie within the interval: contacts just before and behind it are those of others.
    if (!turn || turn->time - turn->error < interval.begin || turn->time + turn->error > interval.end) return false;
    const Plane& plane = scene.planes[static_cast<std::size_t>(*partners.begin()) - scene.spheres.size()];
    const Vec3 place = motion.before->place_at(interval.begin);
    const Vec3 normal = plane.thickness && is_behind(plane, place) ? Vec3(-plane.normal) : plane.normal;
    return turn->change.dot(normal) < -(motion.before->velocity_error + motion.after->velocity_error);
}

bool has_jumped(const Scene& scene, const Interval& interval, std::size_t sphere, const Around& around)
{
    const BodyMotion& motion = interval.motions[sphere];
    return is_displaced(*motion.before, *motion.after, interval.end - interval.begin) &&
           possible_partners(scene, static_cast<BodyId>(sphere), interval, around).size() <= 1;
}

}  // namespace carom::audit
