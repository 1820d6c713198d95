#include "event_driven/engine.hpp"

#include "core/expect.hpp"
#include "event_driven/event_hash.hpp"
#include "event_driven/motion.hpp"
#include "event_driven/resolve.hpp"
#include "event_driven/schedule.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace carom {

namespace {

using Clock = std::chrono::steady_clock;

/// One run in progress.
class Run {
public:
    Run(const Scene& scene, const EventDriven& method, const RunOptions& options, const Observer& observer)
        : state_(scene),
          options_(options),
          observer_(observer),
          end_(state_.frame.after({}, std::isnan(options.until) ? scene.end_time : options.until)),
          recent_(scene.spheres.size()),
          deadline_(deadline(options))
    {
        out_.kernel = "general";
        out_.epoch_length = state_.frame.epoch_length;
        out_.rest_times.resize(scene.spheres.size());
        out_.plane_impulses.assign(scene.planes.size(), 0);
        for (const Change& change : initial_contacts(state_)) {
            state_.flights[index(change.body)] = change.flight;
            out_.rest_times[index(change.body)] = 0.0;
        }
        schedule_.emplace(state_, method.broad_phase, out_.counts);
    }

    Outcome go()
    {
        Status status = Status::reached_end;
        while (status == Status::reached_end && state_.count() > 0) {
            const Schedule::Next next = schedule_->next();
            if (next.key.time > end_) break;
            if (status = look(next.key.time); status != Status::reached_end) break;
            if (next.key.kind == Scheduled::cell_crossing)
                schedule_->cross(state_, next.key, out_.counts);
            else if (schedule_->is_stale(state_, next))
                predict_again(next);
            else
                status = execute(next.key);
        }
        return finish(status);
    }

private:
    static std::size_t index(BodyId body) { return static_cast<std::size_t>(body); }

    static std::optional<Clock::time_point> deadline(const RunOptions& options)
    {
        if (!(options.max_seconds < 1e9)) return {};
        return Clock::now() +
               std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(options.max_seconds));
    }

    void predict_again(const Schedule::Next& next)
    {
        ++out_.counts.stale;
        schedule_->examine(state_, static_cast<BodyId>(next.slot), out_.counts);
    }

    Status execute(const Key& key)
    {
        now_ = key.time;
        show_samples_before(now_);
        const Resolution resolution = resolve(state_, key, [this](BodyId body) { return schedule_->neighbours(body); });
        if (!resolution.unresolved.empty()) return stop(Status::unresolved, resolution.unresolved);
        for (const Change& change : resolution.changes) commit(change);
        out_.max_penetration = std::max(out_.max_penetration, resolution.penetration);
        for (const Event& event : resolution.events) report(event);
        for (const Change& change : resolution.changes) {
            schedule_->examine(state_, change.body, out_.counts);
            schedule_->watch_cell(state_, change.body, now_, out_.counts);
        }
        return limits(key, resolution);
    }

    void commit(const Change& change)
    {
        account_for_support(change.body);
        state_.flights[index(change.body)] = change.flight;
        ++state_.stamps[index(change.body)];
        if (change.flight.mode == Mode::series)
            state_.series[change.body] = change.series;
        else
            state_.series.erase(change.body);
    }

    void report(Event event)
    {
        event.at = now_;
        event.time = state_.frame.seconds(now_);
        Counts& n = out_.counts;
        if (event.kind == EventKind::impact) {
            ++n.impacts;
            if (state_.is_plane(event.b))
                out_.plane_impulses[static_cast<std::size_t>(state_.plane_index(event.b))] +=
                    event.impulse.dot(event.normal);
        } else if (event.kind == EventKind::rest) {
            ++n.rests;
            out_.rest_times[index(event.a)] = event.time;
        } else if (event.kind == EventKind::release) {
            ++n.releases;
            out_.rest_times[index(event.a)].reset();
        }
        hash_.add(event);
        if (observer_.on_event) observer_.on_event(event);
    }

    /// What a plane has carried since the body's flight began, from the balance of normal momentum.
    void account_for_support(BodyId body)
    {
        const Flight& f = state_.flight(body);
        if (f.support < 0) return;
        const Vec3 normal = facing_normal(state_, f.support, f.place);
        const Flight after = advanced(state_, body, now_);
        const Vec3& g = state_.accelerations[state_.accelerations.free()];
        const double change = normal.dot(after.velocity) - normal.dot(f.velocity);
        out_.plane_impulses[static_cast<std::size_t>(f.support)] +=
            state_.sphere(body).mass * (change - state_.frame.between(f.start, now_) * normal.dot(g));
    }

    Status limits(const Key& key, const Resolution& resolution)
    {
        const Counts& n = out_.counts;
        const std::int64_t events = n.impacts + n.rests + n.releases;
        if (events >= options_.max_events)
            return stop(Status::event_limit, "the limit of " + std::to_string(options_.max_events) + " events");
        if (accumulates(key, resolution))
            return stop(Status::unresolved,
                        "impacts of " + state_.scene.body_name(key.a) + " and " + state_.scene.body_name(key.b) +
                            " accumulate: coming to rest on spheres or on several planes is not resolved yet");
        return Status::reached_end;
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

    /// More impacts of one body within one step h than any number of separate contacts explains, at a restitution below
    /// 1: a Zeno point that nobody sums. (The bound B of the design; at restitution 1 only `max_events` bounds a run.)
    bool accumulates(const Key& key, const Resolution& resolution)
    {
        constexpr int bound = 100;
        if (resolution.events.empty() || resolution.events.front().kind != EventKind::impact) return false;
        const bool plane = state_.is_plane(key.b);
        const double e =
            plane ? state_.laws.plane(state_.sphere(key.a).material, state_.plane(state_.plane_index(key.b)).material)
                        .restitution
                  : state_.laws.spheres(state_.sphere(key.a).material, state_.sphere(key.b).material).restitution;
        if (e >= 1) return false;
        bool too_many = false;
        for (const Change& change : resolution.changes) {
            Recent& recent = recent_[index(change.body)];
            if (recent.count == 0 || state_.frame.between(recent.since, now_) > state_.rest.numeric_step)
                recent = {now_, 0};
            too_many = ++recent.count > bound || too_many;
        }
        return too_many;
    }

    Status stop(Status status, const std::string& why)
    {
        out_.message = why + ", at t = " + std::to_string(state_.frame.seconds(now_));
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
        for (BodyId i = 0; i < state_.count(); ++i) states_[index(i)] = state_of(state_, i, time);
        return states_;
    }

    Outcome finish(Status status)
    {
        if (status == Status::reached_end) {
            now_ = end_;
            show_samples_before(never);
        }
        for (BodyId i = 0; i < state_.count(); ++i) account_for_support(i);
        out_.status = status;
        out_.time = state_.frame.seconds(now_);
        out_.final = states_at(now_);
        out_.event_hash = hash_.value();
        return std::move(out_);
    }

    struct Recent {
        EpochTime since;
        int count = 0;
    };

    State state_;
    const RunOptions& options_;
    const Observer& observer_;
    EpochTime end_, now_;
    std::optional<Schedule> schedule_;
    EventHash hash_;
    std::vector<Recent> recent_;  ///< by body: impacts in the current window
    std::optional<Clock::time_point> deadline_;
    std::size_t next_sample_ = 0;
    std::int64_t looked_at_ = 0;
    std::vector<BodyState> states_;
    Outcome out_;
};

}  // namespace

Outcome run_event_driven(const Scene& scene, const EventDriven& method, const RunOptions& options,
                         const Observer& observer)
{
    return Run(scene, method, options, observer).go();
}

}  // namespace carom
