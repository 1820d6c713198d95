/// \file
/// When contacts come, and where bodies are then: what a schedule and a response ask of the motions. One interface for
/// both number types of a run.
#pragma once

#include "motion/relative.hpp"
#include "toi/enclosure.hpp"
#include "toi/sphere_plane.hpp"
#include "toi/sphere_sphere.hpp"

namespace carom {

/// When a contact comes; `never` if it does not.
struct ContactTime {
    EpochTime time = never;
    /// A moment certainly before the contact, by roundings at most, at which the gap is still >= 0. The contact itself
    /// is to be asked for: `exact_time`.
    bool rough = false;
    bool swept = false;  ///< of the ball that a series sweeps
};

/// In double. \tparam gravity false: nothing is accelerated, and nothing bounces in series
template <bool gravity>
struct PlainKinematics {
    static constexpr bool has_gravity = gravity;
    static constexpr bool is_certified = false;
    /// \param limit contacts after it need not be found
    static ContactTime pair_time(const State& state, BodyId a, BodyId b, const EpochTime& limit);
    static ContactTime plane_time(const State& state, const Moving& sphere, int plane);
};

/// In double-double where two bodies, or one and a plane, are in free flight; elsewhere as PlainKinematics<true>.
struct CertifiedKinematics {
    static constexpr bool has_gravity = true;
    static constexpr bool is_certified = true;
    static ContactTime pair_time(const State& state, BodyId a, BodyId b, const EpochTime& limit);
    static ContactTime plane_time(const State& state, const Moving& sphere, int plane);
    /// The moment at which a contact is carried out: a pure function of the flights, not before the rough one.
    static EpochTime exact_time(const State& state, BodyId a, Partner b);
};

/// Is the body's flight one that certified runs evaluate in double-double?
inline bool flies_certified(const State& state, BodyId body)
{
    return state.certified() && state.bodies.kind(body) == MotionKind::flying;
}
/// Likewise the gap of a body and its partner: it is that of a uniform motion, or of a parabola over a plane.
bool is_certified_gap(const State& state, BodyId a, Partner b);

/// The body's flight as if it began at `now`, in the run's number type. See `advanced`.
Flight flown(const State& state, BodyId body, const EpochTime& now);

/// How much later than the flights' common start a contact comes, in double-double: with bounds, to tell which of two
/// is first. \param b flight of the partner if it is a sphere, else null
Enclosure<DoubleDouble> wait(const State& state, const Flight& a, BodyId body, const Flight* b, Partner partner);

/// The sign of d gap/dt at the flights' common start, decided in the number type of the gap. \param b as above
int approach_sign(const State& state, const Flight& a, BodyId body, const Flight* b, Partner partner);
/// Depth of the overlap, 0 where the gap is >= 0 [length]. \param b as above
double penetration(const State& state, const Flight& a, BodyId body, const Flight* b, Partner partner);

template <bool gravity>
ContactTime PlainKinematics<gravity>::pair_time(const State& state, BodyId a, BodyId b, const EpochTime& limit)
{
    const auto persists = [&] { return state.bodies.contacts().between(a, Partner::sphere(b)); };
    if constexpr (!gravity) {
        const auto m = relative_motion<double, false>(state, state.flight(a), state.flight(b));
        const Root root = sphere_sphere_root(m.r, m.v, state.radius(a) + state.radius(b));
        if (root.kind == RootKind::none || persists()) return {};
        return {state.frame.after(m.from, root.t)};
    } else {
        const PairMotion m = pair_motion(state, moving(state, a), moving(state, b));
        // Quartics are dear: first what may spare them.
        const bool quartic = m.acceleration_a != m.acceleration_b;
        if (quartic && (persists() || meet_too_late(state, a, b, m, limit))) return {};
        const Root root = pair_root(state, m);
        if (root.kind == RootKind::none || (!quartic && persists())) return {};
        return {state.frame.after(m.from, root.t), false, m.swept};
    }
}

template <bool gravity>
ContactTime PlainKinematics<gravity>::plane_time(const State& state, const Moving& sphere, int p)
{
    if (recedes(state, sphere, p)) return {};
    const PlaneMotion m = plane_motion(state, sphere, p);
    const Root root = gravity ? plane_root(m.h, m.w, m.g) : uniform_plane_root(m.h, m.w);
    if (root.kind == RootKind::none) return {};
    return {state.frame.after(sphere.flight.start, root.t)};
}

}  // namespace carom
