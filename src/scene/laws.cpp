#include <carom/scene.hpp>

#include "math/length.hpp"
#include "scene/tolerances.hpp"

#include <algorithm>
#include <cmath>

namespace carom {

namespace {

const ContactRule* rule_between(const Scene& scene, int a, int b)
{
    for (const auto& rule : scene.contacts)
        if ((rule.a == a && rule.b == b) || (rule.a == b && rule.b == a)) return &rule;
    return nullptr;
}

}  // namespace

ContactLaw sphere_contact_law(const Scene& scene, int material_a, int material_b)
{
    const Material& a = scene.materials[static_cast<std::size_t>(material_a)];
    const Material& b = scene.materials[static_cast<std::size_t>(material_b)];
    ContactLaw law{std::min(a.restitution, b.restitution), 1, 1};
    if (const ContactRule* rule = rule_between(scene, material_a, material_b)) {
        law.restitution = rule->restitution.value_or(law.restitution);
        law.tangential = rule->tangential.value_or(1);
        law.attenuation = rule->attenuation.value_or(1);
    }
    return law;
}

ContactLaw plane_contact_law(const Scene& scene, int sphere_material, int plane_material)
{
    const Material& a = scene.materials[static_cast<std::size_t>(sphere_material)];
    const Material& b = scene.materials[static_cast<std::size_t>(plane_material)];
    ContactLaw law{std::min(a.restitution, b.restitution), std::min(a.tangential, b.tangential), 1};
    if (const ContactRule* rule = rule_between(scene, sphere_material, plane_material)) {
        law.restitution = rule->restitution.value_or(law.restitution);
        law.tangential = rule->tangential.value_or(law.tangential);
    }
    return law;
}

RestThresholds rest_thresholds(const Scene& scene)
{
    double r_min = 1, speed2 = 0;
    if (!scene.spheres.empty()) {
        r_min = scene.spheres.front().radius;
        for (const auto& s : scene.spheres) {
            r_min = std::min(r_min, s.radius);
            speed2 += s.velocity.squaredNorm();
        }
        speed2 /= static_cast<double>(scene.spheres.size());
    }
    const double g = length(scene.gravity);
    RestThresholds t{};
    if (g > 0) {
        t.closing_speed = std::sqrt(2 * g * closing_height * r_min);
        t.window = 2 * t.closing_speed / g;
        t.numeric_step = std::sqrt(r_min / g) / numeric_steps_a_radius;
    } else {
        const double v_rms = std::sqrt(speed2);
        t.closing_speed = closing_speed_part * v_rms;
        t.window = v_rms > 0 ? window_part * r_min / v_rms : 0;
        t.numeric_step = v_rms > 0 ? 1 / numeric_steps_a_radius * r_min / v_rms : 0;
    }
    t.gap_tolerance = declared_contact * r_min;
    t.closing_speed = scene.rest.closing_speed.value_or(t.closing_speed);
    t.window = scene.rest.window.value_or(t.window);
    t.numeric_step = scene.rest.numeric_step.value_or(t.numeric_step);
    t.gap_tolerance = scene.rest.gap_tolerance.value_or(t.gap_tolerance);
    return t;
}

double plane_gap(const Plane& p, const Sphere& s, const Vec3& position)
{
    const double height = p.normal.dot(position) - p.offset;
    return p.thickness ? std::abs(height) - *p.thickness / 2 - s.radius : height - s.radius;
}

}  // namespace carom
