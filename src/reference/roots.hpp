/// \file
/// First instants of contact. The rule is the same for all: outside (f > 0) the first down-crossing of f; closed (f <=
/// 0) now if f falls, otherwise not now. After an impact f is rounding and not 0: it is snapped to 0, and that root
/// divided out.
#pragma once

#include "reference/polynomial.hpp"
#include "reference/vector.hpp"

#include <algorithm>
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
    if (c <= 0) return b * b > rounding_square * rr * vv ? std::optional<Real>(0) : std::nullopt;
    const Real d = b * b - vv * c;
    if (d <= 0) return std::nullopt;
    ++roots;
    return c / (sqrt(d) - b);
}

/// Whether f = p, with what is rounding snapped to 0, begins to fall from 0 or below.
template <class Real>
bool falls_at_once(const Polynomial<Real>& p)
{
    if (p[0] > 0) return false;
    const auto first = std::find_if(p.begin() + 1, p.end(), [](const Real& c) { return c != 0; });
    return first != p.end() && *first < 0;
}

/// p without its roots at 0. \pre not all of it is 0
template <class Real>
Polynomial<Real> opened(Polynomial<Real> p)
{
    p.erase(p.begin(), std::find_if(p.begin(), p.end(), [](const Real& c) { return c != 0; }));
    return p;
}

/// |a - b|^2 - sum^2 of two paths, its first two coefficients snapped.
template <class Real>
Polynomial<Real> gap_of_squares(std::vector<Vector<Real>> a, const std::vector<Vector<Real>>& b, const Real& sum)
{
    a.resize(std::max(a.size(), b.size()));
    for (std::size_t k = 0; k < b.size(); ++k) a[k] = a[k] - b[k];
    Polynomial<Real> p(2 * a.size() - 1, Real(0));
    for (std::size_t i = 0; i < a.size(); ++i)
        for (std::size_t j = 0; j < a.size(); ++j) p[i + j] += dot(a[i], a[j]);
    p[0] = snapped(p[0] - sum * sum, sum * sum);
    p[1] = snapped(p[1], sum * size(a[1]));
    return p;
}

/// First t in [0, end] at which a gap with these coefficients closes, as a step of constrained motion has it.
/// \param scale of the gap; its first two coefficients are snapped
template <class Real>
std::optional<Real> path_contact(Polynomial<Real> p, const Real& scale, const Real& end, std::int64_t& roots)
{
    Real power = end * end, most = 0;
    for (std::size_t k = 3; k < p.size(); ++k) {
        power *= end;
        if (abs(p[k]) * power <= rounding * scale) p[k] = 0;
        most = std::max<Real>(most, abs(p[k]) * power);
    }
    const Real turn = abs(p[2]) * end * end;
    if (p[0] <= 0 && p[1] == 0 && (turn <= sign_change * most || turn <= rounding * scale)) p[2] = 0;
    if (std::all_of(p.begin(), p.end(), [](const Real& c) { return c == 0; })) return std::nullopt;
    if (falls_at_once(p)) return Real(0);
    return first_fall(opened(p), end, roots);
}

}  // namespace carom::reference
