/// \file
/// One connected part of a heap: its next window.
#pragma once

#include "heap/window_bodies.hpp"
#include "hold/outcome.hpp"

#include <functional>

namespace carom {

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

}  // namespace carom
