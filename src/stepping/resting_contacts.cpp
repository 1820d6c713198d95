#include "stepping/resting_contacts.hpp"

#include "stepping/contact_solver.hpp"
#include "stepping/response.hpp"
#include "stepping/tolerances.hpp"

#include <algorithm>
#include <cmath>
#include <set>

namespace carom::stepping {

namespace {

std::size_t index(BodyId body)
{
    return static_cast<std::size_t>(body);
}

Contact contact_of(const System& system, BodyId a, BodyId b)
{
    const Bodies& bodies = system.bodies;
    const Gap gap = system.detector.is_wall(b)
                        ? wall_gap(system.detector.wall(b), bodies.position[index(a)], bodies.radius[index(a)])
                        : sphere_gap(bodies.position[index(a)], bodies.position[index(b)],
                                     bodies.radius[index(a)] + bodies.radius[index(b)]);
    return {gap.value, a, b, gap.normal};
}

/// Relative normal acceleration with which the gap stays closed: spheres that pass each other at v part by v^2 / R.
double least_acceleration(const System& system, const Contact& c)
{
    if (system.detector.is_wall(c.b)) return 0;
    const Bodies& bodies = system.bodies;
    const Vec3 v = bodies.velocity[index(c.a)] - bodies.velocity[index(c.b)];
    const double along = v.dot(c.normal);
    return -(v.squaredNorm() - along * along) / (bodies.radius[index(c.a)] + bodies.radius[index(c.b)]);
}

}  // namespace

double speed_of_rest(const Bodies& bodies, const Contact& contact, double g)
{
    const Vec3& p = bodies.position[index(contact.a)];
    const double place = std::max(p.cwiseAbs().maxCoeff(), bodies.radius[index(contact.a)]);
    return std::sqrt(2 * g * rounding_of_place * place);
}

void RestingContacts::add(const System& system, BodyId a, BodyId b)
{
    if (!forces_.emplace(BodyPair(a, b), 0).second) return;
    partners_[index(a)].push_back(b);
    if (!system.detector.is_wall(b)) partners_[index(b)].push_back(a);
}

void RestingContacts::remove(const System& system, BodyId a, BodyId b)
{
    if (forces_.erase({a, b}) == 0) return;
    std::erase(partners_[index(a)], b);
    if (!system.detector.is_wall(b)) std::erase(partners_[index(b)], a);
}

void RestingContacts::separate(System& system, const std::set<BodyPair>& closed) const
{
    std::set<BodyPair> pairs = closed;
    for (const auto& [pair, force] : forces_) pairs.insert(pair);
    std::vector<ContactRow> rows;
    bool any_overlaps = false;
    for (const auto& [a, b] : pairs) {
        const Contact c = contact_of(system, a, b);
        rows.push_back({c, -c.gap, 0});
        any_overlaps = any_overlaps || c.gap < 0;
    }
    if (!any_overlaps) return;
    // The solver works on velocities; here they are displacements.
    std::vector<Vec3> displacement(system.bodies.size(), Vec3::Zero());
    displacement.swap(system.bodies.velocity);
    solve_contacts(system.bodies, rows, support_sweeps, system.patience);
    displacement.swap(system.bodies.velocity);
    for (std::size_t i = 0; i < system.bodies.size(); ++i) system.bodies.position[i] += displacement[i];
}

void RestingContacts::support_all(System& system, StepPaths& paths, double h, const std::set<BodyPair>& closed)
{
    separate(system, closed);
    paths.fall(system.bodies, system.motion);
    if (forces_.empty()) return;
    const double g = std::sqrt(system.motion.gravity().squaredNorm());
    std::vector<ContactRow> rows;
    for (const auto& [pair, force] : std::map(forces_)) {
        const Contact c = contact_of(system, pair.first, pair.second);
        if (c.gap > open_contact * system.bodies.radius[index(c.a)] ||
            normal_velocity(system.bodies, c) > opening_share * h * g)
            remove(system, c.a, c.b);
        else
            rows.push_back({c, 0, 0});
    }
    solve_contacts(system.bodies, rows, support_sweeps, system.patience, h * g);
    std::vector<ContactRow> pressed;
    for (const ContactRow& row : rows) {
        system.impacts.press(row.contact, row.impulse);
        pressed.push_back(
            {row.contact, least_acceleration(system, row.contact), forces_.at({row.contact.a, row.contact.b})});
    }
    // The solver works on velocities; the complementarity problem of accelerations is the same.
    system.bodies.velocity.swap(paths.acceleration);
    for (const ContactRow& row : pressed) apply(system.bodies, row.contact, row.impulse * row.contact.normal);
    solve_contacts(system.bodies, pressed, support_sweeps, system.patience, g);
    system.bodies.velocity.swap(paths.acceleration);
    for (const ContactRow& row : pressed) {
        system.impacts.press(row.contact, h * row.impulse);
        if (row.impulse == 0)
            remove(system, row.contact.a, row.contact.b);
        else
            forces_[{row.contact.a, row.contact.b}] = row.impulse;
    }
}

void RestingContacts::support(System& system, StepPaths& paths, std::span<const BodyId> spheres) const
{
    // A small system of its own, in which the others have infinite mass.
    Bodies local;
    std::vector<BodyId> ids;
    const auto local_id = [&](BodyId sphere, bool is_free) {
        const auto known = std::find(ids.begin(), ids.end(), sphere);
        if (known != ids.end()) return static_cast<BodyId>(known - ids.begin());
        ids.push_back(sphere);
        const double inverse_mass = is_free ? system.bodies.inverse_mass[index(sphere)] : 0;
        local.position.push_back(system.bodies.position[index(sphere)]);
        local.velocity.push_back(inverse_mass > 0 ? system.motion.gravity() : paths.acceleration[index(sphere)]);
        local.mass.push_back(system.bodies.mass[index(sphere)]);
        local.inverse_mass.push_back(inverse_mass);
        return static_cast<BodyId>(ids.size() - 1);
    };
    std::set<BodyPair> pairs;
    for (const BodyId i : spheres) {
        local_id(i, true);
        for (const BodyId j : of(i)) pairs.emplace(std::min(i, j), std::max(i, j));
    }
    for (const auto& [a, b] : pairs) {
        local_id(a, false);
        if (!system.detector.is_wall(b)) local_id(b, false);
    }
    std::vector<ContactRow> rows;
    const auto wall = static_cast<BodyId>(ids.size());
    for (const auto& [a, b] : pairs) {
        Contact c = contact_of(system, a, b);
        const double least = least_acceleration(system, c);
        c.a = local_id(a, false);
        c.b = system.detector.is_wall(b) ? wall : local_id(b, false);
        if (local.inverse_mass[index(c.a)] > 0 || (c.b != wall && local.inverse_mass[index(c.b)] > 0))
            rows.push_back({c, least, 0});
    }
    solve_contacts(local, rows, support_sweeps, system.patience);
    for (const BodyId i : spheres) paths.acceleration[index(i)] = local.velocity[index(local_id(i, true))];
}

}  // namespace carom::stepping
