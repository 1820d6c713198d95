#include <carom/simulate.hpp>

#include "event_driven/engine.hpp"

namespace carom
{

Outcome simulate(const Scene& scene, const Method& method, const RunOptions& options, const Observer& observer)
{
    if (const auto* event = std::get_if<EventDriven>(&method))
        return run_event_driven(scene, *event, options, observer);
    return {};
}

}  // namespace carom
