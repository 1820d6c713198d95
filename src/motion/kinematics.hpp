/// \file
/// Times of contacts, and bodies at these times: all that a schedule and a response ask of motions, by one interface
/// for both number types of a run.
#pragma once

#include "motion/low_return.hpp"
#include "motion/pair_query.hpp"
#include "toi/enclosure.hpp"
#include "toi/sphere_plane.hpp"
#include "toi/sphere_sphere.hpp"

namespace carom {

struct ContactTime {
    bool comes = false;
    EpochTime time = never;  ///< `never` also where it is certainly after the limit of the question
    /// Whether `time` is not that of the contact but a moment certainly before it, by roundings at most, at which the
    /// gap is still >= 0. The contact itself is to be asked for: `exact_time`.
    bool rough = false;
    bool swept = false;  ///< of the ball that a series sweeps
};

/// Times in double. \tparam gravity false: nothing is accelerated, and nothing bounces in series
template <bool gravity>
struct PlainKinematics {
    static constexpr bool has_gravity = gravity;
    static constexpr bool has_drag = false;
    static constexpr bool is_certified = false;
    /// \param limit contacts after it need not be found
    static ContactTime pair_time(const State& state, BodyId a, BodyId b, const EpochTime& limit);
    static ContactTime plane_time(const State& state, const Moving& sphere, int plane, const EpochTime& limit);
};

/// Times in double of motions that linear drag damps. \pre state.drag > 0
struct DampedKinematics {
    static constexpr bool has_gravity = true;
    static constexpr bool has_drag = true;
    static constexpr bool is_certified = false;
    static ContactTime pair_time(const State& state, BodyId a, BodyId b, const EpochTime& limit);
    static ContactTime plane_time(const State& state, const Moving& sphere, int plane, const EpochTime& limit);
};

/// Times in double-double where two bodies, or one and a plane, are in free flight; elsewhere as PlainKinematics<true>.
struct CertifiedKinematics {
    static constexpr bool has_gravity = true;
    static constexpr bool has_drag = false;
    static constexpr bool is_certified = true;
    static ContactTime pair_time(const State& state, BodyId a, BodyId b, const EpochTime& limit);
    static ContactTime plane_time(const State& state, const Moving& sphere, int plane, const EpochTime& limit);
    /// The moment at which a contact is carried out: a pure function of the flights, not before the rough one.
    static EpochTime exact_time(const State& state, BodyId a, Partner b);
};

/// Whether the run is certified and evaluates the body's flight in double-double.
inline bool flies_certified(const State& state, BodyId body)
{
    return state.certified() && state.bodies.kind(body) == MotionKind::flying;
}
/// The same for the gap of a body and its partner: that of a uniform motion, or of a parabola over a plane.
bool is_certified_gap(const State& state, BodyId a, Partner b);

/// The body's flight as if it began at `now`, in the run's number type. See `advanced`.
Flight flown(const State& state, BodyId body, const EpochTime& now);

/// The time from the flights' common start to a contact, in double-double, with bounds that tell which of two is first.
Enclosure<DoubleDouble> wait(const State& state, const Flight& a, BodyId id_a, const Flight& b, BodyId id_b);
Enclosure<DoubleDouble> wait(const State& state, const Flight& a, BodyId body, int plane);

/// Two spheres at one moment, evaluated in the number type of their gap. The flights outlive this.
class SphereEncounter {
public:
    SphereEncounter(const State& state, const Flight& a, BodyId id_a, const Flight& b, BodyId id_b);

    const Vec3& normal() const { return normal_; }                ///< from b to a, unit to rounding
    Vec3 velocity() const { return a_.velocity - b_.velocity; }   ///< of a relative to b
    double gap() const { return distance_ - contact_distance_; }  ///< in double [length]
    /// The sign of d gap/dt.
    int approach_sign() const;
    /// Depth of the overlap, 0 where the gap is >= 0 [length].
    double penetration() const;

private:
    PairQuery exactly() const { return {state_, a_, id_a_, b_, id_b_}; }

    const State& state_;
    const Flight &a_, &b_;
    const BodyId id_a_, id_b_;
    const bool certified_;
    const Vec3 separation_;
    const double distance_, contact_distance_;
    const Vec3 normal_;
};

/// The same of a sphere and a plane: the sign of d gap/dt, and the depth of the overlap [length].
int approach_sign(const State& state, const Flight& flight, BodyId body, int plane);
double penetration(const State& state, const Flight& flight, BodyId body, int plane);

/// from + t, or `never` if that is certainly after the limit: most contacts are, and their times need no splitting.
inline EpochTime time_up_to(const Frame& frame, const EpochTime& from, double t, const EpochTime& limit)
{
    const double left = frame.between(from, limit);
    return t > left + wait_rounding * (std::abs(left) + frame.epoch_length) ? never : frame.after(from, t);
}

template <bool gravity>
ContactTime PlainKinematics<gravity>::pair_time(const State& state, BodyId a, BodyId b, const EpochTime& limit)
{
    const auto persists = [&] { return state.bodies.contacts().between(a, Partner::sphere(b)); };
    if constexpr (!gravity) {
        const auto m = relative_motion<double, false>(state, state.flight(a), state.flight(b));
        const Root root = sphere_sphere_root(m.r, m.v, state.radius(a) + state.radius(b));
        if (root.kind == RootKind::none || persists()) return {};
        return {true, time_up_to(state.frame, m.from, root.t, limit)};
    } else {
        const PairMotion m = pair_motion(state, moving(state, a), moving(state, b));
        // Quartics are dear: first what may spare them.
        const bool quartic = m.acceleration_a != m.acceleration_b;
        if (quartic && (persists() || meet_too_late(state, a, b, m, limit))) return {};
        const std::optional<double> low = quartic ? low_return(state, a, b, m) : std::nullopt;
        const Root root = low ? Root{RootKind::impact, *low, 0} : pair_root(state, m);
        if (root.kind == RootKind::none || (!quartic && persists())) return {};
        return {true, time_up_to(state.frame, m.from, root.t, limit), false, m.swept};
    }
}

template <bool gravity>
ContactTime PlainKinematics<gravity>::plane_time(const State& state, const Moving& sphere, int p,
                                                 const EpochTime& limit)
{
    if (recedes(state, sphere, p)) return {};
    const PlaneMotion m = plane_motion(state, sphere, p);
    const Root root = gravity ? plane_root(m.h, m.w, m.g) : uniform_plane_root(m.h, m.w);
    if (root.kind == RootKind::none) return {};
    return {true, time_up_to(state.frame, sphere.flight.start, root.t, limit)};
}

}  // namespace carom
