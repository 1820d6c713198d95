/// \file
/// Spheres that contacts link at one instant, and what impulses or forces in these contacts do to them.
#pragma once

#include "reference/bodies.hpp"
#include "reference/cone.hpp"

#include <algorithm>
#include <set>

namespace carom::reference {

inline constexpr std::size_t immovable = std::numeric_limits<std::size_t>::max();

/// Contact of the group's sphere a with its sphere b, or with a plane or fixed sphere.
template <class Real>
struct Link {
    std::size_t a, b;  ///< places in Group::bodies
    BodyId partner;    ///< of a
    Vector<Real> n;    ///< unit, from b to a
    Real bend;         ///< 1 / (r_a + r_b), 0 at planes
    ContactLaw law;
    Vector<Real> anchor;  ///< centre of a fixed sphere b
    Real level;           ///< what persists: n.x of a plane, squared distance of spheres
};

template <class Real>
struct Group {
    std::vector<BodyId> bodies;
    Numbers<Real> lightness;  ///< 1/m
    std::vector<Link<Real>> links;

    using Vectors = std::vector<Vector<Real>>;

    bool has(BodyId body) const { return std::find(bodies.begin(), bodies.end(), body) != bodies.end(); }
    /// Its bodies and what they touch.
    std::vector<BodyId> everybody() const
    {
        std::set<BodyId> all(bodies.begin(), bodies.end());
        for (const Link<Real>& l : links) all.insert(l.partner);
        return {all.begin(), all.end()};
    }

    /// Of a seen from b.
    Vector<Real> relative(const Link<Real>& l, const Vectors& v) const
    {
        return l.b == immovable ? v[l.a] : v[l.a] - v[l.b];
    }
    Numbers<Real> rates(const Vectors& v) const
    {
        Numbers<Real> c;
        for (const Link<Real>& l : links) c.push_back(dot(l.n, relative(l, v)));
        return c;
    }
    /// Impulses j on a, -j on b.
    void push(Vectors& v, const Link<Real>& l, const Vector<Real>& j) const
    {
        v[l.a] = v[l.a] + j * lightness[l.a];
        if (l.b != immovable) v[l.b] = v[l.b] - j * lightness[l.b];
    }
    void push(Vectors& v, const Numbers<Real>& x) const
    {
        for (std::size_t i = 0; i < links.size(); ++i) push(v, links[i], links[i].n * x[i]);
    }
    Real reduced_mass(const Link<Real>& l) const
    {
        return 1 / (l.b == immovable ? lightness[l.a] : Real(lightness[l.a] + lightness[l.b]));
    }
    /// G = N^T M^-1 N.
    Matrix<Real> coupling() const
    {
        Matrix<Real> G(links.size(), Numbers<Real>(links.size(), Real(0)));
        for (std::size_t i = 0; i < links.size(); ++i) {
            const auto on = [&](std::size_t body, const Link<Real>& l) {
                return Real(body == immovable ? 0 : body == l.a ? 1 : body == l.b ? -1 : 0);
            };
            const Link<Real>& l = links[i];
            for (std::size_t j = 0; j < links.size(); ++j) {
                const Link<Real>& k = links[j];
                Real shared = on(l.a, k) * lightness[l.a];
                if (l.b != immovable) shared -= on(l.b, k) * lightness[l.b];
                if (shared != 0) G[i][j] = shared * dot(l.n, k.n);
            }
        }
        return G;
    }
};

/// Largest of the speeds (as `size` takes it).
template <class Real>
Real largest(const std::vector<Vector<Real>>& v)
{
    Real most = 0;
    for (const Vector<Real>& each : v) most = std::max<Real>(most, size(each));
    return most;
}

/// Bodies of the group that its links connect, part by part, each with its links.
template <class Real>
std::vector<Group<Real>> parts(const Group<Real>& g)
{
    std::vector<std::size_t> root = first(g.bodies.size());
    for (const Link<Real>& l : g.links)
        if (l.b != immovable) std::replace(root.begin(), root.end(), std::size_t(root[l.b]), std::size_t(root[l.a]));
    std::vector<Group<Real>> out;
    for (std::size_t r = 0; r < root.size(); ++r) {
        Group<Real> part;
        std::vector<std::size_t> place(root.size(), immovable);
        for (std::size_t k = 0; k < root.size(); ++k) {
            if (root[k] != r) continue;
            place[k] = part.bodies.size();
            part.bodies.push_back(g.bodies[k]);
            part.lightness.push_back(g.lightness[k]);
        }
        for (Link<Real> l : g.links) {
            if (root[l.a] != r) continue;
            l.a = place[l.a];
            if (l.b != immovable) l.b = place[l.b];
            part.links.push_back(std::move(l));
        }
        if (!part.bodies.empty()) out.push_back(std::move(part));
    }
    return out;
}

}  // namespace carom::reference
