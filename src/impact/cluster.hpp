/// \file
/// Several contacts that share bodies, at one instant: what impact operators and contact forces are asked about.
#pragma once

#include <carom/types.hpp>

#include <vector>

namespace carom {

/// A body that can move.
struct ClusterBody {
    Vec3 velocity = Vec3::Zero();  ///< [length/time]; of force problems: its free acceleration [length/time^2]
    double inverse_mass = 1;       ///< > 0 [1/mass]
};

inline constexpr int immovable = -1;

struct ClusterContact {
    int a = 0;                   ///< index into Cluster::bodies
    int b = immovable;           ///< another one, or `immovable`: a plane, a fixed sphere
    Vec3 normal = Vec3::Zero();  ///< unit to rounding, from b to a
    double restitution = 1;      ///< e in [0, 1]
    double tangential = 1;       ///< alpha in [0, 1], acts where the contact gets an impulse
};

/// \invariant every body has a contact; two bodies share at most one
struct Cluster {
    std::vector<ClusterBody> bodies;
    std::vector<ClusterContact> contacts;
};

/// c_i = n_i.(v_a - v_b), closing when negative, from one velocity for each body [length/time].
inline double closing_rate(const ClusterContact& contact, const std::vector<Vec3>& velocities)
{
    const Vec3& a = velocities[static_cast<std::size_t>(contact.a)];
    if (contact.b == immovable) return contact.normal.dot(a);
    return contact.normal.dot(a - velocities[static_cast<std::size_t>(contact.b)]);
}

}  // namespace carom
