#include "contact/contact_forces.hpp"

#include "contact/contact_problem.hpp"

#include "core/expect.hpp"

#include <algorithm>

namespace carom {

ContactForces solve_contact_forces(const ContactProblem& cluster, std::span<const double> curvature, Guess guess)
{
    CAROM_EXPECT(curvature.size() == cluster.contacts.size());
    CAROM_EXPECT(!guess || guess->size() == cluster.contacts.size());
    ProjectionProblem problem = projection_problem(cluster);
    double scale = largest_speed(problem.start);
    for (std::size_t i = 0; i < curvature.size(); ++i) {
        CAROM_EXPECT(curvature[i] >= 0);
        problem.half_spaces[i].offset = curvature[i];
        scale = std::max(scale, curvature[i]);
    }
    problem.tolerance = projection_tolerance * scale;

    Projection solved = project(problem, guess);
    ContactForces out{std::move(solved.multipliers), std::move(solved.point), {}};
    out.gap_rates.reserve(curvature.size());
    for (std::size_t i = 0; i < curvature.size(); ++i)
        out.gap_rates.push_back(out.forces[i] > 0 ? 0 : slack(problem.half_spaces[i], out.accelerations));
    return out;
}

}  // namespace carom
