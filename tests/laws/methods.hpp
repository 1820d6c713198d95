/// \file
/// The one list of methods over which the laws are run, and which law each of them claims.
///
/// Claimed by all, to rounding, so not listed: momentum (also what walls and gravity bring), a turned scene, a moving
/// frame, and never a gain of energy by impacts; and, bit for bit, other units by powers of two, with the step scaled,
/// too. A law that a method does not claim is checked to fail where that is the method's very nature (positive
/// controls).
#pragma once

#include <carom/method.hpp>

#include <cmath>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

namespace carom::test {

struct Claims {
    std::string label;
    Method method;
    bool energy =
        false;           ///< elastic impacts keep it, without forces. Not velocity: its phase C cancels, as if e were 0
    bool exact = false;  ///< between two looks nothing happens unseen: energy under gravity (a step of Euler's keeps
                         ///< another energy), time reversal (which overlap a step sees depends on its direction), no
                         ///< tunnelling, any place bit for bit (cells, not coordinates)
    bool no_overlap = false;   ///< no overlap is left at the end of a step. Others see it only when it is there
    bool any_order = false;    ///< labels never matter; else only where no sphere has two contacts in a step
    bool looks_ahead = false;  ///< nothing passes through a thin plate, though time may be lost there
    /// A contact lasts some steps, in which a spring holds kinetic energy back: it is less meanwhile, and what comes
    /// back depends on the phase of the step in which the overlap is first seen.
    bool is_soft = false;
};

/// Add a method here and nowhere else.
inline std::vector<Claims> methods()
{
    const StepOptions steps{.dt = 1.0 / 512};
    return {
        {"event, all pairs", EventDriven{BroadPhase::all_pairs}, true, true, true, true},
        {"event, cell grid", EventDriven{BroadPhase::cell_grid}, true, true, true, true},
        {"event, neighbour lists", EventDriven{BroadPhase::neighbour_lists}, true, true, true, true},
        {"pbd", PositionBased{steps}, true},
        {"velocity", VelocityBased{steps}},
        {"bisection", Bisection{steps}, true, false, true, true},
        {"toi", ImpactSubsteps{steps}, true, false, true, true},
        {"naive", Naive{steps}, true},
        {"moreau", Moreau{steps}, true},
        {"penalty", Penalty{steps}, false, false, false, true, false, true},
        {"speculative", Speculative{steps}, true, false, true, false, true},
        {"soft", Soft{steps}, true, false, false, false, true},
    };
}

/// The same method in another unit of time: its step times 2^exponent.
inline Method with_step_scaled(Method method, int exponent)
{
    std::visit(
        [&](auto& m) {
            if constexpr (std::is_base_of_v<StepOptions, std::decay_t<decltype(m)>>) m.dt = std::ldexp(m.dt, exponent);
            if constexpr (std::is_same_v<std::decay_t<decltype(m)>, Soft>) m.hertz = std::ldexp(m.hertz, -exponent);
        },
        method);
    return method;
}

}  // namespace carom::test
