/// \file
/// Projected relaxation of many contacts, there and back again, with acceleration, where it is still needed.
#pragma once

#include <carom/types.hpp>

#include <vector>

namespace carom {

/// The rate normal.(u_a - u_b) of a contact and what is wanted of it.
struct RelaxationRow {
    int a = 0, b = 0;                   ///< velocities; one that nothing may change has weight 0
    Vec3 normal = Vec3::UnitZ();        ///< unit, towards a
    double weight_a = 0, weight_b = 0;  ///< inverse masses, not both 0
    double wanted = 0;                  ///< [velocity] least rate
    double least = 0;                   ///< [velocity] rate below which bodies would overlap, <= wanted
    double multiplier = 0;              ///< [impulse] >= 0; where to begin, and the result
    double change = 0, search = 0;      ///< of the multiplier, scratch
};

inline double rate(const RelaxationRow& row, const std::vector<Vec3>& u)
{
    return row.normal.dot(u[static_cast<std::size_t>(row.a)] - u[static_cast<std::size_t>(row.b)]);
}

struct RelaxationOptions {
    double tolerance = 0;  ///< [velocity] by which rates may miss what is wanted
    int most_sweeps = 0;   ///< over the contacts that are still wrong
};

struct RelaxationReport {
    bool feasible = false;  ///< no rate is below `least`
    int sweeps = 0;
    long relaxations = 0;
};

/// Approaches the projection of u on the rates that are wanted, in the metric of kinetic energy (Hildreth's procedure;
/// gauss_seidel.hpp). Only contacts of bodies whose contacts are wrong are relaxed ("local relaxation"). Acceleration:
/// Silcowitz, Niebe and Erleben, A nonsmooth nonlinear conjugate gradient method for interactive contact force
/// problems, The Visual Computer 26 (2010), https://doi.org/10.1007/s00371-010-0502-6, known from its abstract and from
/// public code; the direction's restart where the residual grows is part of it.
/// \param rows in the order of the sweeps \param u holds the pushes of the rows' multipliers already
RelaxationReport relax(std::vector<RelaxationRow>& rows, std::vector<Vec3>& u, const RelaxationOptions& options);

}  // namespace carom
