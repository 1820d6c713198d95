/// \file
/// Which kernel runs a scene. A kernel is the loop of run.hpp over a schedule that has just the features its name
/// promises.
#include "event_driven/engine.hpp"

#include "event_driven/lone_schedule.hpp"
#include "event_driven/range.hpp"
#include "event_driven/run.hpp"
#include "event_driven/schedule.hpp"

#include <cmath>

namespace carom {

namespace {

template <class Schedule>
Outcome run_with(const Scene& scene, const Kernel& kernel, const EventDriven& method, const RunOptions& options,
                 const Observer& observer)
{
    return Run<Schedule>(scene, kernel, method, options, observer).go();
}

Outcome not_begun(const Scene& scene, const Kernel& kernel, const std::string& why)
{
    Outcome out;
    out.status = Status::unresolved;
    out.message = why + ", at t = 0";
    out.kernel = kernel.name;
    for (const Sphere& s : scene.spheres)
        out.final.push_back({s.position, s.velocity, s.fixed ? Mode::fixed : Mode::flying});
    out.rest_times.resize(scene.spheres.size());
    out.plane_impulses.assign(scene.planes.size(), 0);
    return out;
}

}  // namespace

Outcome run_event_driven(const Scene& scene, const EventDriven& method, const RunOptions& options,
                         const Observer& observer)
{
    // Certified runs have one kernel: it must cover everything.
    const Kernel& kernel = method.certified ? kernels().back() : choose_kernel(scene, method.kernel);
    const double until = std::isnan(options.until) ? scene.end_time : options.until;
    if (const std::string why = out_of_range(scene, until); !why.empty()) return not_begun(scene, kernel, why);
    if (method.certified)
        return run_with<Schedule<Features{.gravity = true, .pairs = true}, true>>(scene, kernel, method, options,
                                                                                  observer);
    if (!kernel.features.pairs) return run_with<LoneSchedule>(scene, kernel, method, options, observer);
    if (!kernel.features.gravity)
        return run_with<Schedule<Features{.gravity = false, .pairs = true}>>(scene, kernel, method, options, observer);
    return run_with<Schedule<Features{.gravity = true, .pairs = true}>>(scene, kernel, method, options, observer);
}

}  // namespace carom
