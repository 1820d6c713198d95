/// \file
/// Shows the observer the state at its sample times.
#pragma once

#include "stepping/bodies.hpp"
#include "stepping/timeline.hpp"

#include <carom/simulate.hpp>

#include <limits>
#include <vector>

namespace carom::stepping {

/// Inside a substep positions are interpolated linearly, as the method moved them; velocities are those of its end.
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
    /// Remember positions at the start of a substep that has samples.
    void keep(const Bodies& bodies) { before_ = bodies.position; }
    /// Samples inside the substep, its end included.
    void show(const Substep& substep, const Bodies& bodies);

private:
    void show_one(const Bodies& bodies, double fraction);

    const Observer& observer_;
    std::size_t next_ = 0;
    double next_time_ = std::numeric_limits<double>::infinity();
    std::vector<Vec3> before_;
    std::vector<BodyState> states_;
};

}  // namespace carom::stepping
