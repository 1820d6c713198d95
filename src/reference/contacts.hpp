/// \file
/// The spheres of a run, where they touch each other and planes, and which of these contacts persist.
#pragma once

#include "reference/group.hpp"
#include "reference/quartic.hpp"
#include "reference/roots.hpp"

#include <algorithm>
#include <set>

namespace carom::reference {

using Pair = std::pair<BodyId, BodyId>;  ///< the smaller id first

template <class Real>
class Contacts {
public:
    Contacts(const Scene& scene, Patience& patience) : scene_(scene), rest_(rest_thresholds(scene)), patience_(patience)
    {
        for (const Sphere& s : scene.spheres) balls_.emplace_back(s, Vector<Real>(scene.gravity));
        patience_.begin("reference: contacts at the start", count(), "spheres");
        for (BodyId i = 0; i < count() && patience_.lasts(i); ++i) declare(i);
    }

    BodyId count() const { return static_cast<BodyId>(balls_.size()); }
    BodyId bodies() const { return scene_.plane_body(scene_.planes.size()); }
    bool fixed(BodyId b) const { return b >= count() || balls_[b].fixed; }
    Ball<Real>& operator[](BodyId i) { return balls_[i]; }
    const Ball<Real>& operator[](BodyId i) const { return balls_[i]; }
    Face<Real> face(BodyId p, const Ball<Real>& ball) const { return {scene_.planes[p - count()], ball}; }
    Approach approach(BodyId i, BodyId j, double t) const { return {balls_[i].shadow, balls_[j].shadow, t}; }

    static Pair pair(BodyId a, BodyId b) { return {std::min(a, b), std::max(a, b)}; }
    static Pair pair(const Group<Real>& g, const Link<Real>& l) { return pair(g.bodies[l.a], l.partner); }
    /// Whether this contact persists.
    bool held(BodyId i, BodyId j) const { return !held_.empty() && held_.count(pair(i, j)) > 0; }
    void hold(const Pair& p) { held_.insert(p); }
    void release(const Pair& p) { held_.erase(p); }
    bool supported(BodyId i) const
    {
        return std::any_of(held_.begin(), held_.end(), [i](const Pair& p) { return p.first == i || p.second == i; });
    }

    /// Slower than this, a contact is still [length/time].
    Real slow(const Vector<Real>& v, const Vector<Real>& u) const
    {
        return still * rest_.closing_speed + still_rounding * (size(v) + size(u));
    }

    /// What persistent contacts, and those closed at t, link to the first bodies, which move.
    Group<Real> group(std::vector<BodyId> first, const Real& t) const
    {
        Group<Real> g{std::move(first), {}, {}};
        const double tolerance = scene_.impact.tie.value_or(tie);
        for (std::size_t a = 0; a < g.bodies.size() && patience_.lasts(); ++a) {
            const BodyId i = g.bodies[a];
            g.lightness.push_back(1 / balls_[i].mass);
            for (BodyId j = 0; j < bodies(); ++j) {
                const auto found = std::find(g.bodies.begin(), g.bodies.end(), j);
                const auto b = static_cast<std::size_t>(found - g.bodies.begin());
                if (b <= a || !(held(i, j) || touch(i, j, t, tolerance))) continue;
                g.links.push_back(link(i, j, t));
                g.links.back().a = a;
                if (fixed(j)) continue;
                g.links.back().b = b;
                if (found == g.bodies.end()) g.bodies.push_back(j);
            }
        }
        return g;
    }
    std::vector<Vector<Real>> velocities(const Group<Real>& g, const Real& t) const
    {
        std::vector<Vector<Real>> v;
        for (const BodyId i : g.bodies) v.push_back(balls_[i].flight.velocity(t));
        return v;
    }

    /// The earliest contact of sphere i, before `until`, with a plane or one of the first spheres: its `next` and
    /// `partner`. Planes first: they are near.
    void predict(BodyId i, const Real& now, const Real& until, BodyId spheres, std::int64_t& root_solves)
    {
        Ball<Real>& ball = balls_[i];
        ball.partner = no_body;
        ball.next = until;
        const double now_rounded = static_cast<double>(now);
        double horizon = static_cast<double>(Real(until - now));
        for (BodyId k = count(), end = bodies() + spheres; k < end; ++k) {
            const BodyId j = k < bodies() ? k : k - bodies();
            if (j == i || (ball.fixed && fixed(j)) || held(i, j)) continue;
            if (j < count() && approach(i, j, now_rounded).misses(horizon)) continue;
            if (!patience_.lasts()) return;
            const std::optional<Real> dt = contact_in(i, j, now, until, root_solves);
            if (!dt || now + *dt > ball.next || (now + *dt == ball.next && ball.partner != no_body)) continue;
            ball.next = now + *dt;
            ball.partner = j;
            horizon = static_cast<double>(*dt);
        }
    }

    /// Time from now to the next contact of sphere i with body j, if there is one before `until`.
    std::optional<Real> contact_in(BodyId i, BodyId j, const Real& now, const Real& until,
                                   std::int64_t& root_solves) const
    {
        const Flight<Real>& f = balls_[i].flight;
        const double pull = scene_.gravity.lpNorm<1>();
        const Vector<Real> x = f.position(now), v = f.velocity(now);
        if (j < count()) {
            const Flight<Real>& other = balls_[j].flight;
            const Vector<Real> u = other.velocity(now), r = x - other.position(now), a = f.a - other.a;
            const Vector<Real> w = size(v - u) <= 1e-30 * (size(v) + size(u)) ? Vector<Real>() : v - u;
            const Real sum = balls_[i].radius + balls_[j].radius;
            if (size(a) <= 1e-30 * pull) return sphere_contact<Real>(r, w, sum, root_solves);
            return accelerated_contact<Real>(r, w, a, sum, 2 * (until - now), root_solves);  // the end is in it
        }
        const Face<Real> p = face(j, balls_[i]);
        return plane_contact(snapped(p.gap(x), balls_[i].radius), snapped(dot(p.n, v), size(v)),
                             snapped(dot(p.n, f.a), Real(pull)), root_solves);
    }

private:
    /// Contacts of i that are closed and still at the start.
    void declare(BodyId i)
    {
        for (BodyId j = 0; j < bodies(); ++j) {
            if (balls_[i].fixed || (j <= i && !fixed(j)) || !touch(i, j, 0, declared_tie)) continue;
            const Vector<Real> v = balls_[i].flight.v, u = j < count() ? balls_[j].flight.v : Vector<Real>();
            if (abs(dot(link(i, j, 0).n, v - u)) <= slow(v, u)) held_.insert(pair(i, j));
        }
    }

    /// Whether i and j are closer than `tolerance` times the smaller radius at t.
    bool touch(BodyId i, BodyId j, const Real& t, double tolerance) const
    {
        const Ball<Real>& ball = balls_[i];
        const Vector<Real> x = ball.flight.position(t);
        if (j >= count()) return face(j, ball).gap(x) <= tolerance * ball.radius;
        const double reach = tolerance * std::min(ball.shadow.radius, balls_[j].shadow.radius);
        if (approach(i, j, static_cast<double>(t)).apart(reach)) return false;
        const Vector<Real> r = x - balls_[j].flight.position(t);
        return sqrt(dot(r, r)) - ball.radius - balls_[j].radius <= reach;
    }

    /// Contact of sphere i with body j; places in a group are left to it.
    Link<Real> link(BodyId i, BodyId j, const Real& t) const
    {
        const Ball<Real>& ball = balls_[i];
        const Vector<Real> r = j < count() ? ball.flight.position(t) - balls_[j].flight.position(t) : face(j, ball).n;
        return {immovable,
                immovable,
                j,
                r * (1 / sqrt(dot(r, r))),
                j < count() ? Real(1 / (ball.radius + balls_[j].radius)) : Real(0),
                contact_law(scene_, i, j)};
    }

    const Scene& scene_;
    RestThresholds rest_;
    Patience& patience_;
    std::vector<Ball<Real>> balls_;
    std::set<Pair> held_;
};

}  // namespace carom::reference
