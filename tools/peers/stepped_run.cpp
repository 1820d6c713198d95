#include "stepped_run.hpp"

#include <cmath>
#include <ctime>

namespace carom::peers {

namespace {

/// Difference of a step's change of velocity from that by gravity [of the latter, and of the speed] that is rounding.
constexpr double free_step = 1e-12;
/// Part of a step [1] by which a time may be behind the end of a step and still mean that end: roundings of k dt.
constexpr double on_step = 1e-9;

/// The state a part of a step after its begin. \param part in [0, 1]
BodyState within_step(const BodyState& before, const BodyState& after, const Vec3& fall, double part)
{
    BodyState state = after;
    state.position = before.position + part * (after.position - before.position);
    const Vec3 gained = after.velocity - before.velocity;
    if ((gained - fall).norm() <= free_step * (fall.norm() + before.velocity.norm()))
        state.velocity = before.velocity + part * gained;
    return state;
}

}  // namespace

std::vector<BodyState> states_of(const Engine& engine, std::size_t spheres)
{
    std::vector<BodyState> states(spheres);
    for (std::size_t i = 0; i < spheres; ++i) {
        states[i].position = engine.place(i);
        states[i].velocity = engine.velocity(i);
    }
    return states;
}

SteppedRun stepped_run(const Scene& scene, const Settings& settings, Engine& engine, const std::vector<double>& times)
{
    SteppedRun run;
    const std::size_t spheres = scene.spheres.size();
    const Vec3 fall = settings.dt * scene.gravity;
    const auto step_to = [&](long long step) {
        const std::clock_t start = std::clock();
        for (; run.steps < step; ++run.steps) engine.step();
        run.cpu_seconds += static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    };
    std::vector<BodyState> before = states_of(engine, spheres), after = before;
    for (const double time : times) {
        // The step within which the time falls, or with whose end it is one.
        const auto wanted = static_cast<long long>(std::ceil(time / settings.dt - on_step));
        if (run.steps < wanted) {
            step_to(wanted - 1);
            before = states_of(engine, spheres);
            step_to(wanted);
            after = states_of(engine, spheres);
        }
        const double part = run.steps == 0 ? 1 : time / settings.dt - static_cast<double>(run.steps - 1);
        std::vector<BodyState>& sample = run.samples.emplace_back();
        for (std::size_t i = 0; i < spheres; ++i) sample.push_back(within_step(before[i], after[i], fall, part));
    }
    return run;
}

}  // namespace carom::peers
