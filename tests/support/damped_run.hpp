/// \file
/// Recorded runs with drag that no engine has made: an event program of its own in 50 digits, for a few spheres that
/// fly among half-spaces and fixed spheres. What it records is rounded to doubles, and it goes on from there.
#pragma once

#include "support/damped_law.hpp"
#include "support/recorded.hpp"

#include <optional>

namespace carom::test {

class DampedProgram {
public:
    using Real = Float<50>;

    explicit DampedProgram(const Scene& scene) : scene_(scene), k_(scene.drag), end_(scene.end_time)
    {
        source_.description = described(scene);
        source_.description.frame = {1, 1, scene.drag, {Vec3::Zero(), scene.gravity}};
    }

    MemorySource run()
    {
        for (std::size_t i = 0; i < scene_.spheres.size(); ++i) {
            const Sphere& s = scene_.spheres[i];
            begin(i, {}, lift<Real>(s.position), lift<Real>(s.velocity));
        }
        for (std::optional<Contact> next = first_contact(Real(0)); next; next = first_contact(now_)) resolve(*next);
        source_.description.end = RecordedEnd{scene_.end_time, 0, 0, 0};
        source_.seal();
        return source_;
    }

private:
    struct Contact {
        Real time;
        std::size_t a, b;
    };
    struct State {
        Real3<Real> place, velocity;
    };

    bool is_fixed(std::size_t i) const { return scene_.spheres[i].fixed; }
    Real gravity(std::size_t body, std::size_t axis) const
    {
        return is_fixed(body) ? Real(0) : Real(scene_.gravity[static_cast<Eigen::Index>(axis)]);
    }

    void begin(std::size_t body, const EpochTime& at, const Real3<Real>& place, const Real3<Real>& velocity)
    {
        FlightRecord f;
        f.body = static_cast<BodyId>(body);
        f.start = at;
        for (std::size_t k = 0; k < 3; ++k) {
            f.cell[k] = static_cast<std::int64_t>(floor(place[k]));
            f.local[k] = Real(place[k] - f.cell[k]).convert_to<double>();
            f.velocity[k] = velocity[k].convert_to<double>();
        }
        f.acceleration = is_fixed(body) ? 0 : 1;
        f.mode = is_fixed(body) ? Mode::fixed : Mode::flying;
        latest_.resize(std::max(latest_.size(), body + 1));
        latest_[body] = f;
        source_.flights.push_back(f);
        source_.after.push_back(source_.events.size());
    }

    State state(std::size_t body, const Real& t) const
    {
        const FlightRecord& f = latest_[body];
        const DampedTime<Real> effect(k_, t - Real(f.start.epoch) - Real(f.start.offset));
        State out;
        for (std::size_t k = 0; k < 3; ++k) {
            out.place[k] = effect.place(Real(f.cell[k]) + Real(f.local[k]), Real(f.velocity[k]), gravity(body, k));
            out.velocity[k] = effect.speed(Real(f.velocity[k]), gravity(body, k));
        }
        return out;
    }

    struct Separation {
        Real3<Real> from_b;  ///< to a
        Real3<Real> speed;   ///< of a relative to b
        Real3<Real> normal;
        Real gap;
    };
    Separation separation(std::size_t a, std::size_t b, const Real& t) const
    {
        const State sa = state(a, t);
        Separation s{sa.place, sa.velocity, {}, Real(0)};
        if (b >= scene_.spheres.size()) {
            const Plane& plane = scene_.planes[b - scene_.spheres.size()];
            s.normal = lift<Real>(plane.normal);
            s.gap = dot(s.normal, s.from_b) - Real(plane.offset) - Real(scene_.spheres[a].radius);
            return s;
        }
        const State sb = state(b, t);
        for (std::size_t k = 0; k < 3; ++k) {
            s.from_b[k] -= sb.place[k];
            s.speed[k] -= sb.velocity[k];
        }
        const Real distance = sqrt(dot(s.from_b, s.from_b));
        for (std::size_t k = 0; k < 3; ++k) s.normal[k] = s.from_b[k] / distance;
        s.gap = distance - Real(scene_.spheres[a].radius) - Real(scene_.spheres[b].radius);
        return s;
    }

    /// Where the gap falls to 0 between a time at which it is above and one at which it is not.
    Real bisected(std::size_t a, std::size_t b, Real above, Real below) const
    {
        for (int i = 0; i < 170; ++i) {
            const Real middle = (above + below) / 2;
            (separation(a, b, middle).gap > 0 ? above : below) = middle;
        }
        return below;
    }

    /// In s = (1 - exp(-k t))/k two flying spheres move straight.
    std::optional<Real> flying_pair(std::size_t a, std::size_t b, const Real& now) const
    {
        const Separation s = separation(a, b, now);
        const Real sum = Real(scene_.spheres[a].radius) + Real(scene_.spheres[b].radius);
        const Real rv = dot(s.from_b, s.speed), vv = dot(s.speed, s.speed);
        const Real f = dot(s.from_b, s.from_b) - sum * sum, discriminant = rv * rv - vv * f;
        if (rv >= 0 || discriminant <= 0) return {};
        const Real way = f / (-rv + sqrt(discriminant));
        if (k_ * way >= 1) return {};
        return Real(now - log1p(Real(-k_ * way)) / k_);
    }

    /// Convex or concave: searched from its highest point on.
    std::optional<Real> plane(std::size_t a, std::size_t b, const Real& now) const
    {
        const Separation s = separation(a, b, now);
        const Real w = dot(s.normal, s.speed);
        Real g(0);
        for (std::size_t k = 0; k < 3; ++k) g += s.normal[k] * gravity(a, k);
        Real from = now, to = end_;
        const Real part = k_ * w / (g - k_ * w);
        if (w >= 0 && g >= 0) return {};
        if (w >= 0) from = now - log1p(part) / k_;
        if (w < 0 && g > 0) to = std::min(end_, Real(now - log1p(part) / k_));
        if (from >= end_ || separation(a, b, to).gap > 0) return {};
        return bisected(a, b, from, to);
    }

    /// Not straight in any time: looked for in steps.
    std::optional<Real> fixed_partner(std::size_t a, std::size_t b, const Real& now) const
    {
        constexpr int steps = 100;
        bool was_open = false;
        for (int i = 0; i <= steps; ++i) {
            const Real t = now + (end_ - now) * i / steps;
            const bool is_open = separation(a, b, t).gap > 0;
            if (was_open && !is_open) return bisected(a, b, Real(t - (end_ - now) / steps), t);
            was_open = is_open;
        }
        return {};
    }

    std::optional<Contact> first_contact(const Real& now) const
    {
        std::optional<Contact> first;
        const std::size_t n = scene_.spheres.size();
        for (std::size_t a = 0; a < n; ++a)
            for (std::size_t b = a + 1; b < n + scene_.planes.size(); ++b) {
                if (is_fixed(a) && (b >= n || is_fixed(b))) continue;
                const std::optional<Real> t = b >= n                       ? plane(a, b, now)
                                              : is_fixed(a) || is_fixed(b) ? fixed_partner(a, b, now)
                                                                           : flying_pair(a, b, now);
                if (t && *t < end_ && (!first || *t < first->time)) first = Contact{*t, a, b};
            }
        return first;
    }

    void resolve(const Contact& contact)
    {
        const std::size_t a = contact.a, b = contact.b, n = scene_.spheres.size();
        const auto epoch = static_cast<std::int64_t>(floor(contact.time));
        const EpochTime at{epoch, Real(contact.time - epoch).convert_to<double>()};
        now_ = Real(at.epoch) + Real(at.offset);
        const Separation s = separation(a, b, now_);
        const auto inverse_mass = [&](std::size_t i) {
            return i >= n || is_fixed(i) ? Real(0) : Real(1) / Real(scene_.spheres[i].mass);
        };
        const Real push =
            -(1 + Real(scene_.materials[0].restitution)) * dot(s.normal, s.speed) / (inverse_mass(a) + inverse_mass(b));
        Event event;
        event.kind = EventKind::impact;
        event.at = at;
        event.time = now_.convert_to<double>();
        event.a = static_cast<BodyId>(a);
        event.b = static_cast<BodyId>(b);
        for (std::size_t k = 0; k < 3; ++k) {
            event.normal[static_cast<Eigen::Index>(k)] = s.normal[k].convert_to<double>();
            event.impulse[static_cast<Eigen::Index>(k)] = Real(push * s.normal[k]).convert_to<double>();
        }
        source_.events.push_back(event);
        for (const std::size_t body : {a, b}) {
            if (body >= n || is_fixed(body)) continue;
            State next = state(body, now_);
            for (std::size_t k = 0; k < 3; ++k)
                next.velocity[k] += (body == a ? 1 : -1) * push * s.normal[k] * inverse_mass(body);
            begin(body, at, next.place, next.velocity);
        }
    }

    const Scene& scene_;
    Real k_, end_, now_ = 0;
    MemorySource source_;
    std::vector<FlightRecord> latest_;
};

inline MemorySource damped_run(const Scene& scene)
{
    return DampedProgram(scene).run();
}

}  // namespace carom::test
