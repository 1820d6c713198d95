/// \file
/// The books of a run: events reported, counted and hashed, and what the planes carried.
#pragma once

#include "event_driven/event_hash.hpp"
#include "hold/outcome.hpp"
#include "motion/state.hpp"

#include <carom/features.hpp>

#include <algorithm>
#include <unordered_map>

namespace carom {

class Ledger {
public:
    Ledger(const State& state, const Kernel& kernel, const Observer& observer);

    /// Record the impact of a sphere on a plane, at event.at.
    void record_bounce(const Event& impact, int plane, double penetration)
    {
        ++out.counts.impacts;
        out.plane_impulses[static_cast<std::size_t>(plane)] += impact.impulse.dot(impact.normal);
        out.max_penetration = std::max(out.max_penetration, penetration);
        hash_.add(impact);
        if (observer_.on_event) show(impact);
    }
    /// Record an event that happens at `now`.
    void record(const State& state, const EpochTime& now, Event event);
    /// Show the observer what the run consists of, and each flight as it begins.
    void show_frame(const State& state) const;
    bool shows_flights() const { return static_cast<bool>(observer_.on_flight); }
    void show_flight(const State& state, BodyId body) const
    {
        if (observer_.on_flight) observer_.on_flight(record_of(state, body));
    }
    /// Add what a plane has carried since the body's flight began, from the balance of normal momentum, and the time in
    /// pieces. Call before the motion changes.
    void account_for_motion(const State& state, BodyId body, const EpochTime& now);

    /// The same where a body in several contacts goes on resting under other forces. Call before they change.
    void forces_change(const State& state, BodyId body, const EpochTime& now);

    /// A body's motion becomes another one at `now`. Call before it does.
    void note_motion(const State& state, BodyId body, const Motion& next, const EpochTime& now);
    /// What an event counts beside its events, and what thresholds took.
    void add(const EventOutcome& outcome);

    std::int64_t events() const
    {
        const Counts& c = out.counts;
        return c.impacts + c.rests + c.releases + c.guarded + c.settles + c.numeric_steps;
    }
    std::uint64_t hash() const { return hash_.value(); }

    Outcome out;

private:
    void show(Event event) const;
    void account_for_forces(const State& state, BodyId body, const EpochTime& now);
    static FlightRecord record_of(const State& state, BodyId body);

    const Observer& observer_;
    EventHash hash_;
    std::unordered_map<BodyId, EpochTime> accounted_;  ///< of forces_change, by body: when
};

}  // namespace carom
