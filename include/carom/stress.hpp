/// \file
/// The part of a scene in `carom stress`, which puts every method to stiff and extreme cases.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace carom {

/// Symptoms of failure in a case of `carom stress`, in the order in which they are looked for.
enum class Symptom : std::uint8_t {
    none,       ///< the rule is kept
    stopped,    ///< the run did not reach its end, or ended in numbers that are not finite
    other_run,  ///< other events than those of the same scene elsewhere, or none to be turned round
    sank,       ///< half a radius or more inside a body at the end of a step
    energy,     ///< energy that should be kept was not, by a hundredth or more
    missed,     ///< fewer impacts than there are
    invented,   ///< more
    late        ///< none of these: everything happened, at the wrong time or place
};
inline constexpr std::array<std::string_view, 8> symptom_names{"none",   "stopped", "other_run", "sank",
                                                               "energy", "missed",  "invented",  "late"};

/// A variation of a stress scene: the same file with other values.
struct StressMember {
    std::string name;              ///< for people: "e = 0.9"
    std::vector<std::string> set;  ///< "/pointer=value", as ReadOptions::set
};

/// A scene's part in `carom stress`. Scenes that name one case make up one row of its table; a method passes if the
/// figure, the largest error of their checks, is within a limit. Errors count in units of tolerance / exact.
struct StressPart {
    std::string case_name;
    double dt = 0;                          ///< > 0, of discrete methods [time]
    double exact = 0;                       ///< >= 0, limit for the event-driven method: that of the checks' tolerances
    double limit = 0.01;                    ///< >= 0, limit for discrete methods
    std::string title;                      ///< of the case; empty: another scene of the case has it
    std::string figure;                     ///< what is measured, in words; likewise
    std::string step;                       ///< how `dt` was chosen, in words; likewise
    std::map<Symptom, std::string> causes;  ///< why methods fail, in words; those of all scenes of the case count
    std::optional<double> stiffness;        ///< > 0, of `penalty`, which chooses one without it [mass/time^2]
    std::vector<StressMember> members;      ///< run as well, each as a scene of its own
    std::string waits_for;  ///< what is not built yet and the case needs; empty: the case is required of `event`
};

}  // namespace carom
