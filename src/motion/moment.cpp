#include "motion/moment.hpp"

#include "motion/relative.hpp"
#include "motion/window_piece.hpp"

namespace carom {

namespace {

void place(const State& state, const Stepping& stepping, const NumericBody& at, Flight& f)
{
    f.place = moved(state.frame, stepping.piece->centre, at.position);
    f.velocity = at.velocity;
}

/// The velocity within a window that is interrupted: what pushes and rebounds change grows in it from nothing. So
/// momentum is kept, and energy, a convex function of it, does not grow (docs/windows.md).
Vec3 within_window(const State& state, const Windowed& window, const Flight& flight, const EpochTime& now)
{
    const double time = state.frame.between(flight.start, now);
    const Vec3& before = window.piece->velocities[window.index];
    if (flight.acceleration != Accelerations::none) return before + time * state.acceleration(flight);
    return before + (time / window.piece->length) * (window.end_velocity - before);
}

}  // namespace

Flight Moment::flight(BodyId body)
{
    Flight f = advanced(state_, body, now_);
    if (const auto* window = state_.bodies.as<Windowed>(body)) {
        if (now_ == window->end)
            f.velocity = window->end_velocity;
        else if (window->piece)
            f.velocity = within_window(state_, *window, state_.flight(body), now_);
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
