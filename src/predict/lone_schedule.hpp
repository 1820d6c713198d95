/// \file
/// One sphere among planes: no queue, no broad phase, no stamps of partners, and its commonest event carried out on the
/// spot.
#pragma once

#include "hold/low_bounce.hpp"
#include "hold/rest_policy.hpp"
#include "impact/pair_law.hpp"
#include "predict/first_contact.hpp"

#include <carom/simulate.hpp>

#include <span>

namespace carom {

class LoneSchedule {
public:
    struct Next {
        Key key;
    };
    struct Bounces {
        int count = 0;
        bool lose_energy = false;  ///< the last of them; the others never do
    };

    LoneSchedule(const State& state, Counts& counts)
    {
        if (state.count() == 0) return;
        for (int p = 0; p < state.planes(); ++p) {
            const Plane& plane = state.plane(p);
            plates_ = plates_ || plane.thickness;
            walls_.push_back(
                {plane.normal, plane.offset, plane.normal.dot(state.gravity()), state.law(0, Partner::plane(p)), p});
        }
        flight_changed(state, 0, {}, counts);
    }

    const Next& next() const { return next_; }
    void flight_changed(const State& state, BodyId body, const EpochTime&, Counts& counts)
    {
        next_.key = {};
        offer_planes<PlainKinematics<true>>(
            state, body, counts, next_.key.time, [&](const Key& key, bool) { next_.key = std::min(next_.key, key); },
            [](int) { return false; });
    }

    void flights_changed(const State& state, std::span<const Change> changes, const EpochTime& now, Counts& counts)
    {
        for (const Change& change : changes) flight_changed(state, change.body, now, counts);
    }

    /// Carries out bounces that leave the sphere flying, the commonest events of all, in one loop: the same bits as
    /// `resolve`, which is to be asked if there is more to the next one (another contact, a support, a plate, rest, a
    /// low bounce). \param last time after which nothing is carried out \param most bounces; it stops after one that
    /// loses energy
    template <class Ledger>
    Bounces bounces(State& state, const EpochTime& last, int most, Ledger& ledger)
    {
        if (plates_ || state.scene.rest.policy == RestPolicy::micro || next_.key.kind != Scheduled::plane_impact ||
            state.bodies.kind(0) != MotionKind::flying)
            return {};
        return walls_.size() == 1 ? bounces_among<true>(state, last, most, ledger)
                                  : bounces_among<false>(state, last, most, ledger);
    }

    // Parts of a schedule that a single sphere has no use for.
    bool is_stale(const State&, const Next&) const { return false; }
    void predict_again(const State&, const Next&, Counts&) {}
    bool refine(const State&, const Next&, Counts&) const { return false; }
    void leave(const State&, const Key&, Counts&) {}
    std::span<const BodyId> neighbours(BodyId) const { return {}; }
    bool is_alone(const State&, BodyId, Partner, const EpochTime&) const { return false; }
    std::span<const BodyId> wide_neighbours(BodyId) const { return {}; }

private:
    struct Wall {
        Vec3 normal;
        double offset;   ///< [length]
        double gravity;  ///< along the normal [length/time^2]
        ContactLaw law;
        int plane;
    };
    struct Meeting {
        EpochTime time;
        const Wall* wall;  ///< null if none
        double h, w;       ///< height and its rate when the flight began [length], [length/time]
    };

    /// The height, with the bits of height_above.
    static double height(const Frame& frame, const Wall& wall, const Place& place, double radius)
    {
        const Sum sum = signed_height(frame, wall.normal, wall.offset, place);
        const Sum gap = two_sum(sum.high, -radius);
        return gap.high + (gap.low + sum.low);
    }

    bool another_closes(const Frame& frame, const Wall& wall, const Place& place, const Vec3& velocity, double radius,
                        double tie) const
    {
        for (const Wall& other : walls_)
            if (&other != &wall && other.normal.dot(velocity) <= 0 && height(frame, other, place, radius) <= tie)
                return true;
        return false;
    }

    static Meeting meeting(const Frame& frame, const Flight& f, double radius, const Wall& wall)
    {
        return {never, &wall, height(frame, wall, f.place, radius), wall.normal.dot(f.velocity)};
    }

    template <bool alone, class Ledger>
    [[gnu::flatten]] Bounces bounces_among(State& state, const EpochTime& last, int most, Ledger& ledger)
    {
        const Frame frame = state.frame;
        const Vec3 acceleration = state.gravity();
        const double radius = state.radius(0), tie = state.tie(radius), mass = 1 / state.inverse_mass(0),
                     scale = radius + frame.cell_size;
        Flight f = state.flight(0);
        Meeting next = meeting(frame, f, radius, walls_[static_cast<std::size_t>(next_.key.b.index)]);
        next.time = next_.key.time;
        bool began_at_impact = state.bodies.stamp(0) > 0;
        const Wall& only = walls_.front();
        int done = 0;
        bool loses_energy = false;
        while (done < most && next.wall && next.time <= last) {
            const Wall& wall = alone ? only : *next.wall;
            const Vec3 normal = wall.normal;
            const bool inelastic = wall.law.restitution < 1;
            // A wall that was closed and closing when the flight began belongs to the event before it. (Not a wall that
            // the sphere has just bounced off.)
            if (!(alone && done > 0) && next.w < 0 && next.h <= tie && began_at_impact) break;

            const double dt = frame.between(f.start, next.time);
            const Place place = moved(frame, f.place, displacement(f.velocity, acceleration, dt));
            const Vec3 before = f.velocity + dt * acceleration;
            if (!alone && another_closes(frame, wall, place, before, radius, tie)) break;
            Meeting again{never, &wall, height(frame, wall, place, radius), 0};
            if (inelastic && !(wall.gravity < 0) &&
                is_inelastic(state, wall.law, 0, Partner::plane(wall.plane), -normal.dot(before), next.time,
                             [] { return false; }))
                break;
            const Vec3 change = velocity_change(before, normal, wall.law), after = before + change;
            again.w = normal.dot(after);
            if (again.w < 0 || is_rest(scale, after, again.w, -wall.gravity) ||
                (inelastic && is_low(state, 0, again.w, -wall.gravity, wall.law)))
                break;

            f.start = next.time;
            f.place = place;
            f.velocity = after;
            began_at_impact = true;
            ++done;
            ledger.record_bounce(
                {EventKind::impact, f.start, 0, 0, state.body_of(Partner::plane(wall.plane)), normal, mass * change},
                wall.plane, -again.h);
            if (ledger.shows_flights()) {
                state.bodies.set({0, f});
                ledger.show_flight(state, 0);
            }
            next = first_meeting<alone>(frame, f, radius, again, ledger.out.counts);
            if (inelastic) {
                state.recent.add(0, state.body_of(Partner::plane(wall.plane)), f.start);
                loses_energy = true;
                break;
            }
        }
        if (done == 0) return {};
        state.bodies.set({0, f});
        next_.key = next.wall ? Key{next.time, Scheduled::plane_impact, 0, Partner::plane(next.wall->plane)} : Key{};
        ledger.out.counts.pair_tests += done * static_cast<std::int64_t>(walls_.size());
        return {done, loses_energy};
    }

    /// The first contact, with the bits of offer_planes. \param known the contact with one wall, but for its time
    template <bool alone>
    Meeting first_meeting(const Frame& frame, const Flight& f, double radius, const Meeting& known,
                          Counts& counts) const
    {
        Meeting best{never, nullptr, 0, 0};
        const auto offer = [&](const Meeting& c) {
            const Root root = plane_root(c.h, c.w, c.wall->gravity);
            if (root.kind == RootKind::none) return;
            ++counts.root_solves;
            const EpochTime time = frame.after(f.start, root.t);
            if (!(time < best.time)) return;
            best = c;
            best.time = time;
        };
        if (known.w < 0 || known.wall->gravity < 0) offer(known);
        if constexpr (alone) return best;
        for (const Wall& wall : walls_)
            if (&wall != known.wall && (wall.normal.dot(f.velocity) < 0 || wall.gravity < 0))
                offer(meeting(frame, f, radius, wall));
        return best;
    }

    Next next_;
    std::vector<Wall> walls_;
    bool plates_ = false;  ///< some wall is one: none of the short ways then
};

}  // namespace carom
