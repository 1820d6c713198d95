/// \file
/// The `checks` of a scene, held against an event-driven run of it.
#pragma once

#include <carom/study.hpp>

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace carom {

enum class CheckVerdict : std::uint8_t {
    holds,
    fails,
    open  ///< the run ended before what the check asks about: whether it holds is not known
};
/// "holds", "fails", "open".
const char* name(CheckVerdict verdict);

struct CheckResult {
    std::string what;  ///< the check in words: "event_time 0", "rest_time ball"
    CheckVerdict verdict = CheckVerdict::open;
    std::optional<double> error;  ///< how far the run is from what the check says, in the unit of `tolerance`
    double tolerance = 0;         ///< largest error that holds: `abs`, or `rel` times the size of what is expected
    std::string message;          ///< for people: what was expected and found; why it is open
};

/// Figures of a run that checks ask for.
struct CheckedRun {
    RunStudy study;
    std::vector<double> impact_times;  ///< of the first impacts, as many as checks ask about [time]
};

struct CheckReport {
    CheckedRun run;
    std::vector<CheckResult> results;  ///< one for each of Scene::checks
    bool all_hold() const;
    bool any_fails() const;
};

/// Each check of the scene against a run of it. Without `abs` and `rel` the tolerance is 0, but for no_overlap, where
/// it is 1e-9 of the smallest radius (what counts as touching). A run that did not reach the end of the scene leaves
/// open what would need it; what happened before is still held against the check.
///
/// | type | error | `rel` is relative to |
/// |---|---|---|
/// | no_overlap | deepest overlap at impacts and samples [length] | smallest radius |
/// | energy | largest abs(E - E0) at samples [energy] | largest kinetic energy |
/// | momentum | abs(p - p0) at the end [momentum] | sum of m abs(v) at the start |
/// | inside | centres outside a wall at the end | 1 |
/// | event_time, rest_time | difference of times [time] | the time |
/// | event_count | difference of counts | the count |
/// | final_position, final_velocity | distance [length, length/time] | size of the value |
std::vector<CheckResult> evaluate_checks(const Scene& scene, const CheckedRun& run);

/// Runs the event method to the end of the scene and evaluates its checks. \pre the scene is valid.
CheckReport check_scene(const Scene& scene, const std::function<bool(double)>& on_progress = {});

}  // namespace carom
