/// \file
/// One run in progress: the loop, for any schedule. (A template: a scene of one sphere runs without queue, broad phase
/// and stamps.)
#pragma once

#include "event_driven/guard.hpp"
#include "event_driven/impact_rate.hpp"
#include "event_driven/ledger.hpp"
#include "event_driven/motion.hpp"
#include "event_driven/numeric_motion.hpp"
#include "event_driven/piece.hpp"
#include "event_driven/resolve.hpp"
#include "event_driven/resolve_component.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>

namespace carom {

template <class Schedule>
class Run {
public:
    Run(const Scene& scene, const Kernel& kernel, const EventDriven& method, const RunOptions& options,
        const Observer& observer)
        : state_(scene, method.certified),
          ledger_(state_, kernel, observer),
          options_(options),
          observer_(observer),
          end_(state_.frame.after({}, std::isnan(options.until) ? scene.end_time : options.until)),
          schedule_(begin(), method.broad_phase, ledger_.out.counts),
          rate_(state_),
          neighbourhood_([this](BodyId body) { return schedule_.neighbours(body); }),
          deadline_(deadline(options))
    {
    }

    Outcome go()
    {
        Status status = Status::reached_end;
        while (status == Status::reached_end && state_.count() > 0) {
            const auto next = schedule_.next();
            if (next.key.time > end_) break;
            if (status = look(next.key.time); status != Status::reached_end) break;
            if (next.key.kind == Scheduled::cell_crossing)
                schedule_.cross(state_, next.key, ledger_.out.counts);
            else if (schedule_.is_stale(state_, next))
                schedule_.predict_again(state_, next, ledger_.out.counts);
            else if (!schedule_.refine(state_, next, ledger_.out.counts))
                status = execute(next.key);
        }
        return finish(status);
    }

private:
    using Clock = std::chrono::steady_clock;

    static std::optional<Clock::time_point> deadline(const RunOptions& options)
    {
        if (!(options.max_seconds < 1e9)) return {};
        return Clock::now() +
               std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(options.max_seconds));
    }

    /// Contacts of the start take hold before anything is predicted.
    const State& begin()
    {
        ledger_.show_frame(state_);
        for (const Change& change : initial_contacts(state_)) commit(change, {});
        const std::vector<ComponentResolution> components = begin_components(state_);
        for (const ComponentResolution& component : components)
            if (component.events.empty()) commit(component);
        for (BodyId i = 0; i < state_.count(); ++i) ledger_.show_flight(state_, i);
        // Those that close have their impacts then, from flights that everybody has seen.
        for (const ComponentResolution& component : components) {
            if (component.events.empty()) continue;
            commit(component);
            for (const MemberChange& change : component.changes) ledger_.show_flight(state_, change.body);
        }
        for (std::uint32_t& stamp : state_.stamps) stamp = 0;
        return state_;
    }

    Status execute(Key key)
    {
        if (!state_.pieces.empty() && (key.kind == Scheduled::pair_impact || key.kind == Scheduled::plane_impact))
            key.time = time_of_contact(state_, key, now_);
        now_ = key.time;
        show_samples_before(now_);
        if constexpr (requires { &Schedule::bounces; })
            if (const auto bounces = schedule_.bounces(state_, horizon(), bounces_at_once(), ledger_);
                bounces.count > 0) {
                now_ = state_.flights[0].start;
                hit_.clear();
                if (bounces.lose_energy) hit_.push_back(key.a);
                return watch(key, hit_);
            }
        hit_.clear();
        const Resolution resolution = resolve(state_, key, neighbourhood_);
        if (resolution.coupled) return execute_component(key);
        if (comes_to_rest(resolution.events)) return zeno(key);
        for (const Change& change : resolution.changes) commit(change, resolution.series);
        ledger_.out.max_penetration = std::max(ledger_.out.max_penetration, resolution.penetration);
        for (const Event& event : resolution.events) report(event);
        for (const Change& change : resolution.changes) ledger_.show_flight(state_, change.body);
        for (const Change& changed : resolution.changes)
            schedule_.flight_changed(state_, changed.body, now_, ledger_.out.counts);
        return hit_.empty() ? limits() : watch(key, hit_);
    }

    /// An event of bodies in several contacts.
    Status execute_component(const Key& key)
    {
        const ComponentResolution resolution = resolve_component(state_, key, neighbourhood_);
        if (comes_to_rest(resolution.events)) return zeno(key);
        execute(resolution);
        // Not to stand still: an event without an impact counts, too.
        if (key.kind != Scheduled::piece_end && resolution.events.empty()) return watch(key, std::array{key.a, key.b});
        return watch(key, hit_);
    }

    /// Where policy none stops.
    template <class Events>
    bool comes_to_rest(const Events& events) const
    {
        return state_.scene.rest.policy == RestPolicy::none &&
               std::any_of(events.begin(), events.end(), [](const Event& e) { return e.kind == EventKind::rest; });
    }
    Status zeno(const Key& key)
    {
        return stop(Status::zeno, "impacts of " + state_.scene.body_name(key.a) + " and " +
                                      state_.scene.body_name(key.b) + " accumulate: a Zeno point");
    }

    /// Impacts of these bodies may accumulate.
    template <class Bodies>
    Status watch(const Key& key, const Bodies& bodies)
    {
        for (const BodyId body : bodies) {
            if (state_.is_plane(body) || state_.is_fixed(body) || !rate_.add(state_, now_, body)) continue;
            if (!rate_.accumulates(state_, now_, guarded_bodies(state_, body, now_, neighbourhood_, rate_.enough())))
                continue;
            if (state_.scene.rest.policy == RestPolicy::none) return zeno(key);
            if (!state_.scene.guard.on)
                return stop(Status::unresolved, "impacts of " + state_.scene.body_name(key.a) + " and " +
                                                    state_.scene.body_name(key.b) +
                                                    " accumulate, and the guard is off");
            execute(guard(state_, body, now_, neighbourhood_));
            break;
        }
        return limits();
    }

    void execute(const ComponentResolution& resolution)
    {
        commit(resolution);
        for (const MemberChange& change : resolution.changes)
            if (!change.rests_on) ledger_.show_flight(state_, change.body);
        changed_.clear();
        for (const MemberChange& change : resolution.changes)
            if (!change.rests_on) changed_.push_back(change.body);
        schedule_.flights_changed(state_, changed_, now_, ledger_.out.counts);
    }

    void report(const Event& event)
    {
        if (state_.loses_energy && event.kind == EventKind::impact && state_.law(event.a, event.b).restitution < 1) {
            state_.recent.add(event.a, event.b, now_);
            hit_.push_back(state_.is_fixed(event.a) ? event.b : event.a);
        }
        ledger_.report(state_, now_, event);
    }

    /// Nothing but an event changes what an observer would see until then.
    EpochTime horizon() const
    {
        if (next_sample_ == observer_.sample_times.size()) return end_;
        return std::min(end_, state_.frame.after({}, observer_.sample_times[next_sample_]));
    }

    int bounces_at_once() const
    {
        return static_cast<int>(std::min<std::int64_t>(256, options_.max_events - ledger_.events()));
    }

    void commit(const Change& change, const Series& series)
    {
        Flight& flight = state_.flights[static_cast<std::size_t>(change.body)];
        // Nothing to enter for those that flew and fly: nearly all.
        if (flight.mode != Mode::flying || change.flight.mode != Mode::flying) {
            ledger_.account_for_support(state_, change.body, now_);
            ledger_.note_mode(state_, change.body, change.flight.mode, now_);
            if (flight.mode == Mode::series) state_.series.erase(change.body);
        }
        flight = change.flight;
        if (state_.certified()) state_.low[static_cast<std::size_t>(change.body)] = change.low;
        if (flight.mode == Mode::series) state_.series[change.body] = series;
        ++state_.stamps[static_cast<std::size_t>(change.body)];
    }

    void commit(const ComponentResolution& resolution)
    {
        for (const MemberChange& change : resolution.changes) {
            if (change.rests_on) continue;
            ledger_.account_for_support(state_, change.body, now_);
            ledger_.note_mode(state_, change.body, change.flight.mode, now_);
        }
        for (const MemberChange& change : resolution.changes) {
            if (change.rests_on) {
                ledger_.forces_change(state_, change.body, now_);
                state_.contacts.set_forces(change.body, change.contacts);
                continue;
            }
            state_.series.erase(change.body);
            state_.pieces.erase(change.body);
            if (state_.accelerations.is_own(change.flight.acceleration))
                state_.accelerations.set_own(change.body, change.acceleration);
            if (change.flight.mode == Mode::numeric) state_.pieces[change.body] = change.piece;
            state_.contacts.set(change.body, change.contacts, state_.count());
            state_.flights[static_cast<std::size_t>(change.body)] = change.flight;
            if (state_.certified()) state_.low[static_cast<std::size_t>(change.body)].setZero();
            ++state_.stamps[static_cast<std::size_t>(change.body)];
        }
        Outcome& out = ledger_.out;
        out.max_penetration = std::max(out.max_penetration, resolution.penetration);
        out.counts.clusters += resolution.clustered ? 1 : 0;
        out.counts.capped += resolution.capped ? 1 : 0;
        out.counts.numeric_steps += resolution.numeric_steps;
        ledger_.take(resolution.taken);
        for (const Event& event : resolution.events) report(event);
    }

    Status limits() { return ledger_.events() < options_.max_events ? Status::reached_end : event_limit(); }
    Status event_limit()
    {
        return stop(Status::event_limit, "the limit of " + std::to_string(options_.max_events) + " events");
    }

    /// Now and then, also where nothing happens but cell crossings: is there time, and does the observer want more?
    Status look(const EpochTime& time)
    {
        constexpr std::int64_t look_every = 256;
        if (++looked_at_ % look_every != 0) return Status::reached_end;
        const bool late = deadline_ && Clock::now() > *deadline_;
        if (!late && (!observer_.on_progress || observer_.on_progress(state_.frame.seconds(time))))
            return Status::reached_end;
        now_ = time;
        show_samples_before(now_);
        return late ? stop(Status::time_limit, "the limit of " + std::to_string(options_.max_seconds) + " s")
                    : stop(Status::interrupted, "interrupted");
    }

    Status stop(Status status, const std::string& why)
    {
        ledger_.out.message = why + ", at t = " + std::to_string(state_.frame.seconds(now_));
        return status;
    }

    void show_samples_before(const EpochTime& time)
    {
        while (next_sample_ < observer_.sample_times.size()) {
            const double t = observer_.sample_times[next_sample_];
            const EpochTime at = state_.frame.after({}, t);
            if (!(at < time)) return;
            if (observer_.on_sample) observer_.on_sample(next_sample_, t, states_at(at));
            ++next_sample_;
        }
    }

    const std::vector<BodyState>& states_at(const EpochTime& time)
    {
        states_.resize(state_.flights.size());
        Moment moment(state_, time);
        for (BodyId i = 0; i < state_.count(); ++i) {
            BodyState& state = states_[static_cast<std::size_t>(i)];
            state.mode = state_.flight(i).mode;
            const Flight f = moment.flight(i);
            state.position = position_of(state_.frame, f.place);
            state.velocity = f.velocity;
        }
        return states_;
    }

    Outcome finish(Status status)
    {
        if (status == Status::reached_end) {
            now_ = end_;
            show_samples_before(never);
        }
        for (BodyId i = 0; i < state_.count(); ++i) ledger_.account_for_support(state_, i, now_);
        Outcome& out = ledger_.out;
        double moving = 0;
        for (BodyId i = 0; i < state_.count(); ++i) moving += state_.is_fixed(i) ? 0 : 1;
        out.body_seconds.closed_form =
            moving * state_.frame.seconds(now_) - (out.body_seconds.numeric + out.body_seconds.guarded);
        out.status = status;
        out.time = state_.frame.seconds(now_);
        out.final = states_at(now_);
        out.event_hash = ledger_.hash();
        return std::move(out);
    }

    State state_;
    Ledger ledger_;
    std::vector<BodyId> changed_;  ///< by the present event of a component
    std::vector<BodyId> hit_;      ///< one that can move for each impact of the present event that loses energy
    const RunOptions& options_;
    const Observer& observer_;
    EpochTime end_, now_;
    Schedule schedule_;
    ImpactRate rate_;
    Neighbourhood neighbourhood_;
    std::optional<Clock::time_point> deadline_;
    std::size_t next_sample_ = 0;
    std::int64_t looked_at_ = 0;
    std::vector<BodyState> states_;
};

}  // namespace carom
