/// \file
/// Stress: stiff and extreme scenes, in cases with a rule each, which a method passes or fails.
#pragma once

#include <carom/progress.hpp>
#include <carom/scene.hpp>

#include <string>
#include <vector>

namespace carom::stress {

/// Evidence that the runs of a case gave.
struct Evidence {
    double figure = 0;          ///< largest error, in the units of StressPart; may be infinite or not a number
    std::string worst;          ///< where the figure comes from; may be empty
    std::string stopped;        ///< why a run did not end well; empty: all did
    bool other_events = false;  ///< a run elsewhere was another one
    std::int64_t expected = 0;  ///< impacts, as far as checks say
    std::int64_t missed = 0, invented = 0;
    double penetration = 0;  ///< deepest, in radii of the smallest sphere
    double energy = 0;       ///< largest change relative to the kinetic energy, of runs that keep it
};

/// One method on one case.
struct Result {
    std::string method;
    Evidence evidence;
    double limit = 0;  ///< of the figure, for this method
    Symptom symptom = Symptom::none;
    std::string reason;  ///< a sentence for a method that fails, else empty
    double seconds = 0;  ///< CPU time [s]
    bool passed() const { return symptom == Symptom::none; }
};

/// A row of the table.
struct Case {
    StressPart words;   ///< what one of the scenes, or all, say
    std::string about;  ///< their descriptions
    std::vector<Scene> scenes;
    std::vector<Result> results;  ///< by method
    /// When it is passed, in words.
    std::string rule() const;
};

struct Report {
    std::vector<std::string> methods;
    std::vector<Case> cases;  ///< those finished, if interrupted
    bool interrupted = false;
    /// Whether `event`, if it was asked for, passes everything.
    bool event_passes() const;
};

/// The cases in the order of their names. \pre each scene has a StressPart \throws InputError where scenes of one case
/// disagree about its limits
std::vector<Case> cases_of(const std::vector<Scene>& scenes);

/// Symptom that the evidence shows of a method that is held to `limit`.
Symptom diagnose(const Evidence& evidence, double limit);

/// Every method on every case.
/// \param methods as `make_method`; empty: all \throws InputError for unknown ones
/// \param on_progress may be empty; false interrupts
Report run_cases(std::vector<Case> cases, const std::vector<std::string>& methods, const OnProgress& on_progress = {});

}  // namespace carom::stress
