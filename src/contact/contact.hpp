/// \file
/// Contacts that share bodies, at one instant: one description from the look around a body to the books of the run.
#pragma once

#include "core/partner.hpp"

#include <optional>
#include <vector>

namespace carom {

/// A body that can move.
struct ContactBody {
    Vec3 velocity = Vec3::Zero();  ///< [length/time]; of force problems: its free acceleration [length/time^2]
    double inverse_mass = 1;       ///< > 0 [1/mass]
    BodyId id = no_body;           ///< in the scene
};

/// The index of what does not move: a plane, a fixed sphere.
inline constexpr std::optional<int> immovable;

struct Contact {
    int a = 0;                         ///< index into ContactProblem::bodies
    std::optional<int> b = immovable;  ///< of another body, or `immovable`
    Vec3 normal = Vec3::Zero();        ///< unit to rounding, from b to a
    double restitution = 1;            ///< e in [0, 1]
    double tangential = 1;             ///< alpha in [0, 1], acts where the contact gets an impulse
    Partner partner{};                 ///< b in the scene
    double gap = 0;                    ///< [length]
    bool persistent = false;           ///< it was closed before this instant
};

/// \invariant every body has a contact; two bodies share at most one
struct ContactProblem {
    std::vector<ContactBody> bodies;
    std::vector<Contact> contacts;
};

/// c_i = n_i.(v_a - v_b), closing when negative, from one velocity for each body [length/time].
inline double closing_rate(const Contact& contact, const std::vector<Vec3>& velocities)
{
    const Vec3& a = velocities[static_cast<std::size_t>(contact.a)];
    if (!contact.b) return contact.normal.dot(a);
    return contact.normal.dot(a - velocities[static_cast<std::size_t>(*contact.b)]);
}

}  // namespace carom
