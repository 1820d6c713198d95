#include "verify/run_data.hpp"

#include <algorithm>

namespace carom::verification {

RunData::RunData(const RecordedRun& r) : run(r), units{r.frame.cell_size, r.frame.epoch_length}
{
    const auto scaled = [&](const Vec3& a) {
        return Vec3(units.acceleration(a.x()), units.acceleration(a.y()), units.acceleration(a.z()));
    };
    gravity = scaled(r.gravity);
    drag = r.frame.drag * units.time;
    closing_speed = units.speed(r.closing_speed);
    window = r.window / units.time;
    const auto loses = [](const auto& law) { return law.restitution < 1; };
    is_lossy = std::any_of(r.materials.begin(), r.materials.end(), loses) ||
               std::any_of(r.contacts.begin(), r.contacts.end(), loses);
    for (const Vec3& a : r.frame.accelerations) accelerations.push_back(scaled(a));
    for (const Plane& p : r.planes)
        walls.push_back(
            {p.normal, p.offset / units.length, p.thickness.value_or(0) / 2 / units.length, p.thickness.has_value()});
}

bool RunData::is_along(const Vec3& a, int plane) const
{
    const Vec3& n = wall(plane).normal;
    const Vec3 along = gravity - gravity.dot(n) / n.squaredNorm() * n;
    const double size = gravity.cwiseAbs().maxCoeff();
    return (a - along).cwiseAbs().maxCoeff() <= split_rounding * size;
}

/// Laws of materials (docs/impacts.md, section 1): the smaller value of two materials holds; `tangential` acts at
/// planes, between spheres only if a contact entry gives it; entries override.
ContactLaw RunData::law(BodyId a, BodyId b) const
{
    const bool with_plane = b >= spheres();
    const int ma = sphere(a).material;
    const int mb = with_plane ? run.planes[static_cast<std::size_t>(b - spheres())].material : sphere(b).material;
    const Material& first = run.materials[static_cast<std::size_t>(ma)];
    const Material& second = run.materials[static_cast<std::size_t>(mb)];
    ContactLaw law;
    law.restitution = std::min(first.restitution, second.restitution);
    if (with_plane) law.tangential = std::min(first.tangential, second.tangential);
    for (const ContactRule& rule : run.contacts) {
        if (std::minmax(rule.a, rule.b) != std::minmax(ma, mb)) continue;
        law.restitution = rule.restitution.value_or(law.restitution);
        law.tangential = rule.tangential.value_or(law.tangential);
        if (!with_plane) law.attenuation = rule.attenuation.value_or(1);
        break;
    }
    return law;
}

}  // namespace carom::verification
