/// \file
/// Steps, samples, counts and limits: the part of a run that all discrete methods share.
#pragma once

#include "stepping/sampler.hpp"
#include "stepping/system.hpp"

#include <carom/simulate.hpp>

#include <chrono>
#include <cmath>
#include <span>
#include <string>

namespace carom::stepping {

/// A number in a message.
std::string text(double value);
/// Fault of the options, empty if there is none.
/// \param more_orders those that the method knows beside index, reverse, random and deepest
std::string option_problem(const StepOptions& options, double until, std::span<const ContactOrder> more_orders);
/// Fault of the substep where drag acts, empty if there is none: semi-implicit Euler must take less than 2 / drag.
std::string damping_problem(const StepOptions& options, double drag);
std::string divergence_message(const Scene& scene, std::size_t sphere, double time);
std::string limit_message(const char* what, double time, double until);
/// The outcome from the state as it is.
Outcome collect(const System& system, Outcome outcome);
/// The outcome of a run that does not begin, and why.
Outcome refuse(const System& system, std::string problem);

/// Decides now and then whether a run goes on. Once it does not, it stays so.
class Watch {
public:
    Watch(const RunOptions& options, const Observer& observer, std::size_t spheres);
    /// reached_end to go on, else why to stop.
    Status look(std::int64_t substeps, double time)
    {
        return answer_ != Status::reached_end || substeps % period_ != 0 ? answer_ : ask(time);
    }
    /// The same at once.
    Status ask(double time);

private:
    const RunOptions& options_;
    const Observer& observer_;
    std::int64_t period_;  ///< in substeps
    Status answer_ = Status::reached_end;
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// \tparam Stepper has advance(System&, const Substep&) and finish(System&)
template <class Method, class Stepper>
Outcome drive(const Scene& scene, const Method& options, const RunOptions& run, const Observer& observer,
              System& system, Stepper& stepper)
{
    const double until = std::isnan(run.until) ? scene.end_time : run.until;
    if (std::string problem = option_problem(options, until, Method::more_orders); !problem.empty())
        return refuse(system, std::move(problem));
    if (std::string problem = damping_problem(options, scene.drag); !problem.empty())
        return refuse(system, std::move(problem));
    Outcome outcome;
    const auto stop = [&](Status status, std::string message) {
        stepper.finish(system);
        outcome.status = status;
        outcome.message = std::move(message);
        return collect(system, outcome);
    };
    const Timeline timeline(until, options.dt, options.substeps);
    Sampler sampler(observer);
    Watch watch(run, observer, system.bodies.size());
    system.patience = Patience([&](const Progress&) { return watch.ask(outcome.time) == Status::reached_end; });
    sampler.show_initial(system.bodies);
    for (std::int64_t step = 0; step < timeline.steps(); ++step) {
        for (int k = 0; k < options.substeps; ++k) {
            if (outcome.counts.steps >= run.max_events)
                return stop(Status::event_limit, limit_message("the limit of substeps", outcome.time, until));
            const Substep substep = timeline.substep(step, k);
            const bool sampled = sampler.due(substep.end);
            system.motion.track().want(sampled);
            stepper.advance(system, substep);
            system.impacts.close();
            ++outcome.counts.steps;
            outcome.time = substep.end;
            const std::size_t diverged = first_diverged(system.bodies);
            if (diverged < system.bodies.size())
                return stop(Status::unresolved, divergence_message(scene, diverged, substep.end));
            if (sampled) sampler.show(substep, system.bodies, system.motion.track());
            const Status status = watch.look(outcome.counts.steps, substep.end);
            if (status == Status::interrupted)
                return stop(status, limit_message("a request to stop", substep.end, until));
            if (status == Status::time_limit)
                return stop(status, limit_message("the limit of wall-clock time", substep.end, until));
        }
    }
    stepper.finish(system);
    return collect(system, outcome);
}

}  // namespace carom::stepping
