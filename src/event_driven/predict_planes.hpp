/// \file
/// The earliest event of a body that no other sphere has a part in: a plane, or the end of its series.
#pragma once

#include "event_driven/motion.hpp"
#include "queue/key.hpp"
#include "toi/sphere_plane.hpp"

#include <algorithm>

namespace carom {

template <bool gravity>
Key first_of_planes(const State& state, const Moving& sphere, Counts& counts)
{
    const Flight& flight = sphere.flight;
    Key best;
    Scheduled kind = Scheduled::plane_impact;
    if constexpr (gravity) {
        if (flight.mode == Mode::series) {
            kind = Scheduled::intrusion;
            best = {state.frame.after(flight.start, sphere.series->duration()), Scheduled::series_end, sphere.body,
                    state.scene.plane_body(static_cast<std::size_t>(flight.support))};
        }
    }
    if (flight.mode == Mode::numeric)
        best = {state.pieces.at(sphere.body).end, Scheduled::piece_end, sphere.body, sphere.body};
    const auto planes = static_cast<int>(state.scene.planes.size());
    counts.pair_tests += planes;
    for (int p = 0; p < planes; ++p) {
        if (p == flight.support || recedes(state, sphere, p)) continue;
        if (flight.support == several_supports &&
            state.contacts.between(sphere.body, state.scene.plane_body(static_cast<std::size_t>(p))))
            continue;
        const PlaneMotion m = plane_motion(state, sphere, p);
        const Root root = gravity ? plane_root(m.h, m.w, m.g) : uniform_plane_root(m.h, m.w);
        if (root.kind == RootKind::none) continue;
        ++counts.root_solves;
        best = std::min(best, Key{state.frame.after(flight.start, root.t), kind, sphere.body,
                                  state.scene.plane_body(static_cast<std::size_t>(p))});
    }
    return best;
}

}  // namespace carom
