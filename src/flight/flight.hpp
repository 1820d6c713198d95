/// \file
/// A flight: one body's motion between two of its own contact events, in closed form. It changes at those events and
/// never in between.
#pragma once

#include "flight/frame.hpp"

#include <carom/flight.hpp>

#include <vector>

namespace carom {

/// "Same acceleration" is a question of ids, never a comparison of floats.
using AccelerationId = std::int32_t;

/// The accelerations that occur in a run: none, gravity, gravity along each plane for what rests or slides on it, and
/// for each body one of its own, for what several contacts push.
class Accelerations {
public:
    explicit Accelerations(const Scene& scene);

    static constexpr AccelerationId none = 0;
    AccelerationId free() const { return has_gravity_ ? 1 : none; }
    AccelerationId along(int plane) const { return has_gravity_ ? plane + 2 : none; }

    AccelerationId own(BodyId body) const { return shared_ + body; }
    bool is_own(AccelerationId id) const { return id >= shared_; }
    void set_own(BodyId body, const Vec3& value)
    {
        const auto at = static_cast<std::size_t>(own(body));
        if (table_.size() <= at) table_.resize(at + 1, Vec3::Zero());
        table_[at] = value;
    }

    /// Those that do not belong to one body.
    AccelerationId shared() const { return shared_; }
    bool has_gravity() const { return has_gravity_; }
    const Vec3& operator[](AccelerationId id) const { return table_[static_cast<std::size_t>(id)]; }

private:
    bool has_gravity_;
    AccelerationId shared_ = 1;
    std::vector<Vec3> table_;  ///< [length/time^2]
};

/// A parabola from its start on.
struct Flight {
    EpochTime start{};
    Place place{};                 ///< at start
    Vec3 velocity = Vec3::Zero();  ///< at start [length/time]
    AccelerationId acceleration = Accelerations::none;
};

/// x(dt) - x(0) = dt (v + a dt/2) [length].
inline Vec3 displacement(const Vec3& velocity, const Vec3& acceleration, double dt)
{
    return dt * (velocity + (0.5 * dt) * acceleration);
}

/// p_a - p_b of two places [length]. The cells cancel first, as whole numbers: nothing of a far origin is left.
inline Vec3 separation(const Frame& frame, const Place& a, const Place& b)
{
    Vec3 r;
    for (int k = 0; k < 3; ++k) {
        const double cells = static_cast<double>(a.cell[k] - b.cell[k]) * frame.cell_size;
        r[k] = cells + (a.local[k] - b.local[k]);
    }
    return r;
}

}  // namespace carom
