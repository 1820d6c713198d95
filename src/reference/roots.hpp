/// \file
/// First instants of contact. The rule is the same for both: outside (f > 0) the first down-crossing of f; closed (f <=
/// 0) now if f falls, otherwise not now. After an impact f is rounding and not 0: it is snapped to 0, and that root
/// divided out.
#pragma once

#include "reference/vector.hpp"

#include <cstdint>
#include <optional>

namespace carom::reference {

/// First t >= 0 at which the gap h + w t + g t^2/2 of a sphere and a plane closes. Closed, still and pressed (h <= 0, w
/// = 0, g < 0) gives 0: a contact that needs a force. `roots` counts square roots.
template <class Real>
std::optional<Real> plane_contact(const Real& h, const Real& w, const Real& g, std::int64_t& roots)
{
    if (h <= 0) {
        if (w < 0 || (w == 0 && g < 0)) return Real(0);
        if (g >= 0) return std::nullopt;
        if (h == 0) return 2 * w / -g;
    }
    if (g == 0) return w < 0 ? std::optional<Real>(-h / w) : std::nullopt;
    if (g > 0 && w >= 0) return std::nullopt;
    const Real d = w * w - 2 * g * h;
    if (h < 0 && d <= 0) return w / -g;  // turns while still inside
    if (d <= 0) return std::nullopt;     // turns outside; a double root is a graze, not a contact
    ++roots;
    const Real s = sqrt(d);
    return w > 0 ? (w + s) / -g : 2 * h / (s - w);
}

/// First t >= 0 at which |r + v t| = sum and falling: spheres under one acceleration, in which |r + v t|^2 is convex,
/// so that a closed pair that separates never meets again by itself.
template <class Real>
std::optional<Real> sphere_contact(const Vector<Real>& r, const Vector<Real>& v, const Real& sum, std::int64_t& roots)
{
    const Real b = dot(r, v), rr = dot(r, r), vv = dot(v, v), sum2 = sum * sum;
    if (b >= 0) return std::nullopt;
    const Real c = snapped(Real(rr - sum2), sum2);
    if (c <= 0) return b * b > 1e-60 * rr * vv ? std::optional<Real>(0) : std::nullopt;
    const Real d = b * b - vv * c;
    if (d <= 0) return std::nullopt;
    ++roots;
    return c / (sqrt(d) - b);
}

}  // namespace carom::reference
