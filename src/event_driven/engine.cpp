/// \file
/// The choice of the kernel that runs a scene. A kernel is the loop of run.hpp over a schedule that has just the
/// features its name promises.
#include "event_driven/engine.hpp"

#include "event_driven/range.hpp"
#include "event_driven/run.hpp"
#include "predict/lone_schedule.hpp"
#include "predict/schedule.hpp"

#include <carom/error.hpp>

#include <cmath>

namespace carom {

namespace {

template <class Kinematics>
Outcome run_with(const Scene& scene, const Kernel& kernel, const EventDriven& method, const RunOptions& options,
                 const Observer& observer, double until)
{
    BroadPhase wanted = method.broad_phase;
    if (wanted == BroadPhase::automatic) wanted = event_broad_phase(scene);
    if (scene.spheres.size() < 2 || wanted == BroadPhase::all_pairs)
        return Run<Schedule<Kinematics, AllPairs>>(scene, kernel, method, options, observer).go();
    if (wanted == BroadPhase::neighbour_lists && !goes_far(scene, until))
        return Run<Schedule<Kinematics, NeighbourLists>>(scene, kernel, method, options, observer).go();
    return Run<Schedule<Kinematics, CellGrid>>(scene, kernel, method, options, observer).go();
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
    if (method.certified && needs(scene).drag)
        throw InputError({"--certified has no drag yet (leave --certified out, or set /drag to 0)"});
    // Certified runs have one kernel: it must cover everything else.
    const Kernel& kernel =
        choose_kernel(scene, method.certified ? std::string_view("general") : std::string_view(method.kernel));
    const double until = std::isnan(options.until) ? scene.end_time : options.until;
    if (const std::string why = out_of_range(scene, until); !why.empty()) return not_begun(scene, kernel, why);
    if (method.certified) return run_with<CertifiedKinematics>(scene, kernel, method, options, observer, until);
    if (!kernel.features.pairs) return Run<LoneSchedule>(scene, kernel, method, options, observer).go();
    if (!kernel.features.gravity)
        return run_with<PlainKinematics<false>>(scene, kernel, method, options, observer, until);
    if (needs(scene).drag) return run_with<DampedKinematics>(scene, kernel, method, options, observer, until);
    return run_with<PlainKinematics<true>>(scene, kernel, method, options, observer, until);
}

}  // namespace carom
