/// \file
/// The impact law of a single contact: velocities before, impulse out. Formulas: course handout (plane response,
/// sphere-sphere impulse).
#pragma once

#include <carom/scene.hpp>

namespace carom {

/// One side of a contact. A plane has inverse mass 0.
struct ImpactSide {
    Vec3 velocity = Vec3::Zero();  ///< [length/time]
    double inverse_mass = 0;       ///< [1/mass]
};

struct PairImpact {
    Vec3 velocity_a, velocity_b;  ///< after [length/time]
    Vec3 impulse;                 ///< on a, of the exchange alone: attenuation comes after it [mass length/time]
};

/// v_n+ = -e v_n on the relative velocity, shared by mass; tangential impulse -(1 - alpha) m_red v_t; then both
/// velocities times `attenuation`. \param normal from b to a, of any length > 0; \pre at most one inverse mass is 0; a
/// approaches b or touches it at speed 0.
PairImpact resolve_pair(const ImpactSide& a, const ImpactSide& b, const Vec3& normal, const ContactLaw& law);

}  // namespace carom
