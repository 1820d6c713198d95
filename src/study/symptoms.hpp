/// \file
/// Symptoms of a run of a stress scene: evidence, the symptom that it is of, and a sentence.
#pragma once

#include <carom/checks.hpp>
#include <carom/scene.hpp>

#include <set>
#include <string>

namespace carom::stress {

/// Figures of one run of a scene, and of those that its checks ask for besides.
struct Evidence {
    double figure = 0;          ///< largest error, in the units of StressPart; may be infinite or not a number
    std::string worst;          ///< check that the figure comes from; empty: none is off
    std::string stopped;        ///< why the run did not end well; empty: it did
    bool other_events = false;  ///< a run elsewhere was another one
    std::int64_t expected = 0;  ///< impacts, as far as checks say
    std::int64_t missed = 0, invented = 0;
    double penetration = 0;  ///< deepest, in radii of the smallest sphere
    double energy = 0;       ///< largest change relative to the kinetic energy, of runs that keep it
};

/// \param left_out checks that who ran it cannot answer, and is not asked
/// \pre the scene has a StressPart, and the report is one of its checks
Evidence evidence_of(const Scene& scene, const CheckReport& report, const std::set<CheckType>& left_out);

/// The symptom that the evidence has, of a method that is held to `limit`.
Symptom diagnose(const Evidence& evidence, double limit);

/// Numbers of a symptom, then its cause where one is known. \param words of the case \pre symptom is not none
std::string explain(const StressPart& words, const std::string& method, const Evidence& evidence, Symptom symptom);

}  // namespace carom::stress
