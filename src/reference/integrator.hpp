/// \file
/// Spheres among planes, event by event, all pairs, in multiprecision: slow, short, sharing nothing with the engine.
#pragma once

#include "reference/contacts.hpp"
#include "reference/impact.hpp"
#include "reference/persistence.hpp"
#include "reference/reason.hpp"
#include "reference/reference.hpp"

#include <map>

namespace carom::reference {

/// Runs the scene's doubles as exact numbers until `until` or until something that has no closed form: then `reason`
/// says what, and `stopped_at` when. Zeno series are run bounce by bounce; contacts persist while flights stay
/// parabolas.
template <class Real>
class Integrator {
public:
    Integrator(const Scene& scene, const Real& until, Patience& patience)
        : scene_(scene),
          until_(until),
          gravity_(scene.gravity),
          rest_(rest_thresholds(scene)),
          patience_(patience),
          balls_(scene, patience)
    {
        const auto loses = [](const auto& law) { return law.restitution < 1; };
        lossy_ = std::any_of(scene.materials.begin(), scene.materials.end(), loses) ||
                 std::any_of(scene.contacts.begin(), scene.contacts.end(), loses);
        patience_.begin("reference: first contacts", balls_.count(), "spheres");
        for (BodyId i = 0; i < balls_.count() && !stopped(); ++i) {
            if (balls_.fixed(i) || balls_[i].supported || !balls_.supported(i)) continue;
            const Group<Real> g = balls_.group({i}, 0);
            persist(g, balls_.velocities(g, 0), 0);
        }
        for (BodyId i = 0; i < balls_.count() && patience_.lasts(i) && !stopped(); ++i)
            balls_.predict(i, 0, until_, i, root_solves);
    }

    /// Executes the events up to and including time t. \pre t never decreases and is at most `until`.
    void advance(const Real& t)
    {
        while (!stopped()) {
            BodyId a = no_body;
            for (BodyId i = 0; i < balls_.count(); ++i)
                if (balls_[i].partner != no_body && (a == no_body || balls_[i].next < balls_[a].next)) a = i;
            if (a == no_body || balls_[a].next > t) return;
            const Real now = balls_[a].next;
            const BodyId b = balls_[a].partner;
            if (!patience_.lasts(static_cast<double>(now))) return;
            std::vector<BodyId> movable;
            if (!balls_.fixed(a)) movable.push_back(a);
            if (!balls_.fixed(b)) movable.push_back(b);
            const Group<Real> g = balls_.group(std::move(movable), now);
            if (stopped()) return;
            impact(g, now);
            for (BodyId i = 0; i < balls_.count() && !stopped(); ++i) {
                const BodyId p = balls_[i].partner;
                if (i == a || i == b || g.has(i) || (p != no_body && g.has(p)))
                    balls_.predict(i, now, until_, balls_.count(), root_solves);
            }
        }
    }

    const Flight<Real>& flight(BodyId i) const { return balls_[i].flight; }
    Mode mode(BodyId i, const Real& t) const
    {
        const Flight<Real>& f = balls_[i].flight;
        if (balls_[i].fixed) return Mode::fixed;
        if (balls_[i].supported) return size(f.a) == 0 && size(f.velocity(t)) == 0 ? Mode::resting : Mode::sliding;
        return balls_[i].series >= 0 ? Mode::series : Mode::flying;
    }
    /// Whether nothing goes on any more, for a reason or for want of patience.
    bool stopped() const { return !reason_.empty() || patience_.ended(); }
    const std::string& reason() const { return reason_; }
    const Real& stopped_at() const { return stopped_at_; }

    std::vector<ReferenceImpact> impacts;
    std::vector<ReferenceSeries> series;
    std::int64_t root_solves = 0;

private:
    using Vectors = std::vector<Vector<Real>>;
    void stop(const char* what, const Group<Real>& g, const Real& t)
    {
        reason_ = reference::reason(scene_, what, g.everybody(), static_cast<double>(t));
        stopped_at_ = t;
    }

    /// Laws of one contact and of several: docs/impacts.md, sections 1 and 3.
    void impact(Group<Real> g, const Real& t)
    {
        Vectors v = balls_.velocities(g, t);
        const Numbers<Real> before = g.rates(v);
        const bool low = begins_series(g, before);
        soften(g, before, low, t);
        if (const char* limit = beyond(g, low, t)) return stop(limit, g, t);
        Numbers<Real> x(1, Real(1));
        if (g.links.size() == 1)
            impact_alone(g, v);
        else
            x = impact_together(g, v, patience_);
        if (x.empty()) return stop("the impact of several contacts was not resolved", g, t);
        if (const auto& ball = balls_[g.bodies[0]];
            !low || ball.series < 0 || series[ball.series].plane != g.links[0].partner) {
            list(g, x, t);
            for (const BodyId i : g.bodies) {
                if (balls_[i].series >= 0) series[balls_[i].series].end = static_cast<double>(t);
                balls_[i].series = -1;
            }
        }
        if (low) return bounced(g, v, t);
        persist(g, v, t);
    }

    /// What is not done here.
    const char* beyond(const Group<Real>& g, bool low, const Real& t)
    {
        if (++executed_ > max_impacts) return "more than 2000000 impacts";
        if (!low && accumulates(g, t)) return "impacts accumulate, which is for the guard";
        if (g.links.size() == 1) return nullptr;
        if (g.links.size() > most_contacts) return "more than 128 contacts at one instant";
        if (scene_.impact.impact_operator != ImpactOperator::reflections)
            return "several contacts at one instant, for another impact operator than reflections";
        const auto damps = [](const Link<Real>& l) { return l.law.attenuation != 1; };
        if (std::any_of(g.links.begin(), g.links.end(), damps))
            return "several contacts at one instant, with attenuation";
        return nullptr;
    }

    /// A bounce of one sphere on one plane that gravity presses it on, lower than `series_below` radii, e < 1.
    bool begins_series(const Group<Real>& g, const Numbers<Real>& before) const
    {
        const Link<Real>& l = g.links[0];
        if (g.links.size() > 1 || l.partner < balls_.count()) return false;
        const Real w = l.law.restitution * before[0], pull = -snapped(dot(l.n, gravity_), size(gravity_));
        return l.law.restitution < 1 && pull > 0 &&
               w * w < 2 * pull * scene_.rest.series_below * balls_[g.bodies[0]].radius;
    }

    /// e := 0 where all closings are slow, and of contacts that closed a moment ago, unless all e = 1.
    void soften(Group<Real>& g, const Numbers<Real>& before, bool low, const Real& t)
    {
        if (!lossy_ || scene_.rest.policy != RestPolicy::contact) return;
        bool elastic = true, creeping = true;
        for (std::size_t i = 0; i < before.size(); ++i) {
            elastic = elastic && g.links[i].law.restitution == 1;
            creeping = creeping && before[i] > -rest_.closing_speed;
        }
        for (std::size_t i = 0; i < before.size(); ++i) {
            const Pair pair = balls_.pair(g, g.links[i]);
            const auto last = closed_.find(pair);
            const bool recent = last != closed_.end() && t - last->second < rest_.window;
            if (!low && !elastic && (creeping || recent)) g.links[i].law.restitution = 0;
            if (before[i] < 0) closed_[pair] = t;
        }
    }

    /// Whether a sphere had more inelastic impacts within a window than the guard lets pass.
    bool accumulates(const Group<Real>& g, const Real& t)
    {
        const double window = scene_.guard.window.value_or(rest_.numeric_step);
        const auto loses = [](const Link<Real>& l) { return l.law.restitution < 1; };
        bool many = false;
        for (const BodyId i : g.bodies) {
            Ball<Real>& ball = balls_[i];
            if (t - ball.window > window) ball.window = t, ball.impacts = 0;
            many = many || ++ball.impacts > scene_.guard.impacts;
        }
        return many && std::any_of(g.links.begin(), g.links.end(), loses);
    }

    void list(const Group<Real>& g, const Numbers<Real>& x, const Real& t)
    {
        const Real most = *std::max_element(x.begin(), x.end());
        for (std::size_t i = 0; i < x.size(); ++i) {
            const BodyId a = g.bodies[g.links[i].a], b = g.links[i].partner;
            if (x[i] <= noise * most) continue;
            impacts.push_back({static_cast<double>(t), b < balls_.count() ? std::min(a, b) : a, std::max(a, b)});
        }
    }

    /// A bounce of a series, perhaps its first, or so low that it is the last.
    void bounced(const Group<Real>& g, Vectors v, const Real& t)
    {
        Ball<Real>& ball = balls_[g.bodies[0]];
        const Link<Real>& l = g.links[0];
        const Real w = dot(l.n, v[0]), pull = -dot(l.n, gravity_), e = l.law.restitution;
        if (ball.series < 0) {
            const Real end = t + 2 * w / (pull * (1 - e));
            ball.series = static_cast<std::ptrdiff_t>(series.size());
            series.push_back({static_cast<double>(t), static_cast<double>(end), g.bodies[0], l.partner,
                              static_cast<double>(w), l.law.restitution, static_cast<double>(pull)});
        }
        if (w * w > 2 * pull * lowest_bounce * ball.radius) return ball.fly(t, v[0], gravity_);
        ball.series = -1;
        // Infinitely many bounces with friction leave nothing of the velocity along the plane.
        v[0] = e > 0 && l.law.tangential < 1 ? Vector<Real>() : v[0] - along(v[0], l.n);
        persist(g, v, t);
    }

    /// Contacts that v leaves closed and still persist, if forces keep them so; all bodies fly on from t.
    void persist(const Group<Real>& g, const Vectors& v, const Real& t)
    {
        const Numbers<Real> c = g.rates(v);
        Group<Real> kept{g.bodies, g.lightness, {}};
        for (std::size_t i = 0; i < c.size(); ++i) {
            const Link<Real>& l = g.links[i];
            balls_.release(balls_.pair(g, l));
            if (c[i] <= balls_.slow(v[l.a], l.b == immovable ? Vector<Real>() : v[l.b])) kept.links.push_back(l);
        }
        if (!kept.links.empty() && scene_.rest.policy != RestPolicy::contact)
            return stop("contacts persist, which the rest policy leaves out", g, t);
        if (kept.links.size() > most_contacts) return stop("more than 128 contacts that persist together", g, t);
        const Persistence<Real> next = persistence(kept, v, gravity_, patience_);
        if (next.turns) return stop("contacts carry force while their normals turn, which has no closed form", g, t);
        for (std::size_t i = 0; i < kept.links.size(); ++i)
            if (next.persists[i]) balls_.hold(balls_.pair(g, kept.links[i]));
        for (std::size_t k = 0; k < v.size(); ++k) {
            Ball<Real>& ball = balls_[g.bodies[k]];
            ball.supported = balls_.supported(g.bodies[k]);
            ball.fly(t, next.v[k], next.a[k]);
        }
    }

    const Scene& scene_;
    Real until_;
    Vector<Real> gravity_;
    RestThresholds rest_;
    Patience& patience_;
    Contacts<Real> balls_;
    bool lossy_ = false;           ///< e < 1 somewhere
    std::map<Pair, Real> closed_;  ///< when contacts closed last
    std::int64_t executed_ = 0;
    std::string reason_;
    Real stopped_at_ = 0;
};

}  // namespace carom::reference
