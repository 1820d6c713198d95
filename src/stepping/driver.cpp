#include "stepping/driver.hpp"

#include "stepping/tolerances.hpp"

#include <algorithm>
#include <cstdio>
#include <utility>

namespace carom::stepping {

std::string text(double value)
{
    char buffer[32];
    std::snprintf(buffer, sizeof buffer, "%.9g", value);
    return buffer;
}

namespace {

/// Methods that have an order which not every method has.
std::string owners(ContactOrder order)
{
    return order == ContactOrder::jacobi ? "pbd has" : "velocity and moreau have";
}

}  // namespace

std::string option_problem(const StepOptions& options, double until, std::span<const ContactOrder> more_orders)
{
    if (!(options.dt > 0) || !std::isfinite(options.dt)) return "dt must be > 0 and finite, is " + text(options.dt);
    if (options.substeps < 1) return "substeps must be at least 1, is " + std::to_string(options.substeps);
    if (options.passes < 1) return "passes must be at least 1, is " + std::to_string(options.passes);
    if (options.order > ContactOrder::deepest &&
        std::find(more_orders.begin(), more_orders.end(), options.order) == more_orders.end())
        return "this method has no order " + std::string(name(options.order)) + ", " + owners(options.order) +
               " (take index, reverse, random or deepest)";
    if (!(until >= 0) || !std::isfinite(until)) return "until must be >= 0 and finite, is " + text(until);
    return "";
}

std::string damping_problem(const StepOptions& options, double drag)
{
    const double h = options.dt / options.substeps;
    if (options.integrator != Integrator::euler || h * drag < unstable_damping) return "";
    const double longest = unstable_damping / drag;
    return "a substep of " + text(h) + " with the integrator euler is unstable at a drag of " + text(drag) +
           ": it must be shorter than " + text(longest) + " (take dt < " + text(longest * options.substeps) +
           ", more substeps, or the integrator parabola)";
}

std::string divergence_message(const Scene& scene, std::size_t sphere, double time)
{
    return "diverged: the position of sphere \"" + scene.spheres[sphere].id + "\" is not finite at t = " + text(time);
}

std::string limit_message(const char* what, double time, double until)
{
    return "stopped by " + std::string(what) + " at t = " + text(time) + " of " + text(until);
}

Outcome collect(const System& system, Outcome outcome)
{
    outcome.counts.impacts = system.impacts.count();
    outcome.counts.pair_tests = system.detector.tests;
    outcome.counts.root_solves = system.root_solves;
    outcome.plane_impulses = system.impacts.plane_impulses();
    outcome.max_penetration = system.max_penetration;
    outcome.rest_times.resize(system.bodies.size());
    show_states(system.bodies, outcome.final);
    return outcome;
}

Outcome refuse(const System& system, std::string problem)
{
    Outcome outcome;
    outcome.status = Status::unresolved;
    outcome.message = std::move(problem);
    return collect(system, std::move(outcome));
}

Watch::Watch(const RunOptions& options, const Observer& observer, std::size_t spheres)
    : options_(options), observer_(observer)
{
    // Often enough for large scenes, whose substeps take milliseconds; seldom enough for small ones to cost nothing.
    period_ = std::clamp<std::int64_t>(spheres_between_looks / static_cast<std::int64_t>(spheres + 1), 1,
                                       longest_watch_period);
}

Status Watch::ask(double time)
{
    if (answer_ != Status::reached_end) return answer_;
    if (observer_.on_progress && !observer_.on_progress(time)) return answer_ = Status::interrupted;
    if (std::isfinite(options_.max_seconds)) {
        const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start_;
        if (elapsed.count() > options_.max_seconds) answer_ = Status::time_limit;
    }
    return answer_;
}

}  // namespace carom::stepping
