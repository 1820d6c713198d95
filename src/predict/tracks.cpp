#include "predict/tracks.hpp"

#include "predict/wide_tracks.hpp"

#include <algorithm>

namespace carom {

namespace {

template <bool gravity>
std::size_t find(const Track* tracks, BodyId body, double age, double least_square, std::span<const BodyId> near,
                 Meeting* found)
{
    const Track& own = tracks[body];
    std::size_t count = 0;
    for (const BodyId other : near) {
        const Track& its = tracks[other];
        const bool asked = its.is_parabola && its.acceleration == own.acceleration;
        const double soonest = asked ? soonest_contact<gravity>(own, its, age, least_square) : Meeting::unknown;
        if (!asked || soonest < std::numeric_limits<double>::infinity()) found[count++] = {soonest, other};
    }
    return count;
}

}  // namespace

template <bool gravity>
std::span<Meeting> Tracks::meetings(BodyId body, double age, std::span<const BodyId> near,
                                    std::vector<Meeting>& room) const
{
    if (room.size() < near.size()) room.resize(near.size());
    if (!(*this)[body].is_parabola) {
        for (std::size_t i = 0; i < near.size(); ++i) room[i] = {Meeting::unknown, near[i]};
        return {room.data(), near.size()};
    }
    if (has_wide_registers())
        return {room.data(), find_wide<gravity>(tracks_.data(), body, age, least_square_, near, room.data())};
    return {room.data(), find<gravity>(tracks_.data(), body, age, least_square_, near, room.data())};
}

template std::span<Meeting> Tracks::meetings<true>(BodyId, double, std::span<const BodyId>,
                                                   std::vector<Meeting>&) const;
template std::span<Meeting> Tracks::meetings<false>(BodyId, double, std::span<const BodyId>,
                                                    std::vector<Meeting>&) const;

std::span<const BodyId> Tracks::in_reach(const State& state, const Track& own, double age, std::span<const BodyId> near,
                                         std::vector<BodyId>& found) const
{
    if (found.size() < near.size()) found.resize(near.size());
    std::span<const BodyId> left = near;
    if (has_wide_registers()) left = {found.data(), in_reach_wide(tracks_.data(), own, age, near, found.data())};
    std::size_t count = 0;
    for (const BodyId other : left)
        if (!are_apart(state, own, (*this)[other], age)) found[count++] = other;
    return {found.data(), count};
}

Tracks::Tracks(const State& state) : tracks_(static_cast<std::size_t>(state.count()))
{
    if (state.count() > 0) std::copy_n(state.flight(0).place.cell, 3, origin_.cell);
    origin_position_ = position_of(state.frame, origin_);
    renew(state, {});
}

void Tracks::follow(const State& state, BodyId body, const EpochTime& now)
{
    if (++changes_ > changes_a_moment * state.count())
        renew(state, now);
    else
        set(state, body);
}

void Tracks::renew(const State& state, const EpochTime& now)
{
    changes_ = 0;
    moment_ = now;
    least_square_ = 0;
    for (BodyId i = 0; i < state.count(); ++i) set(state, i);
}

void Tracks::set(const State& state, BodyId body)
{
    Track& track = tracks_[static_cast<std::size_t>(body)];
    const MotionKind kind = state.bodies.kind(body);
    track.is_parabola = state.drag == 0 && kind != MotionKind::bouncing && !is_piece(kind);
    if (!track.is_parabola) return;
    const Flight& f = state.flight(body);
    const double dt = state.frame.between(f.start, moment_);
    const Vec3& a = state.acceleration(f);
    const Vec3 r = separation(state.frame, f.place, origin_), way = displacement(f.velocity, a, dt);
    double size = 0;
    for (int k = 0; k < 3; ++k) {
        track.place[k] = r[k] + way[k];
        track.velocity[k] = f.velocity[k] + dt * a[k];
        size += std::abs(r[k]) + std::abs(dt) * (std::abs(f.velocity[k]) + std::abs(dt * a[k]));
    }
    track.acceleration = f.acceleration;
    const double radius = state.radius(body);
    track.reach = radius * (1 + reach_inflation) + state.widest_tie(body) + place_rounding * size;
    if (f.acceleration == Accelerations::none) return;
    const double speed = speed_rounding * (f.velocity.squaredNorm() + dt * dt * a.squaredNorm());
    least_square_ = std::max(least_square_, speed);
}

Track Tracks::at(const State& state, BodyId body, double age) const
{
    Track track = (*this)[body];
    const Vec3& a = state.bodies.accelerations()[track.acceleration];
    for (int k = 0; k < 3; ++k) {
        track.place[k] += age * (track.velocity[k] + (0.5 * age) * a[k]);
        track.velocity[k] += age * a[k];
    }
    return track;
}

TrackPlane::TrackPlane(const Plane& plane, const Vec3& origin)
    : normal_{plane.normal[0], plane.normal[1], plane.normal[2]},
      offset_(plane.offset - plane.normal.dot(origin)),
      thickness_(plane.thickness.value_or(0) / 2 + place_rounding * (std::abs(plane.offset) + origin.cwiseAbs().sum())),
      is_plate_(plane.thickness.has_value())
{
}

bool TrackPlane::is_near(const Vec3& position, double radius) const
{
    const double height = above(position.data()) - offset_;
    return (is_plate_ ? std::abs(height) : height) <= thickness_ + radius;
}

bool TrackPlane::is_out_of_reach(const State& state, const Track& own, double time) const
{
    double height = above(own.place) - offset_, w = above(own.velocity), g = 0;
    double speed = std::abs(own.velocity[0]) + std::abs(own.velocity[1]) + std::abs(own.velocity[2]);
    if (own.acceleration != Accelerations::none) {
        const Vec3& a = state.bodies.accelerations()[own.acceleration];
        g = above(a.data());
        if (time > 0 && time < std::numeric_limits<double>::infinity()) speed += time * a.cwiseAbs().sum();
    }
    if (is_plate_) {
        height = std::abs(height);
        w = -std::abs(w);
        g = -std::abs(g);
    }
    height -= thickness_ + own.reach;
    if (!(height > 0)) return false;
    if (time == std::numeric_limits<double>::infinity())
        return w > direction_rounding * speed && g >= 0 && own.acceleration == Accelerations::none;
    return height + time * (w + 0.5 * time * std::min(g, 0.0)) > direction_rounding * speed * time;
}

}  // namespace carom
