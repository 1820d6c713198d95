#include "stepping/sampler.hpp"

namespace carom::stepping {

void Sampler::show_one(const Bodies& bodies, double fraction)
{
    show_states(bodies, states_);
    if (fraction < 1)
        for (std::size_t i = 0; i < bodies.size(); ++i)
            states_[i].position = before_[i] + fraction * (bodies.position[i] - before_[i]) - bodies.origin;
    observer_.on_sample(next_, next_time_, states_);
    ++next_;
    next_time_ =
        next_ < observer_.sample_times.size() ? observer_.sample_times[next_] : std::numeric_limits<double>::infinity();
}

void Sampler::show_initial(const Bodies& bodies)
{
    while (due(0)) show_one(bodies, 1);
}

void Sampler::show(const Substep& substep, const Bodies& bodies)
{
    while (due(substep.end)) {
        const double fraction = (next_time_ - substep.begin) / (substep.end - substep.begin);
        show_one(bodies, next_time_ < substep.end ? fraction : 1);
    }
}

}  // namespace carom::stepping
