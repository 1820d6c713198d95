#include "event_driven/ledger.hpp"

#include "event_driven/motion.hpp"

namespace carom {

Ledger::Ledger(const State& state, const Kernel& kernel, const Observer& observer) : observer_(observer)
{
    out.kernel = kernel.name;
    out.epoch_length = state.frame.epoch_length;
    out.rest_times.resize(state.flights.size());
    out.plane_impulses.assign(state.scene.planes.size(), 0);
}

void Ledger::show_frame(const State& state) const
{
    if (!observer_.on_frame) return;
    RunFrame frame{state.frame.epoch_length, state.frame.cell_size, {}};
    for (AccelerationId id = 0; id < state.accelerations.shared(); ++id)
        frame.accelerations.push_back(state.accelerations[id]);
    observer_.on_frame(frame);
}

FlightRecord Ledger::record_of(const State& state, BodyId body)
{
    const Flight& f = state.flight(body);
    FlightRecord record;
    record.body = body;
    record.start = f.start;
    for (std::size_t k = 0; k < 3; ++k) {
        record.cell[k] = f.place.cell[k];
        record.local[k] = f.place.local[k];
        if (state.certified())
            record.local_low[k] = state.low[static_cast<std::size_t>(body)][static_cast<Eigen::Index>(k)];
        record.velocity[k] = f.velocity[static_cast<Eigen::Index>(k)];
    }
    record.acceleration = f.acceleration;
    if (state.accelerations.is_own(f.acceleration)) {
        record.acceleration = own_acceleration;
        for (std::size_t k = 0; k < 3; ++k)
            record.own[k] = state.accelerations[f.acceleration][static_cast<Eigen::Index>(k)];
    }
    record.guarded = f.mode == Mode::numeric && !state.pieces.at(body).cluster;
    record.support = f.support;
    record.mode = f.mode;
    if (f.mode == Mode::series) {
        const Series& s = state.series.at(body);
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

void Ledger::report(const State& state, const EpochTime& now, Event event)
{
    event.at = now;
    if (event.kind == EventKind::impact) {
        ++out.counts.impacts;
        if (state.is_plane(event.b))
            out.plane_impulses[static_cast<std::size_t>(state.plane_index(event.b))] += event.impulse.dot(event.normal);
    } else if (event.kind == EventKind::rest) {
        ++out.counts.rests;
    } else if (event.kind == EventKind::release) {
        ++out.counts.releases;
    } else if (event.kind == EventKind::guard) {
        ++out.counts.guarded;
    } else if (event.kind == EventKind::settle) {
        ++out.counts.settles;
    }
    hash_.add(event);
    if (observer_.on_event) show(event);
}

void Ledger::note_mode(const State& state, BodyId body, Mode next, const EpochTime& now)
{
    const auto is_held = [](Mode mode) {
        return mode == Mode::resting || mode == Mode::sliding || mode == Mode::numeric;
    };
    std::optional<double>& rest = out.rest_times[static_cast<std::size_t>(body)];
    if (!is_held(next))
        rest.reset();
    else if (!is_held(state.flight(body).mode))
        rest = state.frame.seconds(now);
}

void Ledger::take(const EnergyTaken& taken)
{
    out.energy_taken.closing += taken.closing;
    out.energy_taken.settling += taken.settling;
    out.energy_taken.stabilising += taken.stabilising;
    out.energy_taken.guard += taken.guard;
    out.energy_taken.capped += taken.capped;
}

void Ledger::account_for_forces(const State& state, BodyId body, const EpochTime& now)
{
    EpochTime since = state.flight(body).start;
    if (const auto found = accounted_.find(body); found != accounted_.end()) since = std::max(since, found->second);
    for (const PersistentContact& c : state.contacts.of(body))
        if (state.is_plane(c.partner))
            out.plane_impulses[static_cast<std::size_t>(state.plane_index(c.partner))] +=
                c.force * state.frame.between(since, now);
}

void Ledger::forces_change(const State& state, BodyId body, const EpochTime& now)
{
    account_for_forces(state, body, now);
    accounted_[body] = now;
}

void Ledger::account_for_support(const State& state, BodyId body, const EpochTime& now)
{
    const Flight& f = state.flight(body);
    if (f.mode == Mode::numeric)
        (state.pieces.at(body).cluster ? out.body_seconds.numeric : out.body_seconds.guarded) +=
            state.frame.between(f.start, now);
    if (f.support == several_supports) account_for_forces(state, body, now);
    if (f.support < 0) return;
    const Vec3 normal = facing_normal(state, f.support, f.place);
    const Flight after = advanced(state, body, now);
    const Vec3& g = state.accelerations[state.accelerations.free()];
    const double change = normal.dot(after.velocity) - normal.dot(f.velocity);
    out.plane_impulses[static_cast<std::size_t>(f.support)] +=
        state.sphere(body).mass * (change - state.frame.between(f.start, now) * normal.dot(g));
}

}  // namespace carom
