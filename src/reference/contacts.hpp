/// \file
/// The spheres of a run, where they touch each other and planes, and which of these contacts persist.
#pragma once

#include "reference/damped_contact.hpp"
#include "reference/group.hpp"

#include <algorithm>
#include <map>
#include <set>

namespace carom::reference {

using Pair = std::pair<BodyId, BodyId>;  ///< the smaller id first

template <class Real>
class Contacts {
public:
    Contacts(const Scene& scene, Patience& patience) : scene_(scene), patience_(patience)
    {
        const Field<Real> field{Vector<Real>(scene.gravity), scene.drag};
        for (const Sphere& s : scene.spheres) balls_.emplace_back(s, field);
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
    void hold(const Group<Real>& g, const Link<Real>& l)
    {
        held_[pair(g, l)] = l.level;
        bounced_.erase(pair(g, l));
    }
    void release(const Pair& p) { held_.erase(p); }
    /// Whether the last contact of these was a bounce.
    bool bounced(const Pair& p) const { return bounced_.count(p) > 0; }
    void bounce(const Pair& p) { bounced_.insert(p); }
    bool supported(BodyId i) const
    {
        return std::any_of(held_.begin(), held_.end(),
                           [i](const auto& p) { return p.first.first == i || p.first.second == i; });
    }

    /// Slower than this, a contact's bounces are over [length/time].
    Real lowest_speed(BodyId i, BodyId j) const
    {
        return rest_speed<Real> * (j < count() ? Real(balls_[i].fastest + balls_[j].fastest) : balls_[i].fastest);
    }

    /// Bodies that persistent contacts link to the first ones, which move, and the contact that closes at t if one
    /// does, with those that belong to its instant.
    Group<Real> group(const std::vector<BodyId>& first, const Real& t, const std::optional<Pair>& closes) const
    {
        Real speed = 0;
        if (closes)
            speed =
                fixed(closes->first) ? rate(closes->second, closes->first, t) : rate(closes->first, closes->second, t);
        Group<Real> g{first, {}, {}};
        for (std::size_t a = 0; a < g.bodies.size() && patience_.lasts(); ++a) {
            const BodyId i = g.bodies[a];
            g.lightness.push_back(1 / balls_[i].mass);
            for (BodyId j = 0; j < bodies(); ++j) {
                const auto found = std::find(g.bodies.begin(), g.bodies.end(), j);
                const auto b = static_cast<std::size_t>(found - g.bodies.begin());
                if (b <= a || !(held(i, j) || (closes && (*closes == pair(i, j) || joins(i, j, t, Real(abs(speed)))))))
                    continue;
                g.links.push_back(link(i, j, t));
                g.links.back().a = a;
                if (fixed(j)) continue;
                g.links.back().b = b;
                if (found == g.bodies.end()) g.bodies.push_back(j);
            }
        }
        std::sort(g.links.begin(), g.links.end(), [&g](const Link<Real>& l, const Link<Real>& k) {
            const auto key = [&g](const Link<Real>& x) {
                const BodyId a = g.bodies[x.a];
                return x.b == immovable ? std::pair(a, x.partner) : pair(a, x.partner);
            };
            return key(l) < key(k);
        });
        return g;
    }
    std::vector<Vector<Real>> positions(const Group<Real>& g, const Real& t) const
    {
        std::vector<Vector<Real>> x;
        for (const BodyId i : g.bodies) x.push_back(balls_[i].flight.position(t));
        return x;
    }
    std::vector<Vector<Real>> velocities(const Group<Real>& g, const Real& t) const
    {
        std::vector<Vector<Real>> v;
        for (const BodyId i : g.bodies) v.push_back(balls_[i].flight.velocity(t));
        return v;
    }

    /// The earliest contact of sphere i, before `until`, with a plane or one of the first spheres: its `next` and
    /// `partner`. Planes first, then those of near numbers: they are often near, and what is found saves work.
    void predict(BodyId i, const Real& now, const Real& until, BodyId spheres, std::int64_t& root_solves)
    {
        Ball<Real>& ball = balls_[i];
        ball.partner = no_body;
        ball.next = until;
        if (ball.step_end && *ball.step_end < until) ball.next = *ball.step_end, ball.partner = i;
        const double now_rounded = static_cast<double>(now);
        double horizon = static_cast<double>(Real(ball.next - now));
        const auto consider = [&](BodyId j) {
            if ((ball.fixed && fixed(j)) || held(i, j)) return;
            if (j < count() && approach(i, j, now_rounded).misses(horizon)) return;
            Real latest = ball.step_end ? std::min<Real>(until, *ball.step_end) : until;
            if (j < count() && balls_[j].step_end) latest = std::min<Real>(latest, *balls_[j].step_end);
            questions += ball.drag > 0 ? questions_a_damped_one : 1;
            const std::optional<Real> dt = contact_in(i, j, now, latest, root_solves);
            if (!dt || now + *dt > ball.next || (now + *dt == ball.next && ball.partner != no_body)) return;
            ball.next = now + *dt;
            ball.partner = j;
            horizon = static_cast<double>(*dt);
        };
        for (BodyId j = count(); j < bodies(); ++j) consider(j);
        for (BodyId d = 1; d < count() && patience_.lasts_for(1); ++d) {
            if (i - d >= 0 && i - d < spheres) consider(i - d);
            if (i + d < spheres) consider(i + d);
        }
    }
    std::int64_t questions = 0;  ///< when two bodies meet, asked so far

    /// Whether sphere i, which slides along a plane from t on and bounces on it no higher than `height`, certainly
    /// meets no other body before `end`, and none of those has an event before then.
    bool alone_until(BodyId i, BodyId plane, const Flight<Real>& slide, const Real& height, const Real& end) const
    {
        std::int64_t roots = 0;
        const Real& t = slide.t;
        const double span = static_cast<double>(Real(end - t));
        for (BodyId j = 0; j < count(); ++j)
            if (j != i && balls_[j].partner != no_body && balls_[j].next <= end) return false;
        const auto way = [&](const Vector<Real>& v, const Vector<Real>& a) {
            return static_cast<double>(size(v)) * span + static_cast<double>(size(a)) * span * span;
        };
        for (BodyId j = 0; j < bodies(); ++j) {
            if (j == i || j == plane) continue;
            if (j >= count()) {
                const Face<Real> p = face(j, balls_[i]);
                const Real gap = p.gap(slide.x) - height;
                const auto meets = plane_contact<Real>(gap, dot(p.n, slide.v), dot(p.n, slide.a), roots);
                if (gap <= 0 || (meets && t + *meets <= end)) return false;
                continue;
            }
            const Flight<Real>& f = balls_[j].flight;
            const double far = way(slide.v, slide.a) + way(f.velocity(t), f.a) + balls_[j].shadow.wander;
            if (approach(i, j, static_cast<double>(t)).apart(2 * (far + static_cast<double>(height)))) continue;
            const Real sum = balls_[i].radius + balls_[j].radius + height;
            const Polynomial<Real> gap = gap_of_squares(slide.coefficients(t), f.coefficients(t), sum);
            if (gap[0] <= 0 || path_contact(gap, Real(sum * sum), Real(end - t), roots)) return false;
        }
        return true;
    }

    /// Time from now to the next contact of sphere i with body j, if there is one before `until`.
    std::optional<Real> contact_in(BodyId i, BodyId j, const Real& now, const Real& until,
                                   std::int64_t& root_solves) const
    {
        const Flight<Real>& f = balls_[i].flight;
        const Real pull(scene_.gravity.template lpNorm<1>());
        const Vector<Real> x = f.position(now), v = f.velocity(now);
        if (j < count()) {
            const Flight<Real>& other = balls_[j].flight;
            const Real sum = balls_[i].radius + balls_[j].radius;
            if (!f.higher.empty() || !other.higher.empty() || f.drag != other.drag)
                return path_contact(gap_of_squares(f.coefficients(now), other.coefficients(now), sum), Real(sum * sum),
                                    Real(until - now), root_solves);
            const Vector<Real> u = other.velocity(now), r = x - other.position(now), a = f.a - other.a;
            const Vector<Real> w = size(v - u) <= rounding * (size(v) + size(u)) ? Vector<Real>() : v - u;
            if (size(a) <= rounding * pull) {
                const std::optional<Real> way = sphere_contact<Real>(r, w, sum, root_solves);
                return way ? time_of(f.drag, *way) : way;
            }
            return DistanceGap<Real>(r, w, a, f.drag, sum).first_fall(until - now, root_solves);
        }
        const Face<Real> p = face(j, balls_[i]);
        const Real gap = snapped(p.gap(x), balls_[i].radius), rate = snapped(dot(p.n, v), size(v));
        const Real press = snapped(dot(p.n, f.a), pull);
        if (f.drag > 0) return damped_plane_contact<Real>(gap, rate, press, f.drag, until - now, root_solves);
        if (f.higher.empty()) return plane_contact(gap, rate, press, root_solves);
        Polynomial<Real> way;
        for (const Vector<Real>& c : f.coefficients(now)) way.push_back(dot(p.n, c));
        way[0] = gap;
        way[1] = rate;
        return path_contact(std::move(way), balls_[i].radius, Real(until - now), root_solves);
    }

private:
    /// Contacts of i that are closed and still at the start.
    void declare(BodyId i)
    {
        for (BodyId j = 0; j < bodies(); ++j) {
            if (balls_[i].fixed || (j <= i && !fixed(j)) || !gap_within(declared_tie, i, j, 0)) continue;
            const Vector<Real> u = j < count() ? balls_[j].flight.v : Vector<Real>();
            const Real least = still_rounding * (size(balls_[i].flight.v) + size(u));
            if (abs(rate(i, j, 0)) <= least) held_[pair(i, j)] = link(i, j, 0).level;
        }
    }

    /// The gap between i and j at t, if it is at most `tolerance` times the smaller radius.
    std::optional<Real> gap_within(double tolerance, BodyId i, BodyId j, const Real& t) const
    {
        const Ball<Real>& ball = balls_[i];
        const Vector<Real> x = ball.flight.position(t);
        Real gap = 0, reach = tolerance * ball.radius;
        if (j >= count()) {
            gap = face(j, ball).gap(x);
        } else {
            reach = tolerance * std::min(ball.radius, balls_[j].radius);
            if (approach(i, j, static_cast<double>(t)).apart(static_cast<double>(reach))) return std::nullopt;
            const Vector<Real> r = x - balls_[j].flight.position(t);
            gap = sqrt(dot(r, r)) - ball.radius - balls_[j].radius;
        }
        return gap <= reach ? std::optional<Real>(gap) : std::nullopt;
    }

    Real rate(BodyId i, BodyId j, const Real& t) const
    {
        const Vector<Real> v = balls_[i].flight.velocity(t);
        return dot(link(i, j, t).n, j < count() ? v - balls_[j].flight.velocity(t) : v);
    }

    /// Whether the contact of i and j belongs to an instant at which another one of i closes at that speed: nearly
    /// closed and still, or about to close, or closed and of no bounce. Bounces that get ever lower come one after the
    /// other, however low: so what bounced and opens does not belong to it, and the tie shrinks with the speed.
    bool joins(BodyId i, BodyId j, const Real& t, const Real& closing_speed) const
    {
        const double tolerance = scene_.impact.tie.value_or(tie);
        const std::optional<Real> gap = gap_within(tolerance, i, j, t);
        if (!gap) return false;
        const Real c = rate(i, j, t), lowest = lowest_speed(i, j);
        if (abs(c) <= std::max<Real>(lowest, noise * closing_speed)) return true;
        const Real radius = j < count() ? std::min(balls_[i].radius, balls_[j].radius) : balls_[i].radius;
        if (*gap <= rounding * radius) return c < 0 || !bounced(pair(i, j));
        return c < 0 && *gap * lowest <= tolerance * rest_speed<Real> * radius * -c;
    }

    /// Contact of sphere i with body j; places in a group are left to it.
    Link<Real> link(BodyId i, BodyId j, const Real& t) const
    {
        const Ball<Real>& ball = balls_[i];
        const Vector<Real> x = ball.flight.position(t);
        Link<Real> l{immovable, immovable, j, {}, 0, contact_law(scene_, i, j), {}, 0};
        if (j < count()) {
            const Vector<Real> other = balls_[j].flight.position(t), r = x - other;
            l.level = dot(r, r);
            l.n = r * (1 / sqrt(l.level));
            l.bend = 1 / (ball.radius + balls_[j].radius);
            l.anchor = other;
        } else {
            const Vector<Real> n = face(j, ball).n;
            l.n = n * (1 / sqrt(dot(n, n)));
            l.level = dot(l.n, x);
        }
        if (const auto at = held_.find(pair(i, j)); at != held_.end()) l.level = at->second;
        return l;
    }

    const Scene& scene_;
    Patience& patience_;
    std::vector<Ball<Real>> balls_;
    std::map<Pair, Real> held_;  ///< persistent contacts, with the `level` of their links
    std::set<Pair> bounced_;
};

}  // namespace carom::reference
