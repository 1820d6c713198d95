/// \file
/// The impact law of a single contact: velocities before, impulse out. Formulas: docs/impacts.md, section 1.
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

/// The change of a relative velocity in an impact: v_n+ = -e v_n, v_t+ = alpha v_t. \returns after - before
/// \param normal of any length > 0
inline Vec3 velocity_change(const Vec3& relative, const Vec3& normal, const ContactLaw& law)
{
    const Vec3 along = (relative.dot(normal) / normal.squaredNorm()) * normal;
    Vec3 change = -(1 + law.restitution) * along;
    if (law.tangential != 1) change -= (1 - law.tangential) * (relative - along);
    return change;
}

/// The impact of two bodies: the change of their relative velocity, shared by mass; then both velocities times
/// `attenuation`. \param normal from b to a, of any length > 0; \pre at most one inverse mass is 0; a approaches b or
/// touches it at speed 0.
inline PairImpact resolve_pair(const ImpactSide& a, const ImpactSide& b, const Vec3& normal, const ContactLaw& law)
{
    const double reduced_mass = 1 / (a.inverse_mass + b.inverse_mass);
    const Vec3 change = velocity_change(a.velocity - b.velocity, normal, law);
    PairImpact out;
    out.impulse = reduced_mass * change;
    // Against a body that never moves the mass cancels, and must not cost a rounding.
    out.velocity_a =
        b.inverse_mass == 0 ? Vec3(a.velocity + change) : Vec3(a.velocity + (reduced_mass * a.inverse_mass) * change);
    out.velocity_b = b.inverse_mass == 0   ? b.velocity
                     : a.inverse_mass == 0 ? Vec3(b.velocity - change)
                                           : Vec3(b.velocity - (reduced_mass * b.inverse_mass) * change);
    if (law.attenuation != 1) {
        out.velocity_a *= law.attenuation;
        out.velocity_b *= law.attenuation;
    }
    return out;
}

}  // namespace carom
