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
    bool elastic_energy = false;  ///< keeps the energy where all restitutions are 1
    bool reversible = false;      ///< runs backwards when the velocities are reversed
    bool power_of_two = false;    ///< the same bits after scaling masses, lengths or times by powers of two
    bool no_penetration = false;  ///< gaps stay closed to rounding
    bool galilean = false;        ///< looks the same from a moving frame
};

/// Every method keeps the momentum of spheres without walls, and does not care how bodies are called or axes are named.
/// Add a method here and nowhere else.
inline std::vector<Claims> methods()
{
    return {
        {"event, all pairs", EventDriven{BroadPhase::all_pairs}, true, true, true, true, true},
        {"event, cell grid", EventDriven{BroadPhase::cell_grid}, true, true, true, true, true},
    };
}

}  // namespace carom::test
