#include "motion/numeric_cluster.hpp"

#include "contact/contact_forces.hpp"
#include "contact/contact_problem.hpp"
#include "contact/equalise.hpp"
#include "motion/tolerances.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace carom {

namespace {

using Bodies = std::vector<NumericBody>;

/// Another sphere as a contact sees it.
NumericBody opposite(const NumericContact& c, std::span<const NumericBody> bodies)
{
    if (const std::optional<int> b = c.b()) return bodies[static_cast<std::size_t>(*b)];
    return {std::get<FixedSphere>(c.partner).centre, Vec3::Zero(), 0};
}

struct Geometry {
    Vec3 normal;
    double gap;        ///< [length]
    double curvature;  ///< |w_t|^2 / distance [length/time^2]
};

Geometry geometry(const NumericContact& c, std::span<const NumericBody> bodies)
{
    const NumericBody& a = bodies[static_cast<std::size_t>(c.a)];
    if (const auto* plane = std::get_if<FixedPlane>(&c.partner))
        return {plane->normal, plane->normal.dot(a.position) - c.reach, 0};
    const NumericBody b = opposite(c, bodies);
    const Vec3 r = a.position - b.position, w = a.velocity - b.velocity;
    const double distance = std::sqrt(r.squaredNorm());
    const Vec3 normal = r / distance;
    return {normal, distance - c.reach, (w - w.dot(normal) * normal).squaredNorm() / distance};
}

/// Contacts as they stand, with a velocity for each body.
struct Standing {
    ContactProblem problem;
    std::vector<double> curvature;  ///< by contact

    Standing(const NumericCluster& cluster, const Bodies& bodies)
    {
        for (const NumericBody& b : bodies) problem.bodies.push_back({b.velocity, b.inverse_mass});
        for (const NumericContact& c : cluster.contacts) {
            const Geometry g = geometry(c, bodies);
            problem.contacts.push_back({.a = c.a, .b = c.b(), .normal = g.normal, .restitution = 0, .gap = g.gap});
            curvature.push_back(g.curvature);
        }
    }
};

/// \param guess forces of a moment nearby
ContactForces forces_at(const NumericCluster& cluster, const Bodies& bodies, std::span<const double> guess)
{
    Standing standing(cluster, bodies);
    for (ContactBody& body : standing.problem.bodies) body.velocity = cluster.gravity;
    return solve_contact_forces(standing.problem, standing.curvature, guess);
}

/// The rate of a body's velocity, drag included. \param acceleration without drag
Vec3 rate_of_velocity(const NumericCluster& cluster, const NumericBody& body, const Vec3& acceleration)
{
    return cluster.drag > 0 ? Vec3(acceleration - cluster.drag * body.velocity) : acceleration;
}

/// The bodies of the cluster after dt, at the velocities of `at` and the accelerations of `forces` there.
Bodies moved(const NumericCluster& cluster, const Bodies& at, const ContactForces& forces, double dt)
{
    Bodies out = cluster.bodies;
    for (std::size_t i = 0; i < out.size(); ++i) {
        out[i].position += dt * at[i].velocity;
        out[i].velocity += dt * rate_of_velocity(cluster, at[i], forces.accelerations[i]);
    }
    return out;
}

struct RungeKutta {
    Bodies bodies;
    std::vector<double> forces;  ///< mean
    ContactForces at_end;
    double disagreement = 0;  ///< of the middle stages, in places [length]
};

RungeKutta runge_kutta(const NumericCluster& cluster, const ContactForces& k1, double h)
{
    const Bodies& y1 = cluster.bodies;
    const Bodies y2 = moved(cluster, y1, k1, h / 2);
    const ContactForces k2 = forces_at(cluster, y2, k1.forces);
    const Bodies y3 = moved(cluster, y2, k2, h / 2);
    const ContactForces k3 = forces_at(cluster, y3, k2.forces);
    const Bodies y4 = moved(cluster, y3, k3, h);
    const ContactForces k4 = forces_at(cluster, y4, k3.forces);
    RungeKutta out{y1, {}, {}, 0};
    for (std::size_t i = 0; i < y1.size(); ++i) {
        const Vec3 differ = k3.accelerations[i] - k2.accelerations[i];
        out.disagreement = std::max(out.disagreement, h * h / 6 * differ.cwiseAbs().maxCoeff());
        out.bodies[i].position += h / 6 * ((y1[i].velocity + y4[i].velocity) + 2 * (y2[i].velocity + y3[i].velocity));
        const auto rate = [&](const Bodies& at, const ContactForces& forces) {
            return rate_of_velocity(cluster, at[i], forces.accelerations[i]);
        };
        out.bodies[i].velocity += h / 6 * ((rate(y1, k1) + rate(y4, k4)) + 2 * (rate(y2, k2) + rate(y3, k3)));
    }
    for (std::size_t i = 0; i < cluster.contacts.size(); ++i)
        out.forces.push_back(((k1.forces[i] + k4.forces[i]) + 2 * (k2.forces[i] + k3.forces[i])) / 6);
    out.at_end = forces_at(cluster, out.bodies, k4.forces);
    return out;
}

/// Gap rate of contact i beyond that of opening, > 0 where it opens [length/time^2]. For a contact that carries: minus
/// the rate at which its gap would close if it alone let go, so that the sign changes steadily.
double opening(const NumericCluster& cluster, const ContactForces& forces, std::size_t i)
{
    const NumericContact& c = cluster.contacts[i];
    const std::optional<int> b = c.b();
    const double lightness = cluster.bodies[static_cast<std::size_t>(c.a)].inverse_mass +
                             (b ? cluster.bodies[static_cast<std::size_t>(*b)].inverse_mass : 0);
    const double force = forces.forces[i];
    return (force > 0 ? -force * lightness : forces.gap_rates[i]) - cluster.opening;
}

/// The largest of these among watched contacts: > 0 where one opens.
double opening(const NumericCluster& cluster, const ContactForces& forces, const std::vector<char>& watched)
{
    double most = -std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < watched.size(); ++i)
        if (watched[i]) most = std::max(most, opening(cluster, forces, i));
    return most;
}

/// The step to the first moment found at which a watched contact is open: false position with the weights of Illinois
/// (Dowell and Jarratt 1971) between a step after which none is and one after which some is.
double step_to_opening(const NumericCluster& cluster, const ContactForces& start, double h,
                       const std::vector<char>& watched, RungeKutta& end)
{
    double closed = 0, open = h, value_closed = opening(cluster, start, watched),
           value_open = opening(cluster, end.at_end, watched);
    const double enough = opened_enough * cluster.opening;
    int same_side = 0;
    for (int i = 0; i < most_opening_steps && value_open > enough; ++i) {
        double middle = open - value_open * ((open - closed) / (value_open - value_closed));
        if (!(closed < middle && middle < open)) middle = closed + (open - closed) / 2;
        RungeKutta tried = runge_kutta(cluster, start, middle);
        const double value = opening(cluster, tried.at_end, watched);
        const bool is_open = value > 0;
        (is_open ? open : closed) = middle;
        (is_open ? value_open : value_closed) = value;
        same_side = is_open ? std::max(same_side, 0) + 1 : std::min(same_side, 0) - 1;
        if (same_side > 1) value_closed /= 2;
        if (same_side < -1) value_open /= 2;
        if (is_open) end = std::move(tried);
    }
    return open;
}

/// A step to h, or to the first opening of a contact that carries.
double step(const NumericCluster& cluster, const ContactForces& start, double h, RungeKutta& end)
{
    std::vector<char> watched;
    for (const double force : start.forces) watched.push_back(force > 0);
    end = runge_kutta(cluster, start, h);
    // Wedges of jammed bodies turn their normals on the way of a small part of a radius.
    for (int n = 0; n < most_halvings && end.disagreement > cluster.agreement; ++n) {
        h /= 2;
        end = runge_kutta(cluster, start, h);
    }
    if (!(opening(cluster, end.at_end, watched) > 0)) return h;
    return step_to_opening(cluster, start, h, watched, end);
}

double energy(const NumericCluster& cluster, const Bodies& bodies)
{
    double sum = 0;
    for (const NumericBody& b : bodies)
        sum += (b.velocity.squaredNorm() / 2 - cluster.gravity.dot(b.position)) / b.inverse_mass;
    return sum;
}

/// Puts gaps and rates of contacts that carry back to 0, and overlaps of the others.
void put_back(const NumericCluster& cluster, const std::vector<double>& forces, Bodies& bodies)
{
    for (const bool gaps : {true, false}) {
        const ContactProblem problem = Standing(cluster, bodies).problem;
        const std::vector<Vec3> velocities = velocities_before(problem);
        ContactProblem some{problem.bodies, {}};
        std::vector<double> wanted;
        for (std::size_t i = 0; i < cluster.contacts.size(); ++i) {
            const Contact& c = problem.contacts[i];
            if (!(forces[i] > 0 || (gaps && c.gap < 0))) continue;
            some.contacts.push_back(c);
            wanted.push_back(gaps ? -c.gap : -closing_rate(c, velocities));
        }
        if (wanted.empty()) continue;
        const std::vector<Vec3> change = equalising_change(some, wanted).change;
        for (std::size_t k = 0; k < change.size(); ++k) (gaps ? bodies[k].position : bodies[k].velocity) += change[k];
    }
}

}  // namespace

double NumericContact::gap(std::span<const NumericBody> bodies) const
{
    return geometry(*this, bodies).gap;
}

NumericStep numeric_step(const NumericCluster& cluster, double h)
{
    std::vector<double> guess;
    for (const NumericContact& c : cluster.contacts) guess.push_back(c.force);
    const ContactForces start = forces_at(cluster, cluster.bodies, guess);
    RungeKutta end;
    NumericStep out;
    out.duration = step(cluster, start, h, end);
    if (out.duration <= at_once * h)
        for (std::size_t i = 0; i < cluster.contacts.size(); ++i)
            if (start.forces[i] > 0 && opening(cluster, end.at_end, i) > 0) out.opened.push_back(i);
    out.integrated = end.bodies;
    // Without drag the start has the energy that an exact step would end with; what drag takes is its work.
    const double before = energy(cluster, cluster.drag > 0 ? out.integrated : cluster.bodies);
    put_back(cluster, end.at_end.forces, end.bodies);
    out.correction = before - energy(cluster, end.bodies);
    out.bodies = std::move(end.bodies);
    out.forces = std::move(end.forces);
    out.start_accelerations = start.accelerations;
    out.end_accelerations = std::move(end.at_end.accelerations);
    return out;
}

NumericBody within_step(const NumericCluster& cluster, const NumericStep& step, std::size_t body, double t)
{
    const double h = step.duration, s = t / h;
    NumericBody out = cluster.bodies[body];
    const Vec3 v = out.velocity, a = h * rate_of_velocity(cluster, out, step.start_accelerations[body]);
    const Vec3 gained = step.integrated[body].velocity - v - a,
               change = h * rate_of_velocity(cluster, step.integrated[body], step.end_accelerations[body]) - a;
    const Vec3 c2 = 3 * gained - change, c3 = change - 2 * gained;
    out.velocity += s * (a + s * (c2 + s * c3));
    out.position += h * s * (v + s * (a / 2 + s * (c2 / 3 + s * (c3 / 4))));
    return out;
}

std::vector<NumericBody> within_step(const NumericCluster& cluster, const NumericStep& step, double t)
{
    Bodies out;
    for (std::size_t k = 0; k < cluster.bodies.size(); ++k) out.push_back(within_step(cluster, step, k, t));
    put_back(cluster, step.forces, out);
    return out;
}

}  // namespace carom
