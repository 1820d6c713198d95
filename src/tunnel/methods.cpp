#include "study/tolerances.hpp"
#include "tunnel/contestant.hpp"

#include <carom/simulate.hpp>

#include <algorithm>
#include <limits>
#include <map>

namespace carom::tunnel {

namespace {

/// Laws (docs/tunnel.md): who looks once a step and answers only what approaches sees one chord, who answers on both
/// sides of the middle two, who looks along the path all of it.
std::optional<double> law_of(const std::string& method)
{
    constexpr double all = std::numeric_limits<double>::infinity();
    static const std::map<std::string, double> laws{{"event", all}, {"toi", all},     {"speculative", all},
                                                    {"soft", all},  {"pbd", 1},       {"velocity", 1},
                                                    {"moreau", 1},  {"bisection", 2}, {"naive", 2}};
    const auto found = laws.find(method);
    return found == laws.end() ? std::nullopt : std::optional(found->second);
}

bool concerns(const Event& event, const Throw& t)
{
    return (event.a == t.body && event.b == t.partner) || (event.a == t.partner && event.b == t.body);
}

Flown fly(const Method& method, const Throw& t, double dt, std::int64_t steps)
{
    Flown flown;
    const auto body = static_cast<std::size_t>(t.body);
    Observer observer;
    observer.sample_times = {study::audited_steps * dt};
    observer.on_event = [&](const Event& event) {
        if (concerns(event, t) && !(flown.answered <= event.time && flown.answered)) flown.answered = event.time;
    };
    observer.on_sample = [&](std::size_t, double, std::span<const BodyState> states) {
        flown.position = states[body].position;
        flown.velocity = states[body].velocity;
    };
    const Outcome outcome = simulate(t.scene, method, {.until = static_cast<double>(steps) * dt}, observer);
    flown.end_position = outcome.final[body].position;
    flown.end_velocity = outcome.final[body].velocity;
    return flown;
}

}  // namespace

Contestant contestant(const std::string& method, const StepOptions& options)
{
    Contestant who;
    who.method = method;
    const Method proto = make_method(method, options);
    who.is_exact = step_options(proto) == nullptr;
    if (!who.is_exact) who.integrator = options.integrator;
    who.chords_seen = law_of(method);
    who.fly = [method, options](const Throw& t, double dt, std::int64_t steps) {
        StepOptions step = options;
        step.dt = dt;
        return fly(make_method(method, step), t, dt, steps);
    };
    return who;
}

}  // namespace carom::tunnel
