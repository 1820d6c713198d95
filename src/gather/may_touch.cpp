#include "gather/may_touch.hpp"

#include "flight/damping.hpp"

namespace carom {

bool damped_may_touch(const State& state, BodyId body, const Flight& now, BodyId other, double margin)
{
    const Flight& f = state.flight(other);
    const Damping<double> d = damping(state.drag, state.frame.between(f.start, now.start));
    const Vec3 r = separation(state.frame, now.place, f.place) - displacement(f.velocity, state.acceleration(f), d);
    return is_near(state, body, other, r, margin);
}

}  // namespace carom
