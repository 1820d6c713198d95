/// \file
/// Symmetry of a state: how far it is from its own image in a plane.
#pragma once

#include <carom/scene.hpp>
#include <carom/simulate.hpp>

#include <span>

namespace carom::study {

/// Largest difference [1] of a sphere's image in the plane through 0 across `normal` from the sphere whose place is
/// nearest to that image: of places in smallest radii, of velocities in largest speeds at the start.
/// \pre normal is not 0; a state for each sphere, at least one
double mirror_difference(const Scene& scene, std::span<const BodyState> states, const Vec3& normal);

}  // namespace carom::study
