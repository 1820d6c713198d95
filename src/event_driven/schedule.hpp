/// \file
/// Prediction: who meets whom next. One queue slot a body for contacts, and one for leaving its grid cell.
#pragma once

#include "event_driven/candidates.hpp"
#include "event_driven/predict_planes.hpp"
#include "event_driven/uniform_motion.hpp"
#include "queue/event_queue.hpp"

#include <carom/features.hpp>

#include <limits>
#include <span>

namespace carom {

template <Features features>
class Schedule {
public:
    struct Next {
        std::size_t slot;
        Key key;
    };

    /// \post every body has been examined
    Schedule(const State& state, BroadPhase broad_phase, Counts& counts)
        : candidates_(choose_candidates(state, broad_phase)),
          queue_(state.flights.size() * (std::holds_alternative<CellGrid>(candidates_) ? 2 : 1)),
          partner_stamp_(state.flights.size(), 0)
    {
        for (BodyId i = 0; i < state.count(); ++i) flight_changed(state, i, {}, counts);
    }

    Next next() const { return {queue_.first(), queue_.key(queue_.first())}; }

    /// The flight of the partner has changed since the event was predicted.
    bool is_stale(const State& state, const Next& next) const
    {
        const Key& key = next.key;
        if (key.kind != Scheduled::pair_impact && key.kind != Scheduled::intrusion) return false;
        if (state.is_plane(key.b)) return false;
        const auto owner = static_cast<BodyId>(next.slot);
        const BodyId partner = key.a == owner ? key.b : key.a;
        return partner_stamp_[next.slot] != state.stamps[static_cast<std::size_t>(partner)];
    }

    void predict_again(const State& state, const Next& next, Counts& counts)
    {
        ++counts.stale;
        examine(state, static_cast<BodyId>(next.slot), counts);
    }

    /// Predict a body's next contact and its next cell.
    void flight_changed(const State& state, BodyId body, const EpochTime& now, Counts& counts)
    {
        examine(state, body, counts);
        watch_cell(state, body, now, counts);
    }

    /// Carry out a cell crossing: new neighbours may come before the contact known so far.
    void cross(const State& state, const Key& crossing, Counts& counts)
    {
        auto& grid = std::get<CellGrid>(candidates_);
        const int axis = crossing.b / 2, direction = crossing.b % 2 == 0 ? -1 : 1;
        grid.step(crossing.a, axis, direction);
        ++counts.cell_crossings;

        const auto slot = static_cast<std::size_t>(crossing.a);
        Key best = queue_.key(slot);
        grid.new_neighbours(crossing.a, axis, direction,
                            [&](BodyId other) { offer(state, crossing.a, other, best, partner_stamp_[slot], counts); });
        if (best != queue_.key(slot)) queue_.set(slot, best);
        watch_cell(state, crossing.a, crossing.time, counts);
    }

    /// Every body that may touch this one before either of them crosses a cell wall; valid until the next call.
    std::span<const BodyId> neighbours(BodyId body)
    {
        found_.clear();
        std::visit([&](const auto& broad) { broad.neighbours(body, [&](BodyId other) { found_.push_back(other); }); },
                   candidates_);
        return found_;
    }

private:
    void examine(const State& state, BodyId body, Counts& counts)
    {
        const auto slot = static_cast<std::size_t>(body);
        Key best;
        std::uint32_t stamp = 0;
        if (state.flight(body).mode != Mode::fixed) {  // who never moves leaves the asking to the others
            best = first_of_planes<features.gravity>(state, moving(state, body), counts);
            for (const BodyId other : neighbours(body)) offer(state, body, other, best, stamp, counts);
        }
        queue_.set(slot, best);
        partner_stamp_[slot] = stamp;
    }

    /// Take the contact with `other` if it comes before the best one so far.
    void offer(const State& state, BodyId body, BodyId other, Key& best, std::uint32_t& stamp, Counts& counts) const
    {
        const BodyId a = std::min(body, other), b = std::max(body, other);
        ++counts.pair_tests;
        Key key;
        if constexpr (features.gravity) {
            const PairMotion m = pair_motion(state, moving(state, a), moving(state, b));
            const Root root = pair_root(state, m);
            if (root.kind == RootKind::none) return;
            key = {state.frame.after(m.from, root.t), m.swept ? Scheduled::intrusion : Scheduled::pair_impact, a, b};
        } else {
            const UniformPairMotion m = uniform_pair_motion(state, a, b);
            const Root root = sphere_sphere_root(m.r, m.v, m.contact_distance);
            if (root.kind == RootKind::none) return;
            key = {state.frame.after(m.from, root.t), Scheduled::pair_impact, a, b};
        }
        ++counts.root_solves;
        if (!(key < best)) return;
        best = key;
        stamp = state.stamps[static_cast<std::size_t>(other)];
    }

    /// Predict when the body leaves its grid cell; the wall is named by axis and direction.
    void watch_cell(const State& state, BodyId body, const EpochTime& now, Counts& counts)
    {
        const auto* grid = std::get_if<CellGrid>(&candidates_);
        if (!grid) return;
        const Flight f = features.gravity ? filed_path(state, body, now) : uniformly_advanced(state, body, now);
        double soonest = std::numeric_limits<double>::infinity();
        BodyId wall = 0;
        const auto keep = [&](const Root& root, BodyId which) {
            ++counts.root_solves;
            // Starting to fall on the wall itself (pressed) is leaving, too.
            if (root.kind == RootKind::none || !(root.t < soonest)) return;
            soonest = root.t;
            wall = which;
        };
        for (int axis = 0; axis < 3; ++axis) {
            const double v = f.velocity[axis];
            if constexpr (features.gravity) {
                const double g = state.accelerations[f.acceleration][axis];
                if (v < 0 || g < 0)
                    keep(plane_root(grid->above_lower_wall(state.frame, body, axis, f.place), v, g), 2 * axis);
                if (v > 0 || g > 0)
                    keep(plane_root(grid->below_upper_wall(state.frame, body, axis, f.place), -v, -g), 2 * axis + 1);
            } else {
                if (v < 0)
                    keep(uniform_plane_root(grid->above_lower_wall(state.frame, body, axis, f.place), v), 2 * axis);
                if (v > 0)
                    keep(uniform_plane_root(grid->below_upper_wall(state.frame, body, axis, f.place), -v),
                         2 * axis + 1);
            }
        }
        Key leaving;
        if (soonest < std::numeric_limits<double>::infinity())
            leaving = {state.frame.after(now, soonest), Scheduled::cell_crossing, body, wall};
        queue_.set(state.flights.size() + static_cast<std::size_t>(body), leaving);
    }

    Candidates candidates_;
    EventQueue queue_;  ///< slot i: contact of body i; slot count + i: its cell crossing
    std::vector<BodyId> found_;
    std::vector<std::uint32_t> partner_stamp_;  ///< by body: of its contact's partner when it was predicted
};

}  // namespace carom
