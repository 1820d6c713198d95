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
    for (AccelerationId id = 0; id < state.accelerations.count(); ++id)
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
    const auto a = static_cast<std::size_t>(event.a);
    if (event.kind == EventKind::impact) {
        ++out.counts.impacts;
        if (state.is_plane(event.b))
            out.plane_impulses[static_cast<std::size_t>(state.plane_index(event.b))] += event.impulse.dot(event.normal);
    } else if (event.kind == EventKind::rest) {
        ++out.counts.rests;
        out.rest_times[a] = state.frame.seconds(now);
    } else if (event.kind == EventKind::release) {
        ++out.counts.releases;
        out.rest_times[a].reset();
    }
    hash_.add(event);
    if (observer_.on_event) show(event);
}

void Ledger::account_for_support(const State& state, BodyId body, const EpochTime& now)
{
    const Flight& f = state.flight(body);
    if (f.support < 0) return;
    const Vec3 normal = facing_normal(state, f.support, f.place);
    const Flight after = advanced(state, body, now);
    const Vec3& g = state.accelerations[state.accelerations.free()];
    const double change = normal.dot(after.velocity) - normal.dot(f.velocity);
    out.plane_impulses[static_cast<std::size_t>(f.support)] +=
        state.sphere(body).mass * (change - state.frame.between(f.start, now) * normal.dot(g));
}

}  // namespace carom
