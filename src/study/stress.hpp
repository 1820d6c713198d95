/// \file
/// Stress: stiff and extreme scenes, in cases with a rule each, which a method passes or fails.
#pragma once

#include "study/symptoms.hpp"

#include <carom/progress.hpp>

#include <functional>
#include <set>
#include <string>
#include <vector>

namespace carom::stress {

/// A scene of a case as it is, or a variation of it.
struct Trial {
    std::string name;  ///< what users type, then the variation: "zeno", "zeno, e = 0.9"
    Scene scene;       ///< \pre has a StressPart
};

/// Method that is put to the cases: one of ours, or an engine beside.
struct Contestant {
    std::string name;
    bool is_exact = false;           ///< held to StressPart::exact, not to StressPart::limit
    std::set<CheckType> left_out{};  ///< checks that it cannot answer: steppers know no rest, some engines no impacts
    /// Runs the scene with its StressPart::dt and holds its checks against that (`evaluate_checks`); ends soon when
    /// `goes_on` says false.
    std::function<CheckReport(const Scene& scene, const std::function<bool()>& goes_on)> check;
};

/// Our methods of these names; none given: all. \throws InputError for unknown ones
std::vector<Contestant> contestants(const std::vector<std::string>& methods);

/// One trial of one contestant.
struct Finding {
    std::string trial;
    Evidence evidence;
    Symptom symptom = Symptom::none;
};

/// One contestant on one case.
struct Result {
    std::string method{};
    bool is_exact = false;
    double limit = 0;                 ///< of the figures, for this contestant
    std::vector<Finding> findings{};  ///< by trial
    std::string reason{};             ///< a sentence for one that fails, else empty
    double seconds = 0;               ///< CPU time [s]

    double figure() const;         ///< largest of all trials
    const Finding& worst() const;  ///< with the gravest symptom, else with the largest figure \pre there is a finding
    bool passed() const { return reason.empty(); }
};

/// A row of the table.
struct Case {
    StressPart words;   ///< what one of the scenes, or all, say
    std::string about;  ///< their descriptions
    std::vector<Trial> trials;
    std::vector<Result> results;  ///< by contestant

    bool is_required() const { return words.waits_for.empty(); }
    std::string rule() const;  ///< when it is passed, in words
};

struct Report {
    std::vector<std::string> methods;
    std::vector<Case> cases;  ///< those finished, if interrupted
    bool interrupted = false;
    /// Whether who claims to be exact passes all that is required.
    bool exact_hold() const;
};

/// The cases in the order of their names. \throws InputError where scenes of one case disagree about its limits
std::vector<Case> cases_of(const std::vector<Trial>& trials);

/// Every contestant on every case. \param on_progress may be empty; false interrupts
Report run_cases(std::vector<Case> cases, const std::vector<Contestant>& who, const OnProgress& on_progress = {});

}  // namespace carom::stress
