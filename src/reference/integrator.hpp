/// \file
/// Spheres among planes, event by event, all pairs, in multiprecision: slow, short, sharing nothing with the engine.
#pragma once

#include "reference/conventions.hpp"
#include "reference/course.hpp"

namespace carom::reference {

/// Runs the scene's doubles as exact numbers until `until` or until something that is not done here: then `reason` says
/// what, and `stopped_at` when. Bounces are carried out one by one, down to the last that 50 digits can tell.
template <class Real>
class Integrator : public Course<Real> {
public:
    using Course<Real>::record;
    using Course<Real>::stopped;

    /// \param effort see `max_effort`
    Integrator(const Scene& scene, const Real& until, Patience& patience, std::int64_t effort = max_effort)
        : Course<Real>(scene, until, patience, effort), impact_(scene.impact), until_(until)
    {
        patience_.begin("reference: first contacts", balls_.count(), "spheres");
        for (BodyId i = 0; i < balls_.count() && !stopped(); ++i) {
            if (balls_.fixed(i) || balls_[i].supported || !balls_.supported(i)) continue;
            const Group<Real> g = balls_.group({i}, 0, std::nullopt);
            persist(g, balls_.velocities(g, 0), 0);
        }
        for (BodyId i = 0; i < balls_.count() && patience_.lasts(i) && !stopped(); ++i)
            balls_.predict(i, 0, until_, i, record.root_solves);
    }

    /// Executes the events up to and including time t. \pre t never decreases and is at most `until`.
    void advance(const Real& t)
    {
        while (!stopped()) {
            BodyId a = no_body;
            for (BodyId i = 0; i < balls_.count(); ++i)
                if (balls_[i].partner != no_body && (a == no_body || balls_[i].next < balls_[a].next)) a = i;
            if (a == no_body || balls_[a].next > t) return;
            Real now = balls_[a].next;
            const BodyId b = balls_[a].partner;
            if (!patience_.lasts(static_cast<double>(now))) return;
            std::vector<BodyId> movable;
            if (!balls_.fixed(a)) movable.push_back(a);
            if (a != b && !balls_.fixed(b)) movable.push_back(b);
            const std::optional<Pair> closes = a == b ? std::nullopt : std::optional<Pair>(balls_.pair(a, b));
            const Group<Real> g = balls_.group(movable, now, closes);
            if (stopped()) return;
            at_once_ = now > last_ ? 0 : at_once_ + 1;
            last_ = now;
            if (at_once_ > most_at_once) return stop("impacts and forces of one instant do not end", g, now);
            if (a == b)
                carry(g, balls_.velocities(g, now), std::vector<bool>(g.links.size(), true), now);
            else
                now = impact(g, now, t);
            for (BodyId i = 0; i < balls_.count() && !stopped(); ++i) {
                const BodyId p = balls_[i].partner;
                if (i == a || i == b || g.has(i) || (p != no_body && g.has(p)))
                    balls_.predict(i, now, until_, balls_.count(), record.root_solves);
            }
        }
    }

private:
    using typename Course<Real>::Vectors;
    using Course<Real>::balls_, Course<Real>::field_, Course<Real>::patience_, Course<Real>::persist,
        Course<Real>::carry, Course<Real>::stop;

    /// Laws of one contact and of several: docs/impacts.md, sections 1 and 3. \param limit bounces that are summed end
    /// before it \returns t, or when those were over
    Real impact(Group<Real> g, const Real& t, const Real& limit)
    {
        Vectors v = balls_.velocities(g, t);
        for (std::size_t k = 0; k < v.size(); ++k) {
            Real& fastest = balls_[g.bodies[k]].fastest;
            fastest = std::max<Real>(fastest, size(v[k]));
        }
        const Numbers<Real> before = g.rates(v);
        const bool over = bounces_are_over(g, before), low = !over && is_low(g, before, v);
        if (this->exhausted(g, 1, t)) return t;
        if (const char* why = beyond(g)) return stop(why, g, t), t;
        Numbers<Real> x(1, Real(1));
        if (over) settle(g);
        if (g.links.size() == 1) {
            if (before[0] < 0 || over) impact_alone(g, v);
        } else {
            if (!over && record.conventions.size() < most_conventions)
                record.conventions.push_back(convention(g, v, impact_.lcp.law, t, patience_));
            x = impact_together(g, v, impact_.impact_operator, impact_.lcp.law, patience_);
        }
        if (x.empty()) return stop("the impact of several contacts was not resolved", g, t), t;
        const std::ptrdiff_t series = balls_[g.bodies[0]].series;
        const bool goes_on = series >= 0 && g.links.size() == 1 && record.series[series].plane == g.links[0].partner;
        if (!over && !(low && goes_on)) record.impact(g, x, balls_.count(), t);
        if (!(low || over) || !goes_on) end_series(g, t);
        if (low && !goes_on) begin_series(g, v, t);
        if (!over)
            for (std::size_t i = 0; i < before.size(); ++i)
                if (before[i] < 0) balls_.bounce(balls_.pair(g, g.links[i]));
        const Real end = low ? bounced_out(g, v, t, limit) : t;
        persist(g, v, end);
        return end;
    }

    /// All bounces of a sphere alone on a plane as the sum of their geometric series, if nothing else happens
    /// meanwhile. \param v after the bounce at t, then after the last \returns when that is; t if they have to come one
    /// by one
    Real bounced_out(const Group<Real>& g, Vectors& v, const Real& t, const Real& limit)
    {
        const Link<Real>& l = g.links[0];
        const BodyId i = g.bodies[0];
        const Real w = dot(l.n, v[0]);
        // With friction it slides less far each time; what it may meet is looked for along one path.
        if (l.partner < balls_.count() || !(w > 0) || l.law.tangential < 1) return t;
        const Vector<Real> fall = along(field_.gravity, l.n);
        Flight<Real> slide{t, balls_[i].flight.position(t), v[0] - along(v[0], l.n), field_.gravity - fall, {}};
        const Real pull = pull_on(l, v[0]), e = l.law.restitution, end = t + 2 * w / (pull * (1 - e));
        if (end > limit || !balls_.alone_until(i, l.partner, slide, Real(w * w / pull), end)) return t;
        v[0] = slide.velocity(end);
        balls_[i].follow({end, slide.position(end), v[0], field_.gravity, {}}, std::nullopt);
        return end;
    }

    /// Why this impact is not done here; nothing if it is.
    const char* beyond(const Group<Real>& g) const
    {
        if (g.links.size() == 1) return nullptr;
        if (g.links.size() > most_contacts) return "more than 128 contacts at one instant";
        if (!has_operator(impact_.impact_operator))
            return "several contacts at one instant, for the impact operator shock or jacobi";
        const auto damps = [](const Link<Real>& l) { return l.law.attenuation != 1; };
        if (std::any_of(g.links.begin(), g.links.end(), damps))
            return "several contacts at one instant, with attenuation";
        return nullptr;
    }

    /// Whether what closes does so, or rebounds, slower than 50 digits can tell in the long run.
    bool bounces_are_over(const Group<Real>& g, const Numbers<Real>& before) const
    {
        for (std::size_t i = 0; i < before.size(); ++i) {
            const Link<Real>& l = g.links[i];
            const Real least = balls_.lowest_speed(g.bodies[l.a], l.partner), e = l.law.restitution;
            if (before[i] < -least && (e == 0 || before[i] * e < -least)) return false;
        }
        return true;
    }

    /// Infinitely many bounces leave nothing of the normal velocity, and with friction nothing of the tangential one.
    void settle(Group<Real>& g)
    {
        for (Link<Real>& l : g.links) {
            const bool bounced = l.law.restitution > 0 && balls_.bounced(balls_.pair(g, l));
            l.law.tangential = bounced && l.law.tangential < 1 ? 0 : 1;
            l.law.restitution = 0;
        }
    }

    /// A bounce of one sphere alone on a plane or fixed sphere that it is pressed on, lower than `series_height`; with
    /// drag bounces make no geometric series.
    bool is_low(const Group<Real>& g, const Numbers<Real>& before, const Vectors& v) const
    {
        const Link<Real>& l = g.links[0];
        if (g.links.size() > 1 || l.b != immovable || l.law.restitution == 1 || field_.drag > 0) return false;
        const Real w = l.law.restitution * before[0], pull = pull_on(l, v[0]);
        return pull > 0 && w * w < 2 * pull * series_height * balls_[g.bodies[0]].radius;
    }
    /// Acceleration that presses a sphere with velocity v on an immovable body [length/time^2].
    Real pull_on(const Link<Real>& l, const Vector<Real>& v) const
    {
        const Vector<Real> w = v - along(v, l.n);
        return -snapped(Real(dot(l.n, field_.gravity) + dot(w, w) * l.bend), size(field_.gravity));
    }

    void begin_series(const Group<Real>& g, const Vectors& v, const Real& t)
    {
        const Link<Real>& l = g.links[0];
        const Real w = std::max<Real>(0, dot(l.n, v[0])), pull = pull_on(l, v[0]), e = l.law.restitution;
        const Real end = t + 2 * w / (pull * (1 - e));
        balls_[g.bodies[0]].series = static_cast<std::ptrdiff_t>(record.series.size());
        record.series.push_back({static_cast<double>(t), static_cast<double>(end), g.bodies[0], l.partner,
                                 static_cast<double>(w), l.law.restitution, static_cast<double>(pull)});
    }
    void end_series(const Group<Real>& g, const Real& t)
    {
        for (const BodyId i : g.bodies) {
            if (balls_[i].series >= 0) record.series[balls_[i].series].end = static_cast<double>(t);
            balls_[i].series = -1;
        }
    }

    ImpactOptions impact_;
    Real until_;
    Real last_ = 0;             ///< time of the last event
    std::int64_t at_once_ = 0;  ///< events since then at that time
};

}  // namespace carom::reference
