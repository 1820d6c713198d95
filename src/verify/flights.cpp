#include "verify/flights.hpp"

#include <algorithm>

namespace carom::verification {

void Flights::set(BodyId body, const Path& path)
{
    const auto i = static_cast<std::size_t>(body);
    Kept& kept = kept_[i];
    kept.start = path.start;
    std::copy_n(path.cell, 3, kept.cell);
    std::copy_n(path.local, 3, kept.local);
    std::copy_n(path.velocity.data(), 3, kept.velocity);
    kept.acceleration = path.acceleration;
    kept.support = path.support;
    kept.mode = path.mode;
    kept.guarded = path.guarded;
    if (!low_.empty() || !vector_of(path.local_low).isZero(0) || !path.velocity_low.isZero(0)) {
        if (low_.size() < kept_.size()) low_.resize(std::max(kept_.size(), kept_.capacity()));
        std::copy_n(path.local_low, 3, low_[i].local);
        std::copy_n(path.velocity_low.data(), 3, low_[i].velocity);
    }
    if (path.acceleration != own_acceleration) return;
    if (own_.size() < kept_.size()) own_.resize(std::max(kept_.size(), kept_.capacity()));
    std::copy_n(path.own.data(), 3, own_[i].data());
}

Path Flights::path(BodyId body) const
{
    const auto i = static_cast<std::size_t>(body);
    const Kept& kept = kept_[i];
    Path path;
    path.start = kept.start;
    std::copy_n(kept.cell, 3, path.cell);
    std::copy_n(kept.local, 3, path.local);
    std::copy_n(kept.velocity, 3, path.velocity.data());
    path.acceleration = kept.acceleration;
    path.support = kept.support;
    path.mode = kept.mode;
    path.guarded = kept.guarded;
    path.drag = drag;
    if (!low_.empty()) {
        std::copy_n(low_[i].local, 3, path.local_low);
        std::copy_n(low_[i].velocity, 3, path.velocity_low.data());
    }
    if (kept.acceleration == own_acceleration) std::copy_n(own_[i].data(), 3, path.own.data());
    return path;
}

}  // namespace carom::verification
