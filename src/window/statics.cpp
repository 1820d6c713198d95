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

struct CarryingContacts::Factor {
    Sparse normals, transposed;
    Eigen::SimplicialLDLT<Sparse> products;
    std::vector<double> inverse_masses;

    Column multipliers(const Column& wanted) const
    {
        Column x = products.solve(wanted);
        for (int round = 0; round < statics_refinements; ++round)
            x += products.solve(wanted - normals * (transposed * x));
        return x;
    }
};

CarryingContacts::CarryingContacts(const std::vector<HalfSpace>& contacts, const std::vector<double>& inverse_masses)
    : factor_(std::make_unique<Factor>())
{
    factor_->inverse_masses = inverse_masses;
    factor_->normals = normals_of(contacts, inverse_masses);
    factor_->transposed = factor_->normals.transpose();
    Sparse products = factor_->normals * factor_->transposed;
    for (Eigen::Index i = 0; i < products.rows(); ++i) products.coeffRef(i, i) *= 1 + statics_regularisation;
    factor_->products.compute(products);
}

CarryingContacts::~CarryingContacts() = default;

std::optional<CarriedForces> CarryingContacts::forces(const std::vector<Vec3>& accelerations) const
{
    const std::vector<double>& inverse_masses = factor_->inverse_masses;
    if (factor_->products.info() != Eigen::Success) return {};
    Column load(static_cast<Eigen::Index>(3 * inverse_masses.size()));
    for (std::size_t k = 0; k < inverse_masses.size(); ++k)
        load.segment<3>(static_cast<Eigen::Index>(3 * k)) = accelerations[k] / std::sqrt(inverse_masses[k]);
    const Column forces = factor_->multipliers(-(factor_->normals * load));
    const Column left = load + factor_->transposed * forces;
    CarriedForces out;
    out.forces.assign(forces.begin(), forces.end());
    for (std::size_t k = 0; k < inverse_masses.size(); ++k)
        out.residual = std::max(
            out.residual, std::sqrt(inverse_masses[k]) * left.segment<3>(static_cast<Eigen::Index>(3 * k)).norm());
    if (!std::isfinite(out.residual)) return {};
    return out;
}

std::vector<Vec3> CarryingContacts::displacement(const std::vector<HalfSpace>& contacts) const
{
    Column gaps(static_cast<Eigen::Index>(contacts.size()));
    for (std::size_t i = 0; i < contacts.size(); ++i) gaps[static_cast<Eigen::Index>(i)] = contacts[i].offset;
    const Column shift = factor_->transposed * factor_->multipliers(-gaps);
    std::vector<Vec3> out;
    for (std::size_t k = 0; k < factor_->inverse_masses.size(); ++k)
        out.emplace_back(std::sqrt(factor_->inverse_masses[k]) * shift.segment<3>(static_cast<Eigen::Index>(3 * k)));
    return out;
}

std::optional<Statics> statics(const std::vector<HalfSpace>& contacts, const std::vector<Vec3>& accelerations,
                               const std::vector<double>& inverse_masses)
{
    const CarryingContacts factor(contacts, inverse_masses);
    const std::optional<CarriedForces> carried = factor.forces(accelerations);
    if (!carried) return {};
    return Statics{carried->forces, carried->residual, factor.displacement(contacts)};
}

}  // namespace carom
