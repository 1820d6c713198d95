/// \file
/// Impulses and the velocities after them, between two spheres and at a plane (docs/impacts.md, section 1).
#pragma once

#include "stepping/bodies.hpp"
#include "stepping/contact.hpp"
#include "stepping/law_table.hpp"

namespace carom::stepping {

struct Impulse {
    Vec3 on_a = Vec3::Zero();  ///< -on_a acts on b [mass length/time]
    double normal = 0;         ///< its component along the contact's normal
};

/// Relative normal velocity of a contact: negative when approaching [length/time].
double normal_velocity(const Bodies& bodies, const Contact& contact);

/// The coefficients that hold for a contact.
const ContactLaw& law_of(const Bodies& bodies, const LawTable& laws, const Contact& contact);

/// The law's response, whether approaching or not.
/// Spheres: j = -(1+e) m_red v_n along n; with tangential < 1 also -(1-alpha) m_red v_t; then both velocities times
/// `attenuation`, which is not part of the impulse. Plane: v+ = alpha v_t - e v_n.
Impulse respond(Bodies& bodies, const LawTable& laws, const Contact& contact);

/// Mass that a change of relative velocity meets: m of the sphere at a wall, the reduced mass between spheres [mass].
double effective_mass(const Bodies& bodies, const Contact& contact);

/// impulse on a, -impulse on b.
void apply(Bodies& bodies, const Contact& contact, const Vec3& impulse);

/// The law's tangential factor and attenuation alone: -(1-alpha) m_red v_t on the relative tangential velocity, then
/// both velocities of two spheres times `attenuation`.
Impulse damp(Bodies& bodies, const Contact& contact, const ContactLaw& law);

/// Take away the normal component, and nothing else.
Impulse cancel_normal(Bodies& bodies, const Contact& contact);

}  // namespace carom::stepping
