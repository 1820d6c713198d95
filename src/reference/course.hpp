/// \file
/// The state of a run, and how its bodies go on after an event.
#pragma once

#include "reference/active_contacts.hpp"
#include "reference/contacts.hpp"
#include "reference/persistence.hpp"
#include "reference/reason.hpp"
#include "reference/record.hpp"

namespace carom::reference {

template <class Real>
class Course {
public:
    using Vectors = std::vector<Vector<Real>>;

    /// \param effort see `max_effort`
    Course(const Scene& scene, const Real& until, Patience& patience, std::int64_t effort)
        : field_{Vector<Real>(scene.gravity), scene.drag},
          patience_(patience),
          balls_(scene, patience),
          scene_(scene),
          until_(until),
          effort_left_(effort)
    {
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

protected:
    void stop(const char* what, const Group<Real>& g, const Real& t)
    {
        reason_ = reference::reason(scene_, what, g.everybody(), static_cast<double>(t));
        stopped_at_ = t;
    }

    /// Whether what is to be done with g is more than a reference is worth: then it stops.
    bool exhausted(const Group<Real>& g, std::size_t work, const Real& t)
    {
        const std::size_t n = g.links.size();
        const auto all = static_cast<std::size_t>(balls_.bodies());
        work += n * n * n / cubes_an_impact + (1 + n) * all / pairs_an_impact;
        const std::int64_t spent = balls_.questions / questions_an_impact;
        effort_left_ -= static_cast<std::int64_t>(work) + spent;
        balls_.questions -= spent * questions_an_impact;
        if (effort_left_ >= 0) return false;
        stop("more work than 250000 impacts", g, t);
        return true;
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

    /// A step of connected bodies of which contacts carry some while normals turn.
    void carry(const Group<Real>& g, Vectors v, std::vector<bool> carries, const Real& t)
    {
        if (exhausted(g, 1 + impacts_a_step * g.links.size(), t)) return;
        Constrained<Real> start{g, std::move(carries), balls_.positions(g, t), std::move(v), {}};
        for (const BodyId i : g.bodies) start.radii.push_back(balls_[i].radius);
        const std::optional<ActiveStep<Real>> next =
            active_step(start, field_, Real(until_ - t), record.root_solves, patience_);
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
            if (!supported[k]) flight.a = field_.gravity, flight.drag = field_.drag, flight.higher.clear();
            const bool turns = std::any_of(flight.higher.begin(), flight.higher.end(),
                                           [](const Vector<Real>& c) { return size(c) > 0; });
            if (!turns) flight.higher.clear();
            ball.follow(std::move(flight), supported[k] ? std::optional<Real>(t + next->end) : std::nullopt);
        }
    }

    Field<Real> field_;
    Patience& patience_;
    Contacts<Real> balls_;

private:
    /// Connected bodies whose links are closed and still go on from t: with constant accelerations if no normal turns.
    void go_on(const Group<Real>& g, Vectors v, const Real& t)
    {
        Real still = 0;
        for (const BodyId i : g.bodies) still = std::max<Real>(still, balls_.lowest_speed(i, i));
        const Persistence<Real> next = persistence(g, v, field_.gravity, still, patience_);
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
    std::int64_t effort_left_;
    std::string reason_;
    Real stopped_at_ = 0;
};

}  // namespace carom::reference
