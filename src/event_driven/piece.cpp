#include "event_driven/piece.hpp"

#include "event_driven/motion.hpp"

namespace carom {

Flight flight_at(const State& state, BodyId body, const EpochTime& now)
{
    Flight f = advanced(state, body, now);
    const auto piece = state.pieces.find(body);
    if (piece == state.pieces.end() || !piece->second.cluster) return f;
    const Piece& p = piece->second;
    if (now == state.flight(body).start) return f;
    const bool at_end = now == p.end;
    const NumericStep part =
        at_end ? *p.step : numeric_step(*p.cluster, state.frame.between(state.flight(body).start, now), false);
    const NumericBody& at = part.bodies[static_cast<std::size_t>(p.index)];
    f.place = moved(state.frame, p.centre, at.position);
    f.velocity = at.velocity;
    return f;
}

Vec3 chord_acceleration(const Vec3& displacement, const Vec3& velocity, double duration)
{
    return 2 / duration * (displacement / duration - velocity);
}

}  // namespace carom
