/// \file
/// A run is a value: simulate(scene, method, options, observer) -> Outcome. Nothing global, no I/O, no exceptions for
/// numerical outcomes.
#pragma once

#include <carom/event.hpp>
#include <carom/flight.hpp>
#include <carom/method.hpp>
#include <carom/scene.hpp>

#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace carom {

/// The end of a run.
enum class Status : std::uint8_t {
    reached_end,
    event_limit,  ///< RunOptions::max_events
    time_limit,   ///< RunOptions::max_seconds
    zeno,         ///< infinitely many bounces in finite time, and the rest policy says to stop there
    unresolved,   ///< something that carom cannot resolve yet; Outcome::message says what, where, when
    interrupted   ///< the observer said stop
};
inline constexpr std::array<std::string_view, 6> status_names{"reached_end", "event_limit", "time_limit",
                                                              "zeno",        "unresolved",  "interrupted"};
/// The word that results and files use for a status.
const char* name(Status status);

/// State of one sphere at a moment.
struct BodyState {
    Vec3 position = Vec3::Zero();  ///< centre, relative to Scene::origin [length]
    Vec3 velocity = Vec3::Zero();  ///< [length/time]
    Mode mode = Mode::flying;
};

struct RunOptions {
    /// End, >= 0 and finite, since the start [time]; NaN: Scene::end_time.
    double until = std::numeric_limits<double>::quiet_NaN();
    std::int64_t max_events = 1'000'000'000;  ///< >= 1; impacts, rests, releases (substeps for discrete methods)
    double max_seconds = std::numeric_limits<double>::infinity();  ///< > 0; wall clock, looked at now and then [s]
};

/// An observer of a run. An empty function costs nothing. Looking never changes a run: flights change at contacts only.
/// Functions are called in the order of time, on the thread of the run; what they throw ends the run and passes on.
struct Observer {
    std::vector<double> sample_times;  ///< ascending, in [0, until], since the start [time]
    std::function<void(const Event&)> on_event;
    std::function<void(const RunFrame&)> on_frame;  ///< once, before anything else; event-driven runs only
    /// Each flight as it begins, those of the start in body order; at one time, events come before the flights that
    /// they begin. Event-driven runs only.
    std::function<void(const FlightRecord&)> on_flight;
    /// k-th sample time; states in body order, valid during the call.
    std::function<void(std::size_t k, double time, std::span<const BodyState>)> on_sample;
    /// Called now and then with the time reached [time]; false stops the run with Status::interrupted.
    std::function<bool(double time)> on_progress;
};

/// Work done, machine independent. A method leaves at 0 what it does not have.
struct Counts {
    std::int64_t impacts = 0;      ///< contacts that got an impulse (an instant may have several impacts of a pair)
    std::int64_t clusters = 0;     ///< instants at which several contacts were resolved together
    std::int64_t capped = 0;       ///< those of them whose operator met its bound: they were inelastic instead
    std::int64_t early_rests = 0;  ///< see EarlyRest
    std::int64_t rests = 0, releases = 0, guarded = 0, settles = 0;
    std::int64_t cell_crossings = 0, list_rebuilds = 0;
    std::int64_t stale = 0;          ///< scheduled events that were out of date when their turn came
    std::int64_t pair_tests = 0;     ///< pairs (sphere-sphere, sphere-plane) whose gap or time of impact was examined
    std::int64_t root_solves = 0;    ///< square roots taken or brackets bisected for a time of impact
    std::int64_t steps = 0;          ///< substeps of a discrete method
    std::int64_t numeric_steps = 0;  ///< of clusters whose normals turn
};

/// Kinetic energy that thresholds and bounds took, each >= 0 up to rounding [energy]. Energy that impacts take by e < 1
/// is not in it.
struct EnergyTaken {
    double closing = 0;      ///< impacts made inelastic: every closing slower than v_c, or closed less than tau_p ago
    double settling = 0;     ///< contacts declared persistent: their rest of normal speed
    double stabilising = 0;  ///< numeric clusters: gaps and closings put back to 0, and the error of the steps
    double guard = 0;        ///< windows of the guard
    double window = 0;       ///< windows of heaps, with what e < 1 takes in them, landing at rest included
    double capped = 0;       ///< impacts whose operator met its bound, with what e < 1 takes
};

/// A sphere alone on another one, or under drag on a plane, that a threshold brought to rest, for more than a million
/// bounces were to come.
struct EarlyRest {
    BodyId body = no_body;
    double time = 0;  ///< by which it rests too early, at most [time]
};

/// Time spent by all moving bodies together [time].
struct BodyTimes {
    double closed_form = 0;  ///< flights, series, slides and rests
    double numeric = 0;      ///< numeric clusters
    double guarded = 0;      ///< windows of the guard
};

struct Outcome {
    Status status = Status::reached_end;
    std::string message;  ///< for people, empty when the end was reached
    std::string kernel;   ///< which compiled kernel ran, empty for discrete methods
    double time = 0;      ///< reached, since the start [time]
    Counts counts;
    std::vector<BodyState> final;                   ///< at `time`, in body order
    std::vector<std::optional<double>> rest_times;  ///< per sphere: when its normal motion ended, if it did [time]
    std::vector<double> plane_impulses;  ///< per plane: normal impulse taken, resting included [mass length/time]
    EnergyTaken energy_taken;
    std::optional<EarlyRest> early_rest;  ///< the one of them with the longest time
    BodyTimes body_seconds;
    double max_penetration = 0;  ///< event: at impacts; discrete: at the end of each substep before correction [length]
    std::uint64_t event_hash = 0;  ///< event-driven runs only
    double epoch_length = 1;       ///< power of two [time]
};

/// The outcome of a run of a scene. \pre the scene is valid (`validate`), options in range. \post Outcome::final has a
/// state for each sphere, all numbers finite unless status says otherwise. Runs share nothing: several may go on at
/// once, on threads of their own. The same arguments give the same outcome, bit for bit, unless a limit of time stopped
/// it.
Outcome simulate(const Scene& scene, const Method& method, const RunOptions& options = {},
                 const Observer& observer = {});

/// n + 1 equally spaced times from 0 to `until`, which is the last to the bit; for n = 0 that one alone [time].
std::vector<double> sample_grid(double until, std::size_t n);

}  // namespace carom
