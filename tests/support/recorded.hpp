/// \file
/// Runs in memory, as the verifier reads them, open to forgery.
#pragma once

#include "support/scenes.hpp"

#include "math/double_double.hpp"

#include <carom/verify.hpp>

#include <array>
#include <cstring>

namespace carom::test {

inline RecordedRun described(const Scene& scene)
{
    RecordedRun run;
    run.gravity = scene.gravity;
    run.materials = scene.materials;
    run.contacts = scene.contacts;
    run.tie = scene.impact.tie.value_or(0);
    run.planes = scene.planes;
    const RestThresholds rest = rest_thresholds(scene);
    run.closing_speed = rest.closing_speed;
    run.window = scene.rest.policy == RestPolicy::micro ? 0 : std::max(std::numeric_limits<double>::min(), rest.window);
    for (const Sphere& s : scene.spheres) {
        run.spheres.push_back({s.radius, s.mass, s.material, s.fixed});
        run.starts.push_back({s.position, s.velocity});
    }
    return run;
}

/// The event hash of docs/recording.md, written once more.
inline std::uint64_t hash_of(const std::vector<Event>& events)
{
    std::uint64_t hash = 0xcbf29ce484222325u;
    const auto word = [&](std::uint64_t w) { hash = (hash ^ w) * 0x100000001b3u; };
    const auto number = [&](double x) {
        std::uint64_t bits = 0;
        if (x != 0) std::memcpy(&bits, &x, sizeof bits);
        word(bits);
    };
    for (const Event& e : events) {
        word(static_cast<std::uint64_t>(e.kind));
        word(static_cast<std::uint64_t>(static_cast<std::uint32_t>(e.a)) << 32 | static_cast<std::uint32_t>(e.b));
        word(static_cast<std::uint64_t>(e.at.epoch));
        number(e.at.offset);
        for (int k = 0; k < 3; ++k) number(e.impulse[k]);
    }
    return hash;
}

class MemorySource final : public FlightSource {
public:
    const RecordedRun& run() const override { return description; }
    bool next(Instant& instant) override
    {
        if (flight_ == flights.size()) return false;
        const std::size_t first = flight_;
        do {
            ++flight_;
        } while (flight_ < flights.size() && after[flight_] == after[first] &&
                 flights[flight_].start == flights[first].start);
        const std::size_t last = std::max(event_, std::min(after[first], events.size()));
        instant.events = std::span(events).subspan(event_, last - event_);
        instant.flights = std::span(flights).subspan(first, flight_ - first);
        event_ = last;
        return true;
    }

    /// What a forger would do: make the end agree with what is there.
    void seal()
    {
        description.end->event_hash = hash_of(events);
        description.end->events = static_cast<std::int64_t>(events.size());
        description.end->flights = static_cast<std::int64_t>(flights.size());
    }

    RecordedRun description;
    std::vector<Event> events;
    std::vector<FlightRecord> flights;
    std::vector<std::size_t> after;  ///< by flight: how many events came before

private:
    std::size_t event_ = 0, flight_ = 0;
};

inline MemorySource recorded(const Scene& scene, RunOptions options = {}, bool certified = false)
{
    if (!(options.max_seconds < 20)) options.max_seconds = 20;
    MemorySource source;
    source.description = described(scene);
    Observer observer;
    observer.on_frame = [&](const RunFrame& frame) { source.description.frame = frame; };
    observer.on_event = [&](const Event& e) { source.events.push_back(e); };
    observer.on_flight = [&](const FlightRecord& f) {
        source.flights.push_back(f);
        source.after.push_back(source.events.size());
    };
    EventDriven method;
    method.certified = source.description.certified = certified;
    const Outcome outcome = simulate(scene, method, options, observer);
    source.description.end = RecordedEnd{outcome.time, outcome.event_hash, 0, 0};
    source.description.end->events = static_cast<std::int64_t>(source.events.size());
    source.description.end->flights = static_cast<std::int64_t>(source.flights.size());
    return source;
}

/// Every pair of flights in many digits: the smallest gap of a run of flying spheres under one acceleration.
template <class Real>
Real smallest_gap(const MemorySource& source)
{
    const RecordedRun& run = source.description;
    const auto seconds = [&](const EpochTime& t) {
        return Real(t.epoch) * Real(run.frame.epoch_length) + Real(t.offset);
    };
    struct Piece {
        const FlightRecord* flight;
        Real from, to;
    };
    std::vector<std::vector<Piece>> pieces(run.spheres.size());
    for (const FlightRecord& f : source.flights) {
        auto& mine = pieces[static_cast<std::size_t>(f.body)];
        if (!mine.empty()) mine.back().to = seconds(f.start);
        mine.push_back({&f, seconds(f.start), Real(run.end->time)});
    }
    const auto place = [&](const FlightRecord& f, std::size_t k, const Real& t) {
        const Real a(run.frame.accelerations[static_cast<std::size_t>(f.acceleration)][static_cast<Eigen::Index>(k)]);
        const Real x = Real(f.cell[k]) * Real(run.frame.cell_size) + Real(f.local[k]) + Real(f.local_low[k]);
        const Real v = Real(f.velocity[k]) + Real(f.velocity_low[k]), tau = t - seconds(f.start);
        return Real(x + tau * (v + a * tau / 2));
    };
    Real smallest(1e300);
    for (std::size_t a = 0; a < pieces.size(); ++a) {
        const Real ra(run.spheres[a].radius);
        for (const Piece& p : pieces[a])
            for (const Plane& plane : run.planes) {
                const auto height = [&](const Real& t) {
                    Real h = -Real(plane.offset) - ra;
                    for (std::size_t k = 0; k < 3; ++k)
                        h += Real(plane.normal[static_cast<Eigen::Index>(k)]) * place(*p.flight, k, t);
                    return h;
                };
                smallest = std::min({smallest, height(p.from), height(p.to)});
            }
        for (std::size_t b = a + 1; b < pieces.size(); ++b)
            for (const Piece& p : pieces[a])
                for (const Piece& q : pieces[b]) {
                    const Real from = std::max(p.from, q.from), to = std::min(p.to, q.to);
                    if (!(from < to)) continue;
                    Real rv(0), vv(0);
                    std::array<Real, 3> r, v;
                    for (std::size_t k = 0; k < 3; ++k) {
                        r[k] = place(*p.flight, k, from) - place(*q.flight, k, from);
                        v[k] = (place(*p.flight, k, to) - place(*q.flight, k, to) - r[k]) / (to - from);
                        rv += r[k] * v[k];
                        vv += v[k] * v[k];
                    }
                    Real t = vv > 0 ? Real(-rv / vv) : Real(0);
                    t = std::max(Real(0), std::min(t, Real(to - from)));
                    Real square(0);
                    for (std::size_t k = 0; k < 3; ++k) square += (r[k] + v[k] * t) * (r[k] + v[k] * t);
                    smallest = std::min(smallest, Real(sqrt(square) - ra - Real(run.spheres[b].radius)));
                }
    }
    return smallest;
}

inline std::string first_violation(const Certificate& c)
{
    return c.violations.empty() ? std::string() : c.violations.front().what;
}

inline Certificate examined(MemorySource source, bool all_pairs = false)
{
    VerifyOptions options;
    options.all_pairs = all_pairs;
    return verify(source, options);
}

}  // namespace carom::test
