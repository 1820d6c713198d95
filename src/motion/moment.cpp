#include "motion/moment.hpp"

#include "motion/relative.hpp"

namespace carom {

namespace {

void place(const State& state, const Stepping& stepping, const NumericBody& at, Flight& f)
{
    f.place = moved(state.frame, stepping.piece->centre, at.position);
    f.velocity = at.velocity;
}

}  // namespace

Flight Moment::flight(BodyId body)
{
    Flight f = advanced(state_, body, now_);
    if (const auto* window = state_.bodies.as<Windowed>(body)) {
        if (now_ == window->end) f.velocity = window->end_velocity;
    } else if (const auto* stepping = state_.bodies.as<Stepping>(body)) {
        const EpochTime& start = state_.flight(body).start;
        if (now_ != start) place(state_, *stepping, bodies(*stepping, start)[stepping->index], f);
    }
    return f;
}

const std::vector<NumericBody>& Moment::bodies(const Stepping& stepping, const EpochTime& start)
{
    const NumericPiece& piece = *stepping.piece;
    if (now_ == stepping.end) return piece.step.bodies;
    const auto [found, is_new] = bodies_.try_emplace(&piece);
    if (is_new) found->second = within_step(piece.cluster, piece.step, state_.frame.between(start, now_));
    return found->second;
}

Flight flight_within_step(const State& state, BodyId body, const EpochTime& now)
{
    Flight f = advanced(state, body, now);
    if (const auto* stepping = state.bodies.as<Stepping>(body)) {
        const double t = state.frame.between(state.flight(body).start, now);
        place(state, *stepping, within_step(stepping->piece->cluster, stepping->piece->step, stepping->index, t), f);
    }
    return f;
}

}  // namespace carom
