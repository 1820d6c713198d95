/// \file
/// The one list of methods over which the laws are run, and which law each of them claims.
#pragma once

#include <carom/method.hpp>

#include <string>
#include <vector>

namespace carom::test {

struct Claims {
    std::string label;
    Method method;
    bool exact = false;        ///< energy, time reversal, Galilean shift, no penetration, contacts in any order
    bool power_of_two = true;  ///< the same bits after scaling by powers of two (a step would have to be scaled, too)
};

/// Add a method here and nowhere else.
inline std::vector<Claims> methods()
{
    const StepOptions steps{.dt = 1.0 / 512};
    return {
        {"event, all pairs", EventDriven{BroadPhase::all_pairs}, true, true},
        {"event, cell grid", EventDriven{BroadPhase::cell_grid}, true, true},
        {"pbd", PositionBased{steps}, false, false},
        {"velocity", VelocityBased{steps}, false, false},
        {"bisection", Bisection{steps}, false, false},
    };
}

}  // namespace carom::test
