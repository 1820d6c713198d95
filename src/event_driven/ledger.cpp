#include "event_driven/ledger.hpp"

#include "motion/relative.hpp"

namespace carom {

namespace {

/// Counters of the kinds of events, in the order of EventKind.
constexpr std::int64_t Counts::*counters[] = {&Counts::impacts, &Counts::rests, &Counts::releases, &Counts::guarded,
                                              &Counts::settles};
static_assert(std::size(counters) == event_kind_names.size());

}  // namespace

Ledger::Ledger(const State& state, const Kernel& kernel, const Observer& observer) : observer_(observer)
{
    out.kernel = kernel.name;
    out.epoch_length = state.frame.epoch_length;
    out.rest_times.resize(state.scene.spheres.size());
    out.plane_impulses.assign(state.scene.planes.size(), 0);
}

void Ledger::show_frame(const State& state) const
{
    if (!observer_.on_frame) return;
    RunFrame frame{state.frame.epoch_length, state.frame.cell_size, state.scene.drag, {}};
    const Accelerations& accelerations = state.bodies.accelerations();
    for (AccelerationId id = 0; id < accelerations.shared(); ++id) frame.accelerations.push_back(accelerations[id]);
    observer_.on_frame(frame);
}

FlightRecord Ledger::record_of(const State& state, BodyId body)
{
    const Flight& f = state.flight(body);
    const Motion& motion = state.bodies.motion(body);
    FlightRecord record;
    record.body = body;
    record.start = f.start;
    for (std::size_t k = 0; k < 3; ++k) {
        record.cell[k] = f.place.cell[k];
        record.local[k] = f.place.local[k];
        record.local_low[k] = f.place.low[k];
        record.velocity[k] = f.velocity[static_cast<Eigen::Index>(k)];
    }
    record.acceleration = f.acceleration;
    if (state.bodies.accelerations().is_own(f.acceleration)) {
        record.acceleration = own_acceleration;
        for (std::size_t k = 0; k < 3; ++k) record.own[k] = state.acceleration(f)[static_cast<Eigen::Index>(k)];
    }
    record.mode = mode_of(motion);
    // A parabola in a window is a piece as numeric steps are.
    record.guarded = std::holds_alternative<Windowed>(motion) && f.acceleration == Accelerations::none;
    if (state.bodies.is_held_by_several(body)) record.support = several_supports;
    if (const std::optional<int> carrier = carrier_of(motion)) record.support = *carrier;
    if (const auto* bouncing = std::get_if<Bouncing>(&motion)) {
        const Series& s = bouncing->series;
        record.series =
            SeriesRecord{s.normal_speed, s.gravity, s.restitution, s.tangential, s.velocity, s.acceleration};
    }
    return record;
}

void Ledger::show(Event event) const
{
    event.time = Frame{out.epoch_length, 1}.seconds(event.at);
    observer_.on_event(event);
}

void Ledger::record(const State& state, const EpochTime& now, Event event)
{
    event.at = now;
    ++(out.counts.*counters[static_cast<std::size_t>(event.kind) - first_event_kind]);
    if (const Partner b = state.partner_of(event.b); event.kind == EventKind::impact && b.is_plane())
        out.plane_impulses[static_cast<std::size_t>(b.index)] += event.impulse.dot(event.normal);
    hash_.add(event);
    if (observer_.on_event) show(event);
}

void Ledger::note_motion(const State& state, BodyId body, const Motion& next, const EpochTime& now)
{
    std::optional<double>& rest = out.rest_times[static_cast<std::size_t>(body)];
    const auto* window = std::get_if<Windowed>(&next);  // that of a heap is no rest
    const bool was_held = is_held(state.bodies.kind(body)) && !state.bodies.is_in_heap_window(body);
    if (!is_held(kind_of(next)) || (window && window->piece))
        rest.reset();
    else if (!was_held)
        rest = state.frame.seconds(now);
}

void Ledger::add(const EventOutcome& outcome)
{
    out.max_penetration = std::max(out.max_penetration, outcome.penetration);
    out.counts.clusters += outcome.clustered ? 1 : 0;
    out.counts.capped += outcome.capped ? 1 : 0;
    out.counts.numeric_steps += outcome.numeric_steps;
    out.energy_taken.closing += outcome.taken.closing;
    out.energy_taken.settling += outcome.taken.settling;
    out.energy_taken.stabilising += outcome.taken.stabilising;
    out.energy_taken.guard += outcome.taken.guard;
    out.energy_taken.window += outcome.taken.window;
    out.energy_taken.capped += outcome.taken.capped;
    if (!outcome.early_rest) return;
    ++out.counts.early_rests;
    if (!out.early_rest || out.early_rest->time < outcome.early_rest->time) out.early_rest = outcome.early_rest;
}

void Ledger::account_for_forces(const State& state, BodyId body, const EpochTime& now)
{
    EpochTime since = state.flight(body).start;
    if (const auto found = accounted_.find(body); found != accounted_.end()) since = std::max(since, found->second);
    for (const PersistentContact& c : state.bodies.contacts().of(body))
        if (c.partner.is_plane())
            out.plane_impulses[static_cast<std::size_t>(c.partner.index)] += c.force * state.frame.between(since, now);
}

void Ledger::forces_change(const State& state, BodyId body, const EpochTime& now)
{
    account_for_forces(state, body, now);
    accounted_[body] = now;
}

void Ledger::account_for_motion(const State& state, BodyId body, const EpochTime& now)
{
    const Flight& f = state.flight(body);
    const Motion& motion = state.bodies.motion(body);
    const double time = state.frame.between(f.start, now);
    if (std::holds_alternative<Stepping>(motion)) out.body_seconds.numeric += time;
    if (std::holds_alternative<Windowed>(motion)) out.body_seconds.guarded += time;
    if (state.bodies.is_held_by_several(body)) account_for_forces(state, body, now);
    const std::optional<int> carrier = carrier_of(motion);
    if (!carrier) return;
    const Vec3 normal = facing_normal(state, *carrier, f.place);
    const double change = normal.dot(advanced(state, body, now).velocity) - normal.dot(f.velocity);
    out.plane_impulses[static_cast<std::size_t>(*carrier)] +=
        state.sphere(body).mass * (change - time * normal.dot(state.gravity()));
}

}  // namespace carom
