#include "window/restitution.hpp"

#include "window/tolerances.hpp"

#include <algorithm>
#include <cmath>

namespace carom {

namespace {

std::size_t at(int i)
{
    return static_cast<std::size_t>(i);
}

/// The factor x in [0, 1] up to which linear x + square x^2 stays at most `most`. \pre square >= 0, most >= 0
double largest_factor(double linear, double square, double most)
{
    if (linear + square <= most) return 1;
    const double root = std::sqrt(linear * linear + 4 * square * most);
    // The larger root of square x^2 + linear x - most, in the form that does not cancel.
    return linear > 0 ? 2 * most / (linear + root) : (root - linear) / (2 * square);
}

}  // namespace

double rebound(const std::vector<RelaxationRow>& rows, std::vector<Rebound>& rebounds, ReboundProblem& problem)
{
    std::vector<Vec3> u = problem.velocities;
    std::vector<char> moved(u.size(), 0);
    const auto reach = [&](const RelaxationRow& row) {
        if (row.weight_a > 0) moved[at(row.a)] = 1;
        if (row.weight_b > 0) moved[at(row.b)] = 1;
    };
    for (const Rebound& each : rebounds)
        if (each.fast) reach(rows[at(each.row)]);
    for (int sweep = 0; sweep < rebound_sweeps; ++sweep) {
        double missing = 0;
        for (Rebound& each : rebounds) {
            const RelaxationRow& row = rows[at(each.row)];
            if (!moved[at(row.a)] && !moved[at(row.b)]) continue;
            const double left = each.rate - rate(row, u);
            if (!(left > 0)) continue;
            const double impulse = left / (row.weight_a + row.weight_b);
            each.impulse += impulse;
            u[at(row.a)] += (impulse * row.weight_a) * row.normal;
            u[at(row.b)] -= (impulse * row.weight_b) * row.normal;
            missing = std::max(missing, left);
            reach(row);
        }
        if (!(missing > problem.speed_tolerance)) break;
    }
    double linear = 0, square = 0;
    for (std::size_t i = 0; i < u.size(); ++i) {
        if (!moved[i] || !(problem.inverse_masses[i] > 0)) continue;
        const Vec3 change = u[i] - problem.velocities[i];
        linear += problem.velocities[i].dot(change) / problem.inverse_masses[i];
        square += change.squaredNorm() / (2 * problem.inverse_masses[i]);
    }
    const double factor = largest_factor(linear, square, problem.most_energy);
    for (Rebound& each : rebounds) {
        each.impulse *= factor;
        const RelaxationRow& row = rows[at(each.row)];
        problem.velocities[at(row.a)] += (each.impulse * row.weight_a) * row.normal;
        problem.velocities[at(row.b)] -= (each.impulse * row.weight_b) * row.normal;
    }
    return factor * (linear + factor * square);
}

}  // namespace carom
