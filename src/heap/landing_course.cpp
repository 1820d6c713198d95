#include "heap/landing_course.hpp"

#include "window/contact_geometry.hpp"

#include <algorithm>
#include <cmath>

namespace carom {

namespace {

/// Kinetic energy [energy] that must be left after each move, and one before them all, so that what later moves lift is
/// paid for and energy grows in none.
std::vector<double> energy_to_keep(const WindowProblem& problem, const std::vector<std::vector<Vec3>>& moves)
{
    std::vector<double> out(moves.size() + 1, 0);
    for (std::size_t m = moves.size(); m-- > 0;) {
        double lift = 0;
        for (std::size_t i = 0; i < problem.bodies.size(); ++i)
            if (problem.bodies[i].inverse_mass > 0)
                lift -= moves[m][i].dot(problem.bodies[i].acceleration) / problem.bodies[i].inverse_mass;
        out[m] = std::max(0.0, lift + out[m + 1]);
    }
    return out;
}

}  // namespace

std::shared_ptr<const LandingCourse> find_course(const WindowProblem& problem, const std::vector<BodyId>& ids,
                                                 const LandingOptions& options)
{
    const LandingOutcome found = land(problem, options);
    if (found.status != LandingStatus::rests) return nullptr;
    double kinetic = 0;
    for (std::size_t i = 0; i < problem.bodies.size(); ++i)
        if (found.rests[i]) kinetic += problem.bodies[i].velocity.squaredNorm() / (2 * problem.bodies[i].inverse_mass);
    const std::vector<double> keep = energy_to_keep(problem, found.moves);
    if (keep.front() > kinetic) return nullptr;
    auto out = std::make_shared<LandingCourse>();
    out->moves.resize(found.moves.size());
    for (std::size_t m = 0; m < found.moves.size(); ++m)
        out->left.push_back(kinetic > 0 ? std::sqrt(keep[m + 1] / kinetic) : 0);
    for (std::size_t i = 0; i < ids.size(); ++i) {
        if (!found.rests[i]) continue;
        out->bodies.push_back(ids[i]);
        out->velocities.push_back(problem.bodies[i].velocity);
        for (std::size_t m = 0; m < found.moves.size(); ++m) out->moves[m].push_back(found.moves[m][i]);
    }
    WindowProblem end = problem;
    for (const std::vector<Vec3>& move : found.moves)
        for (std::size_t i = 0; i < ids.size(); ++i)
            if (found.rests[i]) end.bodies[i].place += move[i];
    for (std::size_t k = 0; k < problem.contacts.size(); ++k) {
        if (!(found.forces[k] > 0)) continue;
        const WindowContact& c = problem.contacts[k];
        const auto b = static_cast<std::size_t>(c.b.index);
        out->forces.push_back(
            {ids[static_cast<std::size_t>(c.a)], c.b.is_plane() ? c.b : Partner::sphere(ids[b]), found.forces[k]});
        if (c.b.is_sphere() && !found.rests[b])
            out->loads.push_back({ids[b], -found.forces[k] * geometry(end, c).normal});
    }
    return out;
}

}  // namespace carom
