/// \file
/// Forces of contacts that carry, and the shortest displacement that closes their gaps, from one sparse factor.
#pragma once

#include "projection/half_space.hpp"

#include <memory>

namespace carom {

struct CarriedForces {
    std::vector<double> forces;  ///< [force] by contact: they leave the least acceleration
    double residual = 0;         ///< [acceleration] largest of a body under its load and the forces
};

/// The sparse factor of contacts that carry: their forces under any number of loads.
class CarryingContacts {
public:
    /// \param inverse_masses > 0
    CarryingContacts(const std::vector<HalfSpace>& contacts, const std::vector<double>& inverse_masses);
    ~CarryingContacts();
    /// \param accelerations of bodies without contacts [acceleration]
    /// \returns nothing where the normals depend on each other beyond what regularisation bears
    std::optional<CarriedForces> forces(const std::vector<Vec3>& accelerations) const;
    /// By body: shortest in the metric of mass that makes the offsets of the contacts 0.
    std::vector<Vec3> displacement(const std::vector<HalfSpace>& contacts) const;

private:
    struct Factor;
    std::unique_ptr<Factor> factor_;
};

struct Statics {
    std::vector<double> forces;      ///< [force] by half-space: they leave the least acceleration
    double residual = 0;             ///< [acceleration] largest of a body under its load and the forces
    std::vector<Vec3> displacement;  ///< by body: shortest in the metric of mass that makes the offsets 0
};

/// \param contacts those that carry; offsets are gaps [length]
/// \param accelerations of bodies without contacts [acceleration] \param inverse_masses > 0
/// \returns nothing where the normals depend on each other beyond what regularisation bears
std::optional<Statics> statics(const std::vector<HalfSpace>& contacts, const std::vector<Vec3>& accelerations,
                               const std::vector<double>& inverse_masses);

}  // namespace carom
