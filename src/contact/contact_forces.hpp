/// \file
/// Forces in persistent contacts.
#pragma once

#include "contact/contact.hpp"
#include "projection/project.hpp"

namespace carom {

struct ContactForces {
    std::vector<double> forces;       ///< lambda, by contact, >= 0 [mass length/time^2]
    std::vector<Vec3> accelerations;  ///< by body, forces included [length/time^2]
    std::vector<double> gap_rates;    ///< y = d2 gap / dt2, by contact; 0 where the contact carries [length/time^2]
};

/// Forces lambda with 0 <= lambda _|_ G lambda + q >= 0 (docs/impacts.md, section 6), q_i = n_i.(a_a - a_b) +
/// curvature_i, where ContactBody::velocity is the acceleration without contacts. Always solvable for curvature >= 0;
/// accelerations are unique, forces need not be.
/// \param curvature by contact: |w_t|^2 / (r_a + r_b) of two spheres with tangential relative velocity w_t, 0 at
/// planes, >= 0 [length/time^2]
/// \param guess forces by contact from which to begin, such as those of a moment ago: saves time where there are many
/// contacts, and changes nothing beyond rounding
ContactForces solve_contact_forces(const ContactProblem& cluster, std::span<const double> curvature, Guess guess = {});

}  // namespace carom
