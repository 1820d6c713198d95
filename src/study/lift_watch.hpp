/// \file
/// Spheres that are lifted out of a plane in which the scene lets them begin.
#pragma once

#include <carom/flight.hpp>
#include <carom/study.hpp>

#include <vector>

namespace carom::study {

/// Compares, of spheres that begin inside a plane, where each flight begins with where the one before ended.
class LiftWatch {
public:
    explicit LiftWatch(const Scene& scene);

    /// Whether there is a sphere to watch; otherwise the other functions need not be called.
    bool has_work() const { return !watched_.empty(); }
    void on_frame(const RunFrame& frame);
    void on_flight(const FlightRecord& flight);
    const std::vector<Lift>& lifts() const { return lifts_; }

private:
    struct Watched {
        BodyId sphere;
        std::size_t plane;
        FlightRecord flight;      ///< the latest
        bool has_flight = false;  ///< it has begun
    };

    Vec3 place_at(const FlightRecord& flight, const EpochTime& time) const;
    /// The gap that the flight has come to. A series begins and ends on its plane.
    double gap_at_end(const Watched& watched, const EpochTime& end) const;
    void compare(const Watched& watched, const FlightRecord& next);

    const Scene& scene_;
    RunFrame frame_;
    std::vector<Watched> watched_;
    std::vector<Lift> lifts_;
};

}  // namespace carom::study
