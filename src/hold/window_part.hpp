/// \file
/// One connected part of a heap: its next window.
#pragma once

#include "hold/near_pairs.hpp"
#include "hold/outcome.hpp"
#include "window/window_problem.hpp"

#include <functional>

namespace carom {

/// Length of a window in a heap that is hot [time].
double hot_length(const State& state);

/// The bodies of a list at this moment. \invariant all by number in the list
struct WindowBodies {
    std::shared_ptr<const NearPairs> list;
    std::vector<Flight> flights;     ///< as if they began now
    std::vector<WindowBody> bodies;  ///< places relative to one of them
    std::vector<double> moved;       ///< since the list was made [length]
    std::vector<char> still;         ///< fixed or at rest
    std::vector<WindowPlane> planes;
    double hot = 0;  ///< length of a hot window [time]

    /// Whether a pair may push in a hot window: then its bodies are connected.
    bool is_close(std::size_t pair) const;
};

/// Windows that end, or are interrupted, as the part goes on.
struct WindowHistory {
    std::vector<std::shared_ptr<const WindowPiece>> pieces;
    std::vector<char> is_interrupted;                                           ///< by piece
    std::vector<BodyId> woken;                                                  ///< ascending
    const std::vector<std::shared_ptr<const RestingPart>>* carriers = nullptr;  ///< that bore loads
    /// Whether bodies at rest bear further loads, those of the parts before included.
    std::function<bool(const std::vector<Load>&)> bear;
};

struct PartOutcome {
    enum class Next : std::uint8_t { taken, wakes, lists };
    Next next = Next::taken;
    BodyId woken = no_body;     ///< body at rest that is pushed
    double skin = 0;            ///< that a list must have [length]
    std::vector<Load> loads{};  ///< of the window on bodies at rest
};

/// Takes one window of the part, and enters it into `out`, unless bodies must be woken or listed anew before.
/// \param part numbers in the list of bodies that move, ascending
PartOutcome take_window_of_part(const State& state, const EpochTime& now, const WindowBodies& bodies,
                                const std::vector<int>& part, const WindowHistory& history, EventOutcome& out);

struct BeginAndEnd {
    Vec3 before, after;  ///< velocities [length/time]
};
/// Kinetic energy and height that a body loses over a displacement [energy].
double energy_taken(const State& state, BodyId body, const BeginAndEnd& velocities, const Vec3& displacement);

}  // namespace carom
