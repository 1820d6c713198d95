/// \file
/// What a body does between two of its events: the only statement of modes.
#pragma once

#include "motion/series.hpp"

#include "flight/frame.hpp"

#include <memory>
#include <variant>

namespace carom {

struct NumericPiece;

/// The alternatives of Motion, in their order.
enum class MotionKind : std::uint8_t { fixed, flying, bouncing, leaning, held, stepping, windowed };

struct Fixed {
    static constexpr MotionKind kind = MotionKind::fixed;
};

struct Flying {
    static constexpr MotionKind kind = MotionKind::flying;
};

/// A Zeno series of bounces on one plane.
struct Bouncing {
    static constexpr MotionKind kind = MotionKind::bouncing;
    int plane = 0;
    Series series;
};

/// Persistent contact with one plane alone: the body slides along it, or rests.
struct Leaning {
    static constexpr MotionKind kind = MotionKind::leaning;
    int plane = 0;
    bool rests = false;
};

/// Persistent contact with spheres or several planes, in closed form.
struct Held {
    static constexpr MotionKind kind = MotionKind::held;
    Vec3 acceleration = Vec3::Zero();  ///< its own [length/time^2]
    bool rests = false;
};

/// One step of a numeric cluster. The flight that goes with it is the parabola that stands for the piece.
struct Stepping {
    static constexpr MotionKind kind = MotionKind::stepping;
    EpochTime end;
    Vec3 acceleration = Vec3::Zero();  ///< of the parabola [length/time^2]
    std::shared_ptr<const NumericPiece> piece;
    std::size_t index = 0;  ///< of the body in the cluster
};

/// A window of the guard: straight on, with a velocity of its own at the end.
struct Windowed {
    static constexpr MotionKind kind = MotionKind::windowed;
    EpochTime end;
    Vec3 end_velocity = Vec3::Zero();  ///< [length/time]
};

using Motion = std::variant<Fixed, Flying, Bouncing, Leaning, Held, Stepping, Windowed>;

template <class... Alternatives>
constexpr bool are_in_order(const std::variant<Alternatives...>*)
{
    std::size_t index = 0;
    return (... && (static_cast<std::size_t>(Alternatives::kind) == index++));
}
static_assert(are_in_order(static_cast<const Motion*>(nullptr)));

inline MotionKind kind_of(const Motion& motion)
{
    return static_cast<MotionKind>(motion.index());
}

/// The word that users see for it.
Mode mode_of(const Motion& motion);
/// Does a contact hold the body: is its normal motion at an end?
bool is_held(const Motion& motion);
/// When a motion ends by itself, on the frame's clock; `never` if it does not. \param start of the body's flight
EpochTime end_of(const Motion& motion, const Frame& frame, const EpochTime& start);

}  // namespace carom
