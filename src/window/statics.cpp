#include "window/statics.hpp"

#include "window/tolerances.hpp"

#include <Eigen/Sparse>
#include <Eigen/SparseCholesky>

#include <algorithm>
#include <cmath>

namespace carom {

namespace {

using Sparse = Eigen::SparseMatrix<double>;
using Column = Eigen::VectorXd;

/// Normals as rows, in the metric of mass.
Sparse normals_of(const std::vector<HalfSpace>& contacts, const std::vector<double>& inverse_masses)
{
    std::vector<Eigen::Triplet<double>> entries;
    for (std::size_t i = 0; i < contacts.size(); ++i) {
        const auto enter = [&](int body, double sign) {
            const double weight = sign * std::sqrt(inverse_masses[static_cast<std::size_t>(body)]);
            for (int k = 0; k < 3; ++k)
                entries.emplace_back(static_cast<int>(i), 3 * body + k, weight * contacts[i].normal[k]);
        };
        enter(contacts[i].a, 1);
        if (contacts[i].b) enter(*contacts[i].b, -1);
    }
    Sparse out(static_cast<Eigen::Index>(contacts.size()), static_cast<Eigen::Index>(3 * inverse_masses.size()));
    out.setFromTriplets(entries.begin(), entries.end());
    return out;
}

}  // namespace

std::optional<Statics> statics(const std::vector<HalfSpace>& contacts, const std::vector<Vec3>& accelerations,
                               const std::vector<double>& inverse_masses)
{
    const Sparse normals = normals_of(contacts, inverse_masses), transposed = normals.transpose();
    Sparse products = normals * transposed;
    for (Eigen::Index i = 0; i < products.rows(); ++i) products.coeffRef(i, i) *= 1 + statics_regularisation;
    const Eigen::SimplicialLDLT<Sparse> factor(products);
    if (factor.info() != Eigen::Success) return {};
    const auto multipliers = [&](const Column& wanted) {
        Column x = factor.solve(wanted);
        for (int round = 0; round < statics_refinements; ++round)
            x += factor.solve(wanted - normals * (transposed * x));
        return x;
    };
    const auto bodies = inverse_masses.size();
    Column load(static_cast<Eigen::Index>(3 * bodies)), gaps(static_cast<Eigen::Index>(contacts.size()));
    for (std::size_t k = 0; k < bodies; ++k)
        load.segment<3>(static_cast<Eigen::Index>(3 * k)) = accelerations[k] / std::sqrt(inverse_masses[k]);
    for (std::size_t i = 0; i < contacts.size(); ++i) gaps[static_cast<Eigen::Index>(i)] = contacts[i].offset;

    Statics out;
    const Column forces = multipliers(-(normals * load));
    const Column left = load + transposed * forces, shift = transposed * multipliers(-gaps);
    out.forces.assign(forces.begin(), forces.end());
    for (std::size_t k = 0; k < bodies; ++k) {
        const double root = std::sqrt(inverse_masses[k]);
        const auto first = static_cast<Eigen::Index>(3 * k);
        out.residual = std::max(out.residual, root * left.segment<3>(first).norm());
        out.displacement.emplace_back(root * shift.segment<3>(first));
    }
    if (!std::isfinite(out.residual)) return {};
    return out;
}

}  // namespace carom
