/// \file
/// Motion without gravity: what motion.hpp does, with everything left out that is zero. The same bits, in fewer
/// instructions.
#pragma once

#include "event_driven/state.hpp"
#include "toi/sphere_sphere.hpp"

namespace carom {

struct UniformPairMotion {
    EpochTime from;
    Vec3 r, v;  ///< a relative to b [length], [length/time]
    double contact_distance;
};

/// Of two spheres at the later of their flights' starts: only the older flight has moved since it began.
inline UniformPairMotion uniform_pair_motion(const State& state, BodyId a, BodyId b)
{
    const Flight &fa = state.flight(a), &fb = state.flight(b);
    UniformPairMotion m{fa.start, separation(state.frame, fa.place, fb.place), fa.velocity - fb.velocity,
                        state.radius(a) + state.radius(b)};
    if (fa.start < fb.start) {
        m.from = fb.start;
        m.r += state.frame.between(fa.start, fb.start) * fa.velocity;
    } else if (fb.start < fa.start) {
        m.r -= state.frame.between(fb.start, fa.start) * fb.velocity;
    }
    return m;
}

inline Flight uniformly_advanced(const State& state, BodyId body, const EpochTime& now)
{
    Flight f = state.flight(body);
    f.place = moved(state.frame, f.place, state.frame.between(f.start, now) * f.velocity);
    f.start = now;
    return f;
}

}  // namespace carom
