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

void Ledger::report(const State& state, const EpochTime& now, Event event)
{
    event.at = now;
    event.time = state.frame.seconds(now);
    const auto a = static_cast<std::size_t>(event.a);
    switch (event.kind) {
        case EventKind::impact:
            ++out.counts.impacts;
            if (state.is_plane(event.b))
                out.plane_impulses[static_cast<std::size_t>(state.plane_index(event.b))] +=
                    event.impulse.dot(event.normal);
            break;
        case EventKind::rest:
            ++out.counts.rests;
            out.rest_times[a] = event.time;
            break;
        case EventKind::release:
            ++out.counts.releases;
            out.rest_times[a].reset();
            break;
        case EventKind::guard:
            break;
    }
    hash_.add(event);
    if (observer_.on_event) observer_.on_event(event);
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
