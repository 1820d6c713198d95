/// \file
/// The `checks` of a scene, held against an event-driven run of it.
#pragma once

#include <carom/study.hpp>

#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace carom {

enum class CheckVerdict : std::uint8_t {
    holds,
    fails,
    open  ///< the run ended before what the check asks about: whether it holds is not known
};
inline constexpr std::array<std::string_view, 3> check_verdict_names{"holds", "fails", "open"};
/// The word that results and files use for a verdict.
const char* name(CheckVerdict verdict);

struct CheckResult {
    std::string what;  ///< the check in words: "event_time 0", "rest_time ball"
    CheckVerdict verdict = CheckVerdict::open;
    std::optional<double> error;  ///< how far the run is from what the check says, in the unit of `tolerance`
    double tolerance = 0;         ///< largest error that holds: `abs`, or `rel` times the size of what is expected
    std::string message;          ///< for people: what was expected and found; why it is open
};

/// The run of a scene that should be the same one, see CheckType::moved and those after it.
struct Repeat {
    Outcome outcome;
    double difference = 0;      ///< of its end from the one expected, dimensionless
    bool other_events = false;  ///< it was another run: see `evaluate_checks`
};

/// Findings of a check while a run went on.
struct CheckSight {
    std::optional<double> time;    ///< event_time: when that impact was [time]
    std::optional<Vec3> position;  ///< position: of the body at that time [length]
    std::optional<Repeat> repeat;  ///< moved, moved_origin, later, reversed
};

/// Figures of a run that checks ask for.
struct CheckedRun {
    RunStudy study;
    std::vector<CheckSight> sights;  ///< one for each of Scene::checks; missing ones saw nothing
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
/// | final_energy | abs(E - E0) at the end [energy] | largest kinetic energy |
/// | momentum | abs(p - p0) at the end [momentum] | sum of m abs(v) at the start |
/// | inside | centres outside a wall at the end | 1 |
/// | event_time, rest_time | difference of times [time] | the time |
/// | event_count | difference of counts | the count |
/// | position, final_position, final_velocity | distance [length, length/time] | size of the value |
/// | moved, moved_origin, later | difference of the two runs at the end, see below | 1 |
/// | reversed | largest distance from the start, in smallest radii | 1 |
/// | mirrored | largest difference, as of two runs, of a sphere's image from the sphere that is nearest to it | 1 |
///
/// The difference of two runs: the largest of velocities, in largest speeds at the start, and of positions, in smallest
/// radii; distances within the spacing of doubles at the places that are written are none. It is infinite where an
/// event-driven run is another one, by its event_hash, and for `reversed` where it has another number of impacts on the
/// way back; also where nothing met on the way there.
std::vector<CheckResult> evaluate_checks(const Scene& scene, const CheckedRun& run);

struct CheckOptions {
    Method method = EventDriven{};
    double max_seconds = std::numeric_limits<double>::infinity();  ///< > 0, of each run [s]
    std::function<bool(double)> on_progress = {};  ///< may be empty; gets the time reached; false interrupts
};

/// Runs the method to the end of the scene, and again where a check asks for it, and evaluates its checks. \pre the
/// scene is valid.
CheckReport check_scene(const Scene& scene, const CheckOptions& options = {});

}  // namespace carom
