#include "impact/pair_law.hpp"

#include <cmath>

namespace carom {

PairImpact resolve_pair(const ImpactSide& a, const ImpactSide& b, const Vec3& normal, const ContactLaw& law)
{
    const double reduced_mass = 1 / (a.inverse_mass + b.inverse_mass);
    const Vec3 relative = a.velocity - b.velocity;
    const Vec3 along = (relative.dot(normal) / normal.squaredNorm()) * normal;
    // For two bodies (1 + e) m_red; against a plane the mass cancels, and must not cost a rounding.
    Vec3 change = -(1 + law.restitution) * along;
    if (law.tangential != 1) change -= (1 - law.tangential) * (relative - along);
    PairImpact out;
    out.impulse = reduced_mass * change;
    out.velocity_a =
        b.inverse_mass == 0 ? Vec3(a.velocity + change) : Vec3(a.velocity + (reduced_mass * a.inverse_mass) * change);
    if (a.inverse_mass == 0) out.velocity_a = a.velocity;
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
