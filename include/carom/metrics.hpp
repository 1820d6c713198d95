/// \file
/// Figures of a state: conserved quantities, overlaps, spheres outside, distance of two states.
///
/// \pre everywhere: the scene is valid, `states` are one for each of its spheres, in body order; of two lists both are
/// of one length. Sums are compensated. A state that is not finite makes a figure that is not, unless said otherwise.
/// Link `carom::study`.
#pragma once

#include <carom/scene.hpp>
#include <carom/simulate.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace carom {

/// The states that the scene starts from, in body order.
std::vector<BodyState> initial_states(const Scene& scene);

/// sum m v^2 / 2 [mass length^2/time^2].
double kinetic_energy(const Scene& scene, std::span<const BodyState> states);

/// sum m (v^2/2 - g.x) over the spheres that can move [mass length^2/time^2], x relative to the scene's origin.
double total_energy(const Scene& scene, std::span<const BodyState> states);

/// total_energy(scene, a) - total_energy(scene, b), body by body, so that nothing is lost where both are large.
double energy_difference(const Scene& scene, std::span<const BodyState> a, std::span<const BodyState> b);

/// sum m v [mass length/time].
Vec3 momentum(const Scene& scene, std::span<const BodyState> states);

/// Deepest overlap of two spheres, or of a sphere and a plane, >= 0 [length], in time proportional to spheres and
/// overlaps (a grid for each size class). Two bodies that cannot move overlap as they like, and bodies with a
/// non-finite state are left out.
double max_penetration(const Scene& scene, std::span<const BodyState> states);

/// Spheres that can move and whose centre is outside a half-space (plates have no outside), or whose state is not
/// finite.
std::int64_t escaped(const Scene& scene, std::span<const BodyState> states);

/// Distance of two lists of vectors, body by body; 0 for empty lists.
struct Deviation {
    double rms = 0;  ///< root of the mean over bodies of the squared distance
    double max = 0;  ///< largest distance
};
Deviation position_deviation(std::span<const BodyState> a, std::span<const BodyState> b);  ///< [length]
Deviation velocity_deviation(std::span<const BodyState> a, std::span<const BodyState> b);  ///< [length/time]

/// Whether every contact that can occur has restitution, tangential factor and attenuation 1, so that contacts keep
/// energy. A contact needs a sphere that can move.
bool contacts_conserve_energy(const Scene& scene);

/// Whether contacts keep energy and there is no drag to take it.
bool conserves_energy(const Scene& scene);

/// Smallest radius; 0 for a scene without spheres [length].
double smallest_radius(const Scene& scene);

}  // namespace carom
