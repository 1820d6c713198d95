/// \file
/// What an impulse does to velocities: between two spheres, and at a plane (the handout's rules, IMPACTS section 1).
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

/// The law's response, whether approaching or not.
/// Spheres: j = -(1+e) m_red v_n along n; with tangential < 1 also -(1-alpha) m_red v_t; then both velocities times
/// `attenuation`, which is not part of the impulse. Plane: v+ = alpha v_t - e v_n.
Impulse respond(Bodies& bodies, const LawTable& laws, const Contact& contact);

/// Take away the normal component, and nothing else.
Impulse cancel_normal(Bodies& bodies, const Contact& contact);

}  // namespace carom::stepping
