/// \file
/// Spheres among planes, event by event, all pairs, in multiprecision: slow, short, and sharing nothing with the
/// engine.
#pragma once

#include "reference/bodies.hpp"
#include "reference/limits.hpp"
#include "reference/quartic.hpp"
#include "reference/reason.hpp"
#include "reference/reference.hpp"
#include "reference/roots.hpp"

#include <algorithm>
#include <set>

namespace carom::reference {

/// Runs the scene's doubles as exact numbers until `until` or until something that it does not model: then `reason`
/// says what, and `stopped_at` when. Zeno series are run bounce by bounce, and a lone sphere then stays on its plane.
template <class Real>
class Integrator {
public:
    Integrator(const Scene& scene, const Real& until) : scene_(scene), until_(until), gravity_(scene.gravity)
    {
        for (const Sphere& s : scene.spheres) balls_.emplace_back(s, gravity_);
        for (BodyId i = 0; i < count() && !stopped(); ++i) start(i);
        for (BodyId i = 0; i < count() && !stopped(); ++i) predict(i, 0, i);
    }

    /// Executes the events up to and including time t. \pre t never decreases and is at most `until`.
    void advance(const Real& t)
    {
        while (!stopped()) {
            BodyId a = no_body;
            for (BodyId i = 0; i < count(); ++i)
                if (balls_[i].partner != no_body && (a == no_body || balls_[i].next < balls_[a].next)) a = i;
            if (a == no_body || balls_[a].next > t) return;
            const Real now = balls_[a].next;
            const BodyId b = balls_[a].partner;
            impact(a, b, now);
            for (BodyId i = 0; i < count(); ++i) {
                const BodyId p = balls_[i].partner;
                if (i == a || i == b || p == a || (p == b && b < count())) predict(i, now, count());
            }
        }
    }

    const Flight<Real>& flight(std::size_t i) const { return balls_[i].flight; }
    Mode mode(std::size_t i, const Real& t) const
    {
        const Flight<Real>& f = balls_[i].flight;
        if (balls_[i].fixed) return Mode::fixed;
        if (support_ != no_body) return size(f.a) == 0 && size(f.velocity(t)) == 0 ? Mode::resting : Mode::sliding;
        return balls_[i].series >= 0 ? Mode::series : Mode::flying;
    }
    bool stopped() const { return !reason_.empty(); }
    const std::string& reason() const { return reason_; }
    const Real& stopped_at() const { return stopped_at_; }

    std::vector<ReferenceImpact> impacts;
    std::vector<ReferenceSeries> series;
    std::int64_t root_solves = 0;

private:
    BodyId count() const { return static_cast<BodyId>(balls_.size()); }
    BodyId bodies() const { return scene_.plane_body(scene_.planes.size()); }
    Face<Real> face(BodyId p, const Ball<Real>& ball) const { return {scene_.planes[p - count()], ball}; }
    Approach approach(const Ball<Real>& a, const Ball<Real>& b, double t) const { return {a.shadow, b.shadow, t}; }

    void stop(const char* what, const std::vector<BodyId>& who, const Real& t)
    {
        reason_ = reference::reason(scene_, what, who, static_cast<double>(t));
        stopped_at_ = t;
    }

    /// Whether gravity acts on one of two spheres alone, so that they may come to rest on each other.
    bool pressed(const Ball<Real>& a, const Ball<Real>& b) const { return a.fixed != b.fixed && size(gravity_) > 0; }
    /// Whether an approach at w |r| is the last of a bounce that nobody could see.
    bool faint(const Real& w, const Vector<Real>& r, const Real& radius) const
    {
        return w >= 0 || w * w <= 2 * size(gravity_) * lowest_bounce * radius * dot(r, r);
    }

    /// Contacts that are closed at the start: noted, and if gravity presses a still sphere on a plane, persistent.
    void start(BodyId i)
    {
        Ball<Real>& ball = balls_[i];
        for (BodyId j = 0; j < i; ++j) {
            if (ball.fixed && balls_[j].fixed) continue;
            const double tolerance = declared_tie * std::min(ball.shadow.radius, balls_[j].shadow.radius);
            if (approach(ball, balls_[j], 0).apart(tolerance)) continue;
            const Vector<Real> r = ball.flight.x - balls_[j].flight.x;
            if (sqrt(dot(r, r)) - ball.radius - balls_[j].radius <= tolerance) declared_.emplace(j, i);
        }
        if (ball.fixed) return;
        const Real slow = still * rest_thresholds(scene_).closing_speed + still_rounding * size(ball.flight.v);
        for (BodyId p = count(); p < bodies() && !stopped(); ++p) {
            const Face<Real> f = face(p, ball);
            if (abs(f.gap(ball.flight.x)) > declared_tie * ball.radius) continue;
            declared_.emplace(i, p);
            if (abs(dot(f.n, ball.flight.v)) <= slow && dot(f.n, gravity_) < -1e-30 * size(gravity_)) settle(i, p, 0);
        }
    }

    /// Time from now to the next contact of sphere i with body j, if there is one.
    std::optional<Real> contact_in(BodyId i, BodyId j, const Real& now)
    {
        const Flight<Real>& f = balls_[i].flight;
        const Vector<Real> x = f.position(now), v = f.velocity(now);
        if (j < count()) {
            const Flight<Real>& other = balls_[j].flight;
            const Real sum = balls_[i].radius + balls_[j].radius;
            if (pressed(balls_[i], balls_[j]))
                return accelerated_contact<Real>(x - other.position(now), v - other.velocity(now), f.a - other.a, sum,
                                                 until_ - now, root_solves);
            return sphere_contact<Real>(x - other.position(now), v - other.velocity(now), sum, root_solves);
        }
        const Face<Real> p = face(j, balls_[i]);
        return plane_contact(snapped(p.gap(x), balls_[i].radius), snapped(dot(p.n, v), size(v)),
                             snapped(dot(p.n, f.a), size(gravity_)), root_solves);
    }

    /// The earliest contact of sphere i with a plane or one of the first spheres. Planes first: they shorten the
    /// horizon.
    void predict(BodyId i, const Real& now, BodyId spheres)
    {
        Ball<Real>& ball = balls_[i];
        ball.partner = no_body;
        ball.next = until_;
        const double now_rounded = static_cast<double>(now);
        double horizon = static_cast<double>(Real(until_ - now));
        for (BodyId k = count(), end = bodies() + spheres; k < end; ++k) {
            const BodyId j = k < bodies() ? k : k - bodies();
            if (j == i || j == support_ || (ball.fixed && (j >= count() || balls_[j].fixed))) continue;
            if (j < count() && approach(ball, balls_[j], now_rounded).misses(horizon)) continue;
            const std::optional<Real> dt = contact_in(i, j, now);
            if (!dt || now + *dt > ball.next || (now + *dt == ball.next && ball.partner != no_body)) continue;
            ball.next = now + *dt;
            ball.partner = j;
            horizon = static_cast<double>(*dt);
        }
    }

    /// A third body in contact with i at time t that approaches it before or after i changes its velocity.
    BodyId also_touched(BodyId i, BodyId other, const Real& t, const Vector<Real>& after) const
    {
        const Ball<Real>& ball = balls_[i];
        if (ball.fixed) return no_body;  // it passes nothing on
        const Vector<Real> x = ball.flight.position(t), before = ball.flight.velocity(t);
        const double t_rounded = static_cast<double>(t);
        const auto closes = [&](const Vector<Real>& n, const Vector<Real>& v) {
            const Real noise = 1e-30 * size(n) * (size(before) + size(after));
            return dot(n, before - v) < -noise || dot(n, after - v) < -noise;
        };
        for (BodyId j = 0; j < bodies(); ++j) {
            if (j == i || j == other || j == support_) continue;
            const double tolerance = declared_.count({std::min(i, j), std::max(i, j)}) > 0 ? declared_tie : tie;
            if (j >= count()) {
                const Face<Real> f = face(j, ball);
                if (f.gap(x) <= tolerance * ball.radius && closes(f.n, {})) return j;
            } else if (!approach(ball, balls_[j], t_rounded).apart(tolerance * ball.shadow.radius)) {
                const Flight<Real>& f = balls_[j].flight;
                const Vector<Real> n = x - f.position(t);
                const Real gap = sqrt(dot(n, n)) - ball.radius - balls_[j].radius;
                if (gap <= tolerance * std::min(ball.radius, balls_[j].radius) && closes(n, f.velocity(t))) return j;
            }
        }
        return no_body;
    }

    /// The pair law of IMPACTS 1, in which e, alpha and attenuation are exact doubles.
    void impact(BodyId a, BodyId b, const Real& t)
    {
        Ball<Real>& ball = balls_[a];
        Ball<Real>* other = b < count() ? &balls_[b] : nullptr;
        const ContactLaw law = contact_law(scene_, a, b);
        const Vector<Real> va = ball.flight.velocity(t), vb = other ? other->flight.velocity(t) : Vector<Real>();
        const Vector<Real> r = other ? ball.flight.position(t) - other->flight.position(t) : face(b, ball).n;
        const bool over = other ? pressed(ball, *other) && faint(Real(dot(va - vb, r)), r, ball.radius)
                                : snapped(dot(va, r), size(va)) >= 0;
        if (over) return settle(a, b, t);
        const Vector<Real> change = velocity_change<Real>(va - vb, r, law);
        const Real part = other ? share(ball, *other) : Real(1);
        Vector<Real> after = (va - change * part) * law.attenuation;
        const Vector<Real> after_b = (vb + change * (1 - part)) * law.attenuation;

        BodyId third = also_touched(a, b, t, after);
        if (third == no_body && other) third = also_touched(b, a, t, after_b);
        if (support_ != no_body) {  // a slide meets another plane: goes on, or takes off, or would hit both
            const Vector<Real> n = face(support_, ball).n;
            const Real w = dot(n, after);
            if (abs(w) <= still_rounding * size(after))
                after = after - along(after, n);
            else if (w < 0)
                third = support_;
            else
                support_ = no_body;
        }
        if (third != no_body) return stop("several contacts at one instant", {a, b, third}, t);
        if (++executed_ > max_impacts) return stop("more than 2000000 impacts", {a, b}, t);

        ball.fly(t, after, support_ == no_body && !ball.fixed ? gravity_ : ball.flight.a);
        const bool continued = ball.series >= 0 && series[ball.series].plane == b;
        if (!continued) {
            impacts.push_back({static_cast<double>(t), other ? std::min(a, b) : a, other ? std::max(a, b) : b});
            break_series(ball, t);
        }
        if (!other) return bounced(a, b, law, t);
        other->fly(t, after_b, other->flight.a);
        break_series(*other, t);
    }

    void break_series(Ball<Real>& ball, const Real& t)
    {
        if (ball.series >= 0) series[ball.series].end = static_cast<double>(t);
        ball.series = -1;
    }

    /// A bounce with e < 1 against the acceleration may begin a series, or end it.
    void bounced(BodyId a, BodyId b, const ContactLaw& law, const Real& t)
    {
        Ball<Real>& ball = balls_[a];
        const Vector<Real> n = face(b, ball).n;
        const Real w = dot(n, ball.flight.v), g = -snapped(dot(n, ball.flight.a), size(gravity_)), e = law.restitution;
        if (e >= 1 || g <= 0 || w * w >= 2 * g * scene_.rest.series_below * ball.radius) return;
        if (ball.series < 0) {
            const Real end = t + 2 * w / (g * (1 - e));
            ball.series = static_cast<std::ptrdiff_t>(series.size());
            series.push_back({static_cast<double>(t), static_cast<double>(end), a, b, static_cast<double>(w),
                              law.restitution, static_cast<double>(g)});
        }
        if (w * w <= 2 * g * lowest_bounce * ball.radius) settle(a, b, t);
    }

    /// Persistent contact, of a lone sphere with one plane: what is left of velocity and gravity is along the plane.
    void settle(BodyId a, BodyId b, const Real& t)
    {
        if (count() > 1 || support_ != no_body)
            return stop(count() > 1 ? "with several spheres the reference ends at the first rest"
                                    : "the reference ends where a resting sphere rests on a second plane too",
                        {a, b}, t);
        Ball<Real>& ball = balls_[a];
        // Infinitely many bounces with friction leave nothing of the velocity along the plane.
        const bool stuck =
            ball.series >= 0 && series[ball.series].restitution > 0 && contact_law(scene_, a, b).tangential < 1;
        const Vector<Real> n = face(b, ball).n, v = stuck ? Vector<Real>() : ball.flight.velocity(t);
        const Vector<Real> v_t = v - along(v, n), g_t = gravity_ - along(gravity_, n);
        ball.fly(t, size(v_t) <= 1e-30 * size(v) ? Vector<Real>() : v_t,
                 size(g_t) <= 1e-30 * size(gravity_) ? Vector<Real>() : g_t);
        ball.series = -1;
        support_ = b;
    }

    const Scene& scene_;
    Real until_;
    Vector<Real> gravity_;
    std::vector<Ball<Real>> balls_;
    std::set<std::pair<BodyId, BodyId>> declared_;
    BodyId support_ = no_body;  ///< plane in persistent contact with a lone sphere
    std::int64_t executed_ = 0;
    std::string reason_;
    Real stopped_at_ = 0;
};

}  // namespace carom::reference
