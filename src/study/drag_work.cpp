#include "study/drag_work.hpp"

#include "flight/damping.hpp"
#include "study/flight_state.hpp"

namespace carom::study {

double damped_energy(const RunFrame& frame, const FlightRecord& flight, double t)
{
    // v = decay v0 + way a, and (decay^2, decay way, way^2) have the integrals (way (1 + decay), way^2,
    // (2 fall - way^2)/k) / 2.
    const Damping<double> effect = damping(frame.drag, t);
    const Vec3 v = vector_of(flight.velocity), a = acceleration_of(frame, flight);
    const double square = effect.way * effect.way;
    return frame.drag * (v.squaredNorm() * (effect.way * (1 + effect.decay) / 2) + v.dot(a) * square) +
           a.squaredNorm() * (effect.fall - square / 2);
}

void DragWork::on_flight(const FlightRecord& flight)
{
    FlightRecord& before = latest_[static_cast<std::size_t>(flight.body)];
    if (before.body != no_body) {
        const double t = static_cast<double>(flight.start.epoch - before.start.epoch) * frame_.epoch_length +
                         (flight.start.offset - before.start.offset);
        ended_.add(scene_.spheres[static_cast<std::size_t>(flight.body)].mass * damped_energy(frame_, before, t));
    }
    before = flight;
}

double DragWork::taken(double time) const
{
    CompensatedSum sum = ended_;
    for (const FlightRecord& flight : latest_)
        if (flight.body != no_body)
            sum.add(scene_.spheres[static_cast<std::size_t>(flight.body)].mass *
                    damped_energy(frame_, flight, std::max(0.0, time - seconds_of(frame_, flight.start))));
    return sum.value();
}

}  // namespace carom::study
