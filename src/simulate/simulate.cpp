#include <carom/simulate.hpp>

#include "event_driven/engine.hpp"
#include "stepping/stepping.hpp"

namespace carom {

namespace {

Outcome run(const Scene& scene, const EventDriven& method, const RunOptions& options, const Observer& observer)
{
    return run_event_driven(scene, method, options, observer);
}

template <class Stepper>
Outcome run(const Scene& scene, const Stepper& method, const RunOptions& options, const Observer& observer)
{
    return run_stepping(scene, method, options, observer);
}

}  // namespace

Outcome simulate(const Scene& scene, const Method& method, const RunOptions& options, const Observer& observer)
{
    return std::visit([&](const auto& m) { return run(scene, m, options, observer); }, method);
}

}  // namespace carom
