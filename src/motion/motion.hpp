/// \file
/// Motions: what a body does between two of its events. The only statement of modes.
#pragma once

#include "motion/series.hpp"

#include "flight/frame.hpp"

#include <memory>
#include <optional>
#include <variant>

namespace carom {

struct NumericPiece;
struct WindowPiece;

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
    bool landed = false;  ///< it came to rest in windows: impacts on its heap are for them
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
    std::shared_ptr<const WindowPiece> piece{};
    std::size_t index = 0;  ///< of the body in the piece
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

/// Whether the motion is no closed form and has an end of its own: a numeric step or a window of the guard.
constexpr bool is_piece(MotionKind kind)
{
    switch (kind) {
        case MotionKind::stepping:
        case MotionKind::windowed:
            return true;
        case MotionKind::fixed:
        case MotionKind::flying:
        case MotionKind::bouncing:
        case MotionKind::leaning:
        case MotionKind::held:
            break;
    }
    return false;
}
/// Whether the body is in a list of persistent contacts: of spheres, of several planes, or of a piece.
constexpr bool is_held_by_several(MotionKind kind)
{
    return kind == MotionKind::held || is_piece(kind);
}
/// Whether a contact holds the body, so that its normal motion is at an end.
constexpr bool is_held(MotionKind kind)
{
    return kind == MotionKind::leaning || is_held_by_several(kind);
}

/// The word that users see for a motion.
Mode mode_of(const Motion& motion);
/// The one plane that carries a body which leans on it or bounces on it in a series.
std::optional<int> carrier_of(const Motion& motion);
/// The time at which a motion ends by itself; `never` if it does not. \param start of the body's flight
EpochTime end_of(const Motion& motion, const Frame& frame, const EpochTime& start);

}  // namespace carom
