/// \file
/// One run in progress: the loop, for any schedule. (A template: a scene of one sphere runs without queue, broad phase
/// and stamps.)
#pragma once

#include "event_driven/impact_rate.hpp"
#include "event_driven/ledger.hpp"
#include "event_driven/resolve.hpp"
#include "event_driven/tolerances.hpp"
#include "gather/heap.hpp"
#include "heap/heap_windows.hpp"
#include "hold/guard.hpp"
#include "hold/numeric_motion.hpp"
#include "hold/support.hpp"
#include "motion/moment.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace carom {

template <class Schedule>
class Run {
public:
    Run(const Scene& scene, const Kernel& kernel, const EventDriven& method, const RunOptions& options,
        const Observer& observer)
        : state_(scene, method.certified ? Precision::certified : Precision::plain),
          ledger_(state_, kernel, observer),
          options_(options),
          observer_(observer),
          end_(state_.frame.after({}, std::isnan(options.until) ? scene.end_time : options.until)),
          schedule_(begin(), ledger_.out.counts),
          rate_(state_),
          neighbourhood_(*this),
          wide_neighbourhood_(*this),
          deadline_(deadline(options))
    {
    }

    Outcome go()
    {
        Status status = ends_at_start_ ? capped("contacts of the start") : Status::reached_end;
        while (status == Status::reached_end && state_.count() > 0) {
            const auto next = schedule_.next();
            if (next.key.time > end_) break;
            if (status = look(next.key.time); status != Status::reached_end) break;
            if (next.key.kind == Scheduled::cell_crossing)
                schedule_.leave(state_, next.key, ledger_.out.counts);
            else if (schedule_.is_stale(state_, next))
                schedule_.predict_again(state_, next, ledger_.out.counts);
            else if (!schedule_.refine(state_, next, ledger_.out.counts))
                status = carry_out(next.key);
        }
        return finish(status);
    }

private:
    using Clock = std::chrono::steady_clock;

    /// The schedule's answers, for whoever knows no schedule.
    struct Surroundings final : Neighbourhood {
        explicit Surroundings(Run& its_run) : run(its_run) {}
        std::span<const BodyId> operator()(BodyId body) const override { return run.schedule_.neighbours(body); }
        bool is_alone(BodyId body, Partner partner, const EpochTime& now) const override
        {
            return run.schedule_.is_alone(run.state_, body, partner, now);
        }
        Run& run;
    };
    /// The same for what looks further.
    struct WideSurroundings final : Neighbourhood {
        explicit WideSurroundings(Run& its_run) : run(its_run) {}
        std::span<const BodyId> operator()(BodyId body) const override { return run.schedule_.wide_neighbours(body); }
        bool is_alone(BodyId, Partner, const EpochTime&) const override { return false; }
        Run& run;
    };

    static std::optional<Clock::time_point> deadline(const RunOptions& options)
    {
        if (!(options.max_seconds < longest_deadline)) return {};
        return Clock::now() +
               std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(options.max_seconds));
    }

    /// The start: contacts that the scene declares take hold before anything is predicted.
    const State& begin()
    {
        ledger_.show_frame(state_);
        for (Change& change : initial_contacts(state_)) {
            outcome_.clear();
            outcome_.changes.push_back(std::move(change));
            commit(outcome_);
        }
        const std::vector<EventOutcome> components = begin_components(state_);
        ends_at_start_ = std::any_of(components.begin(), components.end(),
                                     [this](const EventOutcome& component) { return is_too_much(component); });
        for (const EventOutcome& component : components)
            if (component.events.empty() && !is_too_much(component)) commit(component);
        for (BodyId i = 0; i < state_.count(); ++i) ledger_.show_flight(state_, i);
        // Components with impacts have them after that, from flights that the observer has seen.
        for (const EventOutcome& component : components) {
            if (component.events.empty() || is_too_much(component)) continue;
            commit(component);
            for (const Change& change : component.changes) ledger_.show_flight(state_, change.body);
        }
        state_.bodies.begin();
        return state_;
    }

    Status carry_out(Key key)
    {
        const bool impact = key.kind == Scheduled::pair_impact || key.kind == Scheduled::plane_impact;
        if (impact && state_.bodies.some_in_piece()) key.time = time_of_contact(state_, key, now_);
        now_ = key.time;
        show_samples_before(now_);
        if constexpr (requires { &Schedule::template bounces<Ledger>; })
            if (const auto bounces = schedule_.bounces(state_, horizon(), bounces_at_once(), ledger_);
                bounces.count > 0) {
                now_ = state_.flight(0).start;
                hit_.clear();
                if (bounces.lose_energy) hit_.push_back(key.a);
                return watch(key, hit_);
            }
        if (is_of_windows(key)) return take_windows(bodies_of(key));
        outcome_.clear();
        const bool alone = resolve(state_, key, neighbourhood_, outcome_);
        if (outcome_.in_windows != no_body) {
            HeapEvent event = bodies_of(key);
            event.bodies.push_back(outcome_.in_windows);
            return take_windows(event);
        }
        if (comes_to_rest(outcome_)) return zeno(key);
        if (is_too_much(outcome_)) return capped("impacts of " + names(key));
        commit(outcome_);
        for (const Change& change : outcome_.changes) ledger_.show_flight(state_, change.body);
        schedule_.flights_changed(state_, outcome_.changes, now_, ledger_.out.counts);
        // An event of a component without an impact counts, too: the run must not stand still.
        if (!alone && impact && outcome_.events.empty()) {
            hit_.assign({key.a});
            if (key.b.is_sphere()) hit_.push_back(key.b.index);
        }
        return hit_.empty() ? limits() : watch(key, hit_);
    }

    bool is_of_windows(const Key& key) const
    {
        const bool impact = key.kind == Scheduled::pair_impact || key.kind == Scheduled::plane_impact;
        if (!impact && key.kind != Scheduled::piece_end) return false;
        return is_in_windows(state_, key.a) || (key.b.is_sphere() && is_in_windows(state_, key.b.index));
    }

    static HeapEvent bodies_of(const Key& key)
    {
        HeapEvent event{{key.a}};
        if (key.b.is_sphere()) event.bodies.push_back(key.b.index);
        return event;
    }

    Status take_windows(const HeapEvent& event)
    {
        EventOutcome windows = heap_windows(state_, event, now_, wide_neighbourhood_);
        // All of them rest, and yet they meet: the guard carries them over.
        if (windows.changes.empty()) windows = guard(state_, event.bodies.front(), now_, neighbourhood_);
        commit(windows);
        for (const Change& change : windows.changes) ledger_.show_flight(state_, change.body);
        schedule_.flights_changed(state_, windows.changes, now_, ledger_.out.counts);
        return limits();
    }

    /// Whether a body comes to rest, which ends a run under policy none.
    bool comes_to_rest(const EventOutcome& outcome) const
    {
        return state_.scene.rest.policy == RestPolicy::none &&
               std::any_of(outcome.events.begin(), outcome.events.end(),
                           [](const Event& e) { return e.kind == EventKind::rest; });
    }
    /// Whether the impact operator met its bound, which ends a run unless the scene accepts it.
    bool is_too_much(const EventOutcome& outcome) const
    {
        return outcome.capped && state_.scene.impact.on_cap == OnCap::stop;
    }
    Status capped(const std::string& which)
    {
        return stop(Status::unresolved, which +
                                            " exceed the bound of the impact operator (take another, or "
                                            "\"impact\": {\"on_cap\": \"accept\"} for inelastic ones)");
    }
    std::string names(const Key& key) const
    {
        const std::string& first = state_.scene.body_name(key.a);
        if (key.b.kind == Partner::Kind::none) return first;
        return first + " and " + state_.scene.body_name(state_.body_of(key.b));
    }
    Status zeno(const Key& key) { return stop(Status::zeno, "impacts of " + names(key) + " accumulate: a Zeno point"); }

    /// Counts an impact of each of these bodies; where impacts accumulate the guard takes over.
    Status watch(const Key& key, std::span<const BodyId> bodies)
    {
        for (const BodyId body : bodies) {
            if (state_.is_fixed(body) || !rate_.add(state_, now_, body)) continue;
            if (!rate_.accumulates(state_, now_, guarded_bodies(state_, body, now_, neighbourhood_, rate_.enough())))
                continue;
            if (state_.scene.rest.policy == RestPolicy::none) return zeno(key);
            if (!state_.scene.guard.on)
                return stop(Status::unresolved, "impacts of " + names(key) + " accumulate, and the guard is off");
            if (is_hot_heap(body)) return take_windows({{body}, true});
            const EventOutcome window = guard(state_, body, now_, neighbourhood_);
            commit(window);
            for (const Change& change : window.changes) ledger_.show_flight(state_, change.body);
            schedule_.flights_changed(state_, window.changes, now_, ledger_.out.counts);
            break;
        }
        return limits();
    }

    /// Whether the body is of a heap for which there are windows.
    bool is_hot_heap(BodyId body) const
    {
        return has_windows(state_) && is_in_heap(state_, body, now_, neighbourhood_);
    }

    /// Carries an outcome into the state and the books: the one place where motions change, but for streaks of
    /// bounces of a lone sphere.
    void commit(const EventOutcome& outcome)
    {
        hit_.clear();
        const auto flies_on = [&](const Change& change) {
            return state_.bodies.kind(change.body) == MotionKind::flying &&
                   kind_of(change.motion) == MotionKind::flying;
        };
        for (const Change& change : outcome.changes) {
            if (flies_on(change)) continue;  // nothing to enter for these: nearly all
            ledger_.account_for_motion(state_, change.body, now_);
            ledger_.note_motion(state_, change.body, change.motion, now_);
        }
        for (const Change& change : outcome.changes) state_.bodies.set(change);
        for (const ForceChange& change : outcome.forces) {
            ledger_.forces_change(state_, change.body, now_);
            state_.bodies.set_forces(change.body, change.contacts);
        }
        ledger_.add(outcome);
        for (const Event& event : outcome.events) record(event, outcome.dies_out);
    }

    void record(const Event& event, bool dies_out)
    {
        if (state_.loses_energy && event.kind == EventKind::impact &&
            state_.law(event.a, state_.partner_of(event.b)).restitution < 1) {
            state_.recent.add(event.a, event.b, now_);
            if (!dies_out) hit_.push_back(state_.is_fixed(event.a) ? event.b : event.a);
        }
        ledger_.record(state_, now_, event);
    }

    /// The time until which nothing but an event changes what an observer would see.
    EpochTime horizon() const
    {
        if (next_sample_ == observer_.sample_times.size()) return end_;
        return std::min(end_, state_.frame.after({}, observer_.sample_times[next_sample_]));
    }

    int bounces_at_once() const
    {
        return static_cast<int>(std::min<std::int64_t>(look_every, options_.max_events - ledger_.events()));
    }

    Status limits() { return ledger_.events() < options_.max_events ? Status::reached_end : event_limit(); }
    Status event_limit()
    {
        return stop(Status::event_limit, "the limit of " + std::to_string(options_.max_events) + " events");
    }

    /// Now and then, also where nothing happens but cell crossings: is there time, and does the observer want more?
    Status look(const EpochTime& time)
    {
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
        states_.resize(state_.scene.spheres.size());
        Moment moment(state_, time);
        for (BodyId i = 0; i < state_.count(); ++i) {
            BodyState& state = states_[static_cast<std::size_t>(i)];
            state.mode = mode_of(state_.bodies.motion(i));
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
        double moving = 0;
        for (BodyId i = 0; i < state_.count(); ++i) {
            ledger_.account_for_motion(state_, i, now_);
            moving += state_.is_fixed(i) ? 0 : 1;
        }
        Outcome& out = ledger_.out;
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
    EventOutcome outcome_;     ///< of the present event
    std::vector<BodyId> hit_;  ///< one that can move for each impact of the present event that loses energy
    const RunOptions& options_;
    const Observer& observer_;
    EpochTime end_, now_;
    bool ends_at_start_ = false;
    Schedule schedule_;
    ImpactRate rate_;
    const Surroundings neighbourhood_;
    const WideSurroundings wide_neighbourhood_;
    std::optional<Clock::time_point> deadline_;
    std::size_t next_sample_ = 0;
    std::int64_t looked_at_ = 0;
    std::vector<BodyState> states_;
};

}  // namespace carom
