/// \file
/// Shows the observer the state at its sample times.
#pragma once

#include "stepping/bodies.hpp"
#include "stepping/substep_track.hpp"
#include "stepping/timeline.hpp"

#include <carom/simulate.hpp>

#include <limits>
#include <vector>

namespace carom::stepping {

/// Inside a substep spheres are on the path by which the method moved them, before it corrected anything at the end;
/// velocities follow gravity from those at its begin to those at its end. A sample at an end shows the state there.
class Sampler {
public:
    explicit Sampler(const Observer& observer) : observer_(observer)
    {
        if (observer.on_sample && !observer.sample_times.empty()) next_time_ = observer.sample_times.front();
    }

    /// Is there a sample up to this time?
    bool due(double time) const { return next_time_ <= time; }
    /// Samples at the start of the run.
    void show_initial(const Bodies& bodies);
    /// Samples inside the substep, its end included. \param track of that substep
    void show(const Substep& substep, const Bodies& bodies, const SubstepTrack& track);

private:
    /// The states that were put into `states_`.
    void show_one();

    const Observer& observer_;
    std::size_t next_ = 0;
    double next_time_ = std::numeric_limits<double>::infinity();
    std::vector<BodyState> states_;
};

}  // namespace carom::stepping
