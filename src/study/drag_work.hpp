/// \file
/// Energy that drag takes in an event-driven run, in closed form.
#pragma once

#include "study/compensated_sum.hpp"

#include <carom/flight.hpp>
#include <carom/scene.hpp>

#include <vector>

namespace carom::study {

/// The integral of k v^2 over the first `t` of a flight under drag k > 0, for a mass of 1: not the difference of the
/// energies at its ends, so that it can be held against them [energy/mass].
double damped_energy(const RunFrame& frame, const FlightRecord& flight, double t);

/// Adds the work of drag up, flight by flight.
class DragWork {
public:
    explicit DragWork(const Scene& scene) : scene_(scene), latest_(scene.spheres.size()) {}

    void on_frame(const RunFrame& frame) { frame_ = frame; }
    void on_flight(const FlightRecord& flight);
    /// Energy that drag took from the start of the run to a moment, which no flight known begins after [energy].
    double taken(double time) const;

private:
    const Scene& scene_;
    RunFrame frame_;
    std::vector<FlightRecord> latest_;  ///< by body; body is no_body until its first flight
    CompensatedSum ended_;              ///< of the flights before those [energy]
};

}  // namespace carom::study
