#include "event_driven/piece.hpp"

#include "event_driven/motion.hpp"

namespace carom {

Flight Moment::flight(BodyId body)
{
    Flight f = advanced(state_, body, now_);
    const auto found = state_.pieces.find(body);
    if (found == state_.pieces.end()) return f;
    const Piece& piece = found->second;
    if (!piece.cluster) {
        if (now_ == piece.end) f.velocity = piece.end_velocity;
        return f;
    }
    const EpochTime& start = state_.flight(body).start;
    if (now_ == start) return f;
    const NumericBody& at = bodies(piece, start)[static_cast<std::size_t>(piece.index)];
    f.place = moved(state_.frame, piece.centre, at.position);
    f.velocity = at.velocity;
    return f;
}

const std::vector<NumericBody>& Moment::bodies(const Piece& piece, const EpochTime& start)
{
    if (now_ == piece.end) return piece.step->bodies;
    const auto [found, is_new] = bodies_.try_emplace(piece.cluster.get());
    if (is_new) found->second = within_step(*piece.cluster, *piece.step, state_.frame.between(start, now_));
    return found->second;
}

}  // namespace carom
