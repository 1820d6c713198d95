/// \file
/// The truth of the one-step audit: an event-driven run in memory, with the exact state of each body at any time.
#pragma once

#include <carom/progress.hpp>
#include <carom/simulate.hpp>

#include <cstdint>
#include <vector>

namespace carom::study {

/// A parabola of one body, with drag a damped flight, from `start` until its next one.
struct TruthFlight {
    double start = 0;  ///< since the start of the run [time]
    Vec3 place = Vec3::Zero(), velocity = Vec3::Zero(), acceleration = Vec3::Zero();  ///< at `start`
    bool is_free = true;  ///< no contact lasts; false: slides, rests, is in a cluster, or at the end of a series
};

/// An impact of the truth.
struct TruthContact {
    double time = 0;                  ///< since the start of the run [time]
    BodyId a = no_body, b = no_body;  ///< as in Event
    double speed_change = 0;          ///< |dv| of a relative to b, > 0 [length/time]
};

struct TruthState {
    Vec3 position = Vec3::Zero(), velocity = Vec3::Zero();  ///< [length], [length/time]
};

/// Flights and impacts of a run. Series of bounces are written out bounce by bounce, down to closings slower than v_c.
class Truth {
public:
    double until = 0;                     ///< the run is known up to here [time]
    double drag = 0;                      ///< k >= 0 of all flights [1/time]
    Status status = Status::reached_end;  ///< of the run; so too where only memory ended it
    std::string message;                  ///< of the run, for people
    bool stopped = false;                 ///< on request, at `until`
    std::vector<TruthContact> contacts;   ///< closing at v_c or faster, in the order of time
    std::int64_t slow = 0;                ///< impacts closing slower than v_c, and tails of series, one for each
    std::int64_t persistent = 0;          ///< contacts that began to last
    std::vector<std::vector<TruthFlight>> flights;  ///< [sphere], in the order of time
    std::vector<std::vector<double>> impact_times;  ///< [sphere], ascending, each as often as it has impacts [time]

    /// The state on the flight that the body is on; before the first flight and after the last one those go on.
    TruthState state(BodyId body, double time) const;
    /// The state at the end of the flight that ends at `time`, or is under way. \pre time > 0
    TruthState state_before(BodyId body, double time) const;
    /// Whether the body flies freely all through [begin, end], with no impact in it.
    bool is_quiet(BodyId body, double begin, double end) const;
    /// Whether the body flies freely all through [begin, end], with the one impact at `time` and no other.
    bool is_alone(BodyId body, double begin, double end, double time) const;
};

/// Runs the scene by the event method. It ends where the run does, or where `most_truth_flights` are in memory.
Truth record_truth(const Scene& scene, double until, const OnProgress& on_progress);

}  // namespace carom::study
