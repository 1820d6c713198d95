#include "stepping/sampler.hpp"

namespace carom::stepping {

void Sampler::show_one()
{
    observer_.on_sample(next_, next_time_, states_);
    ++next_;
    next_time_ =
        next_ < observer_.sample_times.size() ? observer_.sample_times[next_] : std::numeric_limits<double>::infinity();
}

void Sampler::show_initial(const Bodies& bodies)
{
    while (due(0)) {
        show_states(bodies, states_);
        show_one();
    }
}

void Sampler::show(const Substep& substep, const Bodies& bodies, const SubstepTrack& track)
{
    while (due(substep.end)) {
        show_states(bodies, states_);
        if (next_time_ < substep.end) track.show(next_time_ - substep.begin, bodies, states_);
        show_one();
    }
}

}  // namespace carom::stepping
