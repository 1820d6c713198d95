/// \file
/// Motion of spheres in contacts that carry force while their normals turn, one step: power series of paths and forces.
///
/// With arms r_i = x_a - x_b (a plane: its normal n) and forces f_i r_i the equations are polynomial: x'' = g + sum of
/// f_i r_i / m, and r_i.r_i, or n.x_a, is constant. So each order of the series needs sums of products and one solution
/// of the same linear equations (a Taylor method for the index-reduced equations; this project). Drag adds -k x'.
#pragma once

#include "reference/group.hpp"
#include "reference/roots.hpp"

namespace carom::reference {

template <class Real>
struct Step {
    std::vector<std::vector<Vector<Real>>> paths;  ///< by body: coefficients of powers of time
    std::vector<Polynomial<Real>> forces;          ///< by link
    Real length;                                   ///< how long the series hold [time]
    bool dependent;                                ///< some contacts follow from others: their forces are not unique
};

/// The group's links with arms for normals.
template <class Real>
Group<Real> with_arms(Group<Real> g, const std::vector<Vector<Real>>& x)
{
    for (Link<Real>& l : g.links)
        if (l.bend != 0) l.n = x[l.a] - (l.b == immovable ? l.anchor : x[l.b]);
    return g;
}

/// Puts contacts back where they persist, and takes what is left of their rates: the drift of a step.
template <class Real>
void project(const Group<Real>& g, std::vector<Vector<Real>>& x, std::vector<Vector<Real>>& v)
{
    for (int k = 0; k < projections; ++k) {
        const Group<Real> now = with_arms(g, x);
        Numbers<Real> off;
        for (const Link<Real>& l : now.links)
            off.push_back(l.bend != 0 ? Real((dot(l.n, l.n) - l.level) / 2) : Real(dot(l.n, x[l.a]) - l.level));
        now.push(x, balance(now.coupling(), off, first(off.size())));
    }
    const Group<Real> now = with_arms(g, x);
    now.push(v, balance(now.coupling(), now.rates(v), first(now.links.size())));
}

/// The time for which coefficients fade: until the last two are below the tolerance.
template <class Real>
Real fades(const std::vector<Vector<Real>>& path, const Real& radius, const Real& most)
{
    Real length = most;
    for (std::size_t k = path.size() - 2; k < path.size(); ++k) {
        const Real last = size(path[k]);
        if (last > 0) length = std::min<Real>(length, pow(Real(step_tolerance<Real> * radius / last), 1 / Real(k)));
    }
    return length;
}

/// \param most longest step wanted [time]
template <class Real>
Step<Real> step(const Group<Real>& group, const std::vector<Vector<Real>>& x, const std::vector<Vector<Real>>& v,
                const Field<Real>& field, const Numbers<Real>& radii, Real most)
{
    if (field.drag > 0) most = std::min<Real>(most, 1 / field.drag);  // see Flight::coefficients
    const Group<Real> g = with_arms(group, x);
    const std::size_t m = g.links.size(), n = g.bodies.size();
    const Factor<Real> factor(g.coupling(), first(m));
    Step<Real> out{{}, std::vector<Polynomial<Real>>(m), most, factor.dependent_rows()};
    for (std::size_t b = 0; b < n; ++b) out.paths.push_back({x[b], v[b]});
    std::vector<std::vector<Vector<Real>>> arms(m);
    const auto extend = [&](std::size_t i, std::size_t k) {
        const Link<Real>& l = g.links[i];
        if (l.bend != 0)
            arms[i].push_back(l.b == immovable ? out.paths[l.a][k] : out.paths[l.a][k] - out.paths[l.b][k]);
    };
    for (std::size_t i = 0; i < m; ++i) arms[i].push_back(g.links[i].n), extend(i, 1);
    for (std::size_t k = 0; k + 2 < step_terms<Real>; ++k) {
        std::vector<Vector<Real>> a(n, k == 0 ? field.gravity : Vector<Real>());
        for (std::size_t b = 0; b < n && field.drag > 0; ++b)
            a[b] = a[b] - out.paths[b][k + 1] * (field.drag * static_cast<int>(k + 1));
        for (std::size_t i = 0; i < m; ++i) {
            Vector<Real> push;
            for (std::size_t j = 0; j < k && g.links[i].bend != 0; ++j) push = push + arms[i][k - j] * out.forces[i][j];
            if (k > 0) g.push(a, g.links[i], push);
        }
        Numbers<Real> off = g.rates(a);
        const int powers = static_cast<int>((k + 1) * (k + 2));
        for (std::size_t i = 0; i < m; ++i) {
            Real sum = 0;  // of r.r / 2 at order k + 2
            for (std::size_t j = 1; j <= k + 1 && g.links[i].bend != 0; ++j) sum += dot(arms[i][j], arms[i][k + 2 - j]);
            off[i] += sum * powers / 2;
        }
        const Numbers<Real> force = factor.balance(off);
        g.push(a, force);
        for (std::size_t b = 0; b < n; ++b) out.paths[b].push_back(a[b] * (1 / Real(powers)));
        for (std::size_t i = 0; i < m; ++i) out.forces[i].push_back(force[i]), extend(i, k + 2);
    }
    for (std::size_t b = 0; b < n; ++b) out.length = std::min<Real>(out.length, fades(out.paths[b], radii[b], most));
    return out;
}

}  // namespace carom::reference
