/// \file
/// A cluster as a projection problem: velocities are the vectors, inverse masses their metric, contacts the
/// half-spaces.
#pragma once

#include "contact/contact.hpp"
#include "contact/tolerances.hpp"
#include "projection/half_space.hpp"

namespace carom {

/// The projection problem of a cluster: half-spaces c_i >= 0 in the order of the contacts, start = the velocities.
ProjectionProblem projection_problem(const ContactProblem& cluster);

double largest_speed(std::span<const Vec3> velocities);

/// Kinetic energy [mass speed^2]
double kinetic_energy(const ContactProblem& cluster, std::span<const Vec3> velocities);

std::vector<Vec3> velocities_before(const ContactProblem& cluster);

/// Velocities with impulses on a and -impulses on b added, in the order of the contacts.
std::vector<Vec3> velocities_after(const ContactProblem& cluster, std::vector<Vec3> velocities,
                                   std::span<const Vec3> impulses);

/// Whether no contact closes faster than `tolerance`, > 0 [length/time].
bool nothing_closes(const ContactProblem& cluster, std::span<const Vec3> velocities, double tolerance);

}  // namespace carom
