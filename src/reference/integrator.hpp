/// \file
/// Spheres among planes, event by event, all pairs, in multiprecision: slow, short, sharing nothing with the engine.
#pragma once

#include "reference/active_contacts.hpp"
#include "reference/contacts.hpp"
#include "reference/conventions.hpp"
#include "reference/persistence.hpp"
#include "reference/reason.hpp"
#include "reference/record.hpp"

namespace carom::reference {

/// Runs the scene's doubles as exact numbers until `until` or until something that is not done here: then `reason` says
/// what, and `stopped_at` when. Bounces are carried out one by one, down to the last that 50 digits can tell.
template <class Real>
class Integrator {
public:
    /// \param effort see `max_effort`
    Integrator(const Scene& scene, const Real& until, Patience& patience, std::int64_t effort = max_effort)
        : scene_(scene),
          until_(until),
          gravity_(scene.gravity),
          patience_(patience),
          balls_(scene, patience),
          effort_left_(effort)
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

    const Flight<Real>& flight(BodyId i) const { return balls_[i].flight; }
    Mode mode(BodyId i, const Real& t) const
    {
        const Flight<Real>& f = balls_[i].flight;
        if (balls_[i].fixed) return Mode::fixed;
        if (balls_[i].supported)
            return f.higher.empty() && size(f.a) == 0 && size(f.velocity(t)) == 0 ? Mode::resting : Mode::sliding;
        return balls_[i].series >= 0 ? Mode::series : Mode::flying;
    }
    /// Whether nothing goes on any more, for a reason or for want of patience.
    bool stopped() const { return !reason_.empty() || patience_.ended(); }
    const std::string& reason() const { return reason_; }
    const Real& stopped_at() const { return stopped_at_; }

    Record<Real> record;

private:
    using Vectors = std::vector<Vector<Real>>;
    void stop(const char* what, const Group<Real>& g, const Real& t)
    {
        reason_ = reference::reason(scene_, what, g.everybody(), static_cast<double>(t));
        stopped_at_ = t;
    }

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
        if (const char* why = beyond(g)) return stop(why, g, t), t;
        Numbers<Real> x(1, Real(1));
        if (over) settle(g);
        if (g.links.size() == 1) {
            if (before[0] < 0 || over) impact_alone(g, v);
        } else {
            const ImpactOptions& options = scene_.impact;
            if (!over && record.conventions.size() < most_conventions)
                record.conventions.push_back(convention(g, v, options.lcp.law, t, patience_));
            x = impact_together(g, v, options.impact_operator, options.lcp.law, patience_);
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
        const Vector<Real> fall = along(gravity_, l.n);
        Flight<Real> slide{t, balls_[i].flight.position(t), v[0] - along(v[0], l.n), gravity_ - fall, {}};
        const Real pull = pull_on(l, v[0]), e = l.law.restitution, end = t + 2 * w / (pull * (1 - e));
        if (end > limit || !balls_.alone_until(i, l.partner, slide, Real(w * w / pull), end)) return t;
        v[0] = slide.velocity(end);
        balls_[i].follow({end, slide.position(end), v[0], gravity_, {}}, std::nullopt);
        return end;
    }

    /// What is not done here.
    const char* beyond(const Group<Real>& g)
    {
        if (exhausted(g, 1)) return too_much;
        if (g.links.size() == 1) return nullptr;
        if (g.links.size() > most_contacts) return "more than 128 contacts at one instant";
        if (!has_operator(scene_.impact.impact_operator))
            return "several contacts at one instant, for the impact operator shock or jacobi";
        const auto damps = [](const Link<Real>& l) { return l.law.attenuation != 1; };
        if (std::any_of(g.links.begin(), g.links.end(), damps))
            return "several contacts at one instant, with attenuation";
        return nullptr;
    }

    static constexpr const char* too_much = "more work than 250000 impacts";
    /// Whether what is to be done with g is more than a reference is worth.
    bool exhausted(const Group<Real>& g, std::size_t work)
    {
        const std::size_t n = g.links.size();
        const auto all = static_cast<std::size_t>(balls_.bodies());
        effort_left_ -= static_cast<std::int64_t>(work + n * n * n / cubes_an_impact + (1 + n) * all / pairs_an_impact);
        return effort_left_ < 0;
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

    /// A bounce of one sphere alone on a plane or fixed sphere that it is pressed on, lower than `series_height`.
    bool is_low(const Group<Real>& g, const Numbers<Real>& before, const Vectors& v) const
    {
        const Link<Real>& l = g.links[0];
        if (g.links.size() > 1 || l.b != immovable || l.law.restitution == 1) return false;
        const Real w = l.law.restitution * before[0], pull = pull_on(l, v[0]);
        return pull > 0 && w * w < 2 * pull * series_height * balls_[g.bodies[0]].radius;
    }
    /// What presses a sphere with velocity v on an immovable body [length/time^2].
    Real pull_on(const Link<Real>& l, const Vector<Real>& v) const
    {
        const Vector<Real> w = v - along(v, l.n);
        return -snapped(Real(dot(l.n, gravity_) + dot(w, w) * l.bend), size(gravity_));
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

    /// Contacts that v leaves closed and still persist, if forces keep them so; all bodies go on from t.
    void persist(const Group<Real>& g, const Vectors& v, const Real& t)
    {
        const Numbers<Real> c = g.rates(v);
        Group<Real> kept{g.bodies, g.lightness, {}};
        for (std::size_t i = 0; i < c.size(); ++i) {
            const Link<Real>& l = g.links[i];
            Real still = balls_.lowest_speed(g.bodies[l.a], l.partner);
            if (l.law.restitution == 1)
                still += still_rounding * (size(v[l.a]) + (l.b == immovable ? Real(0) : size(v[l.b])));
            if (c[i] <= still)
                kept.links.push_back(l);
            else
                release(g, l, t);
        }
        if (kept.links.size() > most_contacts) return stop("more than 128 contacts that persist together", g, t);
        std::map<BodyId, Vector<Real>> velocity;
        for (std::size_t k = 0; k < v.size(); ++k) velocity[g.bodies[k]] = v[k];
        for (const Group<Real>& part : parts(kept)) {
            Vectors w;
            for (const BodyId i : part.bodies) w.push_back(velocity[i]);
            if (!stopped()) go_on(part, std::move(w), t);
        }
    }

    /// Connected bodies whose links are closed and still go on from t: with constant accelerations if no normal turns.
    void go_on(const Group<Real>& g, Vectors v, const Real& t)
    {
        Real still = 0;
        for (const BodyId i : g.bodies) still = std::max<Real>(still, balls_.lowest_speed(i, i));
        const Persistence<Real> next = persistence(g, v, gravity_, still, patience_);
        if (next.turns) {
            Group<Real> staying{g.bodies, g.lightness, {}};
            std::vector<bool> carries;
            for (std::size_t i = 0; i < g.links.size(); ++i) {
                if (!next.stays[i]) release(g, g.links[i], t);
                if (next.stays[i]) staying.links.push_back(g.links[i]), carries.push_back(next.carries[i]);
            }
            return carry(staying, next.v, carries, t);
        }
        std::vector<bool> supported(v.size());
        for (std::size_t i = 0; i < g.links.size(); ++i) {
            const Link<Real>& l = g.links[i];
            if (!next.closed[i]) {
                release(g, l, t);
                continue;
            }
            hold(g, l, t);
            supported[l.a] = true;
            if (l.b != immovable) supported[l.b] = true;
        }
        for (std::size_t k = 0; k < v.size(); ++k) {
            Ball<Real>& ball = balls_[g.bodies[k]];
            ball.supported = supported[k];
            ball.fly(t, next.rests ? Vector<Real>() : next.v[k], next.rests ? Vector<Real>() : next.a[k]);
        }
    }

    /// A step of connected bodies of which contacts carry some while normals turn.
    void carry(const Group<Real>& g, Vectors v, std::vector<bool> carries, const Real& t)
    {
        if (exhausted(g, 1 + impacts_a_step * g.links.size())) return stop(too_much, g, t);
        Constrained<Real> start{g, std::move(carries), balls_.positions(g, t), std::move(v), {}};
        for (const BodyId i : g.bodies) start.radii.push_back(balls_[i].radius);
        const std::optional<ActiveStep<Real>> next =
            active_step(start, gravity_, Real(until_ - t), record.root_solves, patience_);
        if (!next) {
            if (!stopped()) stop("contacts carry force that is not unique while their normals turn", g, t);
            return;
        }
        std::vector<bool> supported(g.bodies.size());
        for (const Link<Real>& l : g.links) balls_.release(balls_.pair(g, l));
        for (const Link<Real>& l : next->group.links) {
            hold(g, l, t);
            supported[l.a] = true;
            if (l.b != immovable) supported[l.b] = true;
        }
        for (const Link<Real>& l : g.links)
            if (!balls_.held(g.bodies[l.a], l.partner)) release(g, l, t);
        for (std::size_t k = 0; k < g.bodies.size(); ++k) {
            const auto& path = next->step.paths[k];
            Ball<Real>& ball = balls_[g.bodies[k]];
            ball.supported = supported[k];
            Flight<Real> flight{t, path[0], path[1], path[2] * Real(2), {path.begin() + 3, path.end()}};
            if (!supported[k]) flight.a = gravity_, flight.higher.clear();
            const bool turns = std::any_of(flight.higher.begin(), flight.higher.end(),
                                           [](const Vector<Real>& c) { return size(c) > 0; });
            if (!turns) flight.higher.clear();
            ball.follow(std::move(flight), supported[k] ? std::optional<Real>(t + next->end) : std::nullopt);
        }
    }

    void hold(const Group<Real>& g, const Link<Real>& l, const Real& t)
    {
        balls_.hold(g, l);
        record.begins(balls_.pair(g, l), t);
        if (const auto i = g.bodies[l.a]; balls_[i].series >= 0) {
            record.series[balls_[i].series].end = static_cast<double>(t);
            balls_[i].series = -1;
        }
    }
    void release(const Group<Real>& g, const Link<Real>& l, const Real& t)
    {
        balls_.release(balls_.pair(g, l));
        record.ends(balls_.pair(g, l), t);
    }

    const Scene& scene_;
    Real until_;
    Vector<Real> gravity_;
    Patience& patience_;
    Contacts<Real> balls_;
    std::set<Pair> bounced_;  ///< pairs whose last contact was a bounce
    std::int64_t effort_left_;
    Real last_ = 0;             ///< time of the last event
    std::int64_t at_once_ = 0;  ///< events since then at that time
    std::string reason_;
    Real stopped_at_ = 0;
};

}  // namespace carom::reference
