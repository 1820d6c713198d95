/// \file
/// The system that every discrete method works on.
#pragma once

#include "core/patience.hpp"
#include "stepping/bodies.hpp"
#include "stepping/contact_order.hpp"
#include "stepping/detection.hpp"
#include "stepping/free_motion.hpp"
#include "stepping/impact_log.hpp"
#include "stepping/law_table.hpp"
#include "stepping/timeline.hpp"

#include <algorithm>

namespace carom::stepping {

struct System {
    System(const Scene& scene, const StepOptions& options, const Observer& observer, bool merge_impacts)
        : bodies(make_bodies(scene)),
          motion(scene.gravity, scene.drag, options.integrator),
          laws(scene),
          detector(scene),
          arranger(options.order, options.seed),
          impacts(scene, observer, merge_impacts)
    {
    }

    void record(const std::vector<Contact>& contacts)
    {
        max_penetration = std::max(max_penetration, deepest_penetration(contacts));
    }

    Bodies bodies;
    FreeMotion motion;
    LawTable laws;
    Detector detector;
    ContactArranger arranger;
    ImpactLog impacts;
    Patience patience;             ///< a substep without it is left unfinished: it is the last one
    double max_penetration = 0;    ///< [length]
    std::int64_t root_solves = 0;  ///< brackets bisected
};

}  // namespace carom::stepping
