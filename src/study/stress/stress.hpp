/// \file
/// Stress: stiff and extreme cases, each with a rule that a method passes or fails.
#pragma once

#include <carom/progress.hpp>

#include <optional>
#include <string>
#include <vector>

namespace carom::stress {

/// What went wrong first, in the order in which it is looked for.
enum class Symptom {
    none,       ///< the rule is kept
    stopped,    ///< the run did not reach its end, or ended in numbers that are not finite
    other_run,  ///< another run than that of the same scene elsewhere (`event` only: another hash)
    sank,       ///< half a radius or more inside a body at the end of a step
    energy,     ///< energy that should be kept was not, by a hundredth or more
    missed,     ///< fewer impacts than there are
    invented,   ///< more
    late        ///< none of these: everything happened, at the wrong time or place
};
const char* name(Symptom symptom);

/// One method on one case.
struct Result {
    std::string method = {};
    bool passed = false;
    double figure = 0;       ///< what the rule bounds; may be infinite or not a number
    double limit = 0;        ///< that holds for this method
    std::string worst = {};  ///< which part of the case the figure comes from; may be empty
    Symptom symptom = Symptom::none;
    std::string reason = {};  ///< a sentence for a method that fails, else empty
    double seconds = 0;       ///< CPU time [s]
};

/// One case and how the methods did.
struct CaseResult {
    std::string name, title, about;
    std::string figure;  ///< what is measured, in words
    std::string rule;    ///< when it is passed, in words
    std::string step;    ///< of discrete methods, in words
    std::vector<Result> results;
};

struct Report {
    std::vector<std::string> methods;
    std::vector<CaseResult> cases;  ///< those finished, if interrupted
    bool interrupted = false;

    /// Whether `event`, if it was asked for, passes everything.
    bool event_passes() const;
};

struct Options {
    std::vector<std::string> methods;  ///< as `make_method`; empty: all
    std::optional<std::string> only;   ///< name of a case; none: all
    OnProgress on_progress;            ///< stage "stress", in runs of one method on one case; false interrupts
};

/// Names of the cases, in their order.
std::vector<std::string> case_names();

/// \throws InputError for unknown names of methods or cases.
Report run_cases(const Options& options);

}  // namespace carom::stress
