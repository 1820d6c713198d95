/// \file
/// Prediction: the next contact of each body. One queue slot a body for contacts, and one for leaving its grid cell.
/// Three parameters that know nothing of each other, each with a slow exact twin: times of contacts (Kinematics),
/// bodies that may meet (BroadPhase), the first event (Queue).
#pragma once

#include "motion/window_piece.hpp"
#include "predict/broad_phase.hpp"
#include "predict/first_contact.hpp"
#include "queue/event_queue.hpp"
#include "toi/damped_plane.hpp"

#include <algorithm>
#include <limits>
#include <span>

namespace carom {

template <class Kinematics, class BroadPhase, class Queue = EventQueue>
class Schedule {
public:
    struct Next {
        std::size_t slot;
        Key key;
    };

    /// \post every body has been examined
    Schedule(const State& state, Counts& counts)
        : broad_(make_broad_phase<BroadPhase>(state)),
          queue_(static_cast<std::size_t>(state.count()) * (has_cells ? 2 : 1)),
          found_(static_cast<std::size_t>(state.count())),
          predictions_(static_cast<std::size_t>(state.count())),
          runner_up_(Kinematics::is_certified ? predictions_.size() : 0, never)
    {
        for (BodyId i = 0; i < state.count(); ++i) flight_changed(state, i, {}, counts);
    }

    Next next() const { return {queue_.first(), queue_.key(queue_.first())}; }

    /// Whether the flight of the partner has changed since the event was predicted.
    bool is_stale(const State& state, const Next& next) const
    {
        const Key& key = next.key;
        if (key.kind != Scheduled::pair_impact && key.kind != Scheduled::intrusion) return false;
        if (!key.b.is_sphere()) return false;
        const auto owner = static_cast<BodyId>(next.slot);
        const BodyId partner = key.a == owner ? key.b.index : key.a;
        return predictions_[next.slot].stamp != state.bodies.stamp(partner);
    }

    /// Keys may at first be times certainly before the contact. Gives the slot the time at which its event is to be
    /// carried out, a pure function of the flights; false if it has that already.
    bool refine(const State& state, const Next& next, Counts& counts)
    {
        if constexpr (Kinematics::is_certified) {
            if (next.slot >= predictions_.size() || !predictions_[next.slot].rough) return false;
            Prediction& prediction = predictions_[next.slot];
            Key exact = next.key;
            exact.time = Kinematics::exact_time(state, exact.a, exact.b);
            if (runner_up_[next.slot] < exact.time) {
                examine<true>(state, static_cast<BodyId>(next.slot), counts);
            } else {
                prediction.rough = false;
                queue_.set(next.slot, exact);
            }
            return true;
        }
        return false;
    }

    void predict_again(const State& state, const Next& next, Counts& counts)
    {
        ++counts.stale;
        examine(state, static_cast<BodyId>(next.slot), counts);
    }

    /// Predicts a body's next contact and its next cell.
    void flight_changed(const State& state, BodyId body, const EpochTime& now, Counts& counts)
    {
        examine(state, body, counts);
        watch_cell(state, body, now, counts);
    }

    /// The same for many at once: each pair among them is examined once. \param changes bodies ascending
    void flights_changed(const State& state, std::span<const Change> changes, const EpochTime& now, Counts& counts)
    {
        for (std::size_t i = 0; i < changes.size(); ++i) {
            examine(state, changes[i].body, counts, changes.first(i));
            watch_cell(state, changes[i].body, now, counts);
        }
    }

    /// Carries out a cell crossing: new neighbours may come before the contact known so far.
    [[gnu::flatten]] void cross(const State& state, const Key& crossing, Counts& counts)
    {
        if constexpr (has_cells) {
            const int axis = crossing.b.index / 2, direction = crossing.b.index % 2 == 0 ? -1 : 1;
            broad_.step(crossing.a, axis, direction);
            ++counts.cell_crossings;

            const auto slot = static_cast<std::size_t>(crossing.a);
            Best best{queue_.key(slot), predictions_[slot], Kinematics::is_certified ? runner_up_[slot] : never};
            const bool some_in_piece = state.bodies.some_in_piece();
            broad_.new_neighbours(crossing.a, axis, direction, [&](BodyId other) {
                if (!some_in_piece || !are_kept_apart(state, crossing.a, other))
                    offer<false>(state, crossing.a, other, best, counts);
            });
            keep(slot, best);
            watch_cell(state, crossing.a, crossing.time, counts);
        }
    }

    /// The bodies that may touch this one before either of them crosses a cell wall; valid until the next call.
    std::span<const BodyId> neighbours(BodyId body)
    {
        std::size_t count = 0;
        broad_.neighbours(body, [&](BodyId other) { found_[count++] = other; });
        return {found_.data(), count};
    }
    /// The same, and all whose surfaces are up to the largest diameter apart.
    std::span<const BodyId> wide_neighbours(BodyId body)
    {
        std::size_t count = 0;
        broad_.wide_neighbours(body, [&](BodyId other) { found_[count++] = other; });
        return {found_.data(), count};
    }

private:
    static constexpr bool has_cells = BroadPhase::has_cells;

    /// The prediction of a slot's event, beside its key.
    struct Prediction {
        std::uint32_t stamp = 0;  ///< of the partner when it was predicted
        bool rough = false;       ///< the time is one before the contact, not that of the contact
    };
    /// The earliest contact of a body, so far.
    struct Best {
        Key key{};
        Prediction prediction{};
        EpochTime runner_up = never;  ///< no other contact comes before; kept by certified runs only

        void take(const Key& other, std::uint32_t its_stamp, bool is_rough)
        {
            const bool first = other < key;
            if constexpr (Kinematics::is_certified) runner_up = std::min(runner_up, first ? key.time : other.time);
            if (!first) return;
            key = other;
            prediction.stamp = its_stamp;
            prediction.rough = is_rough;
        }
    };

    /// Finds the earliest event of a body. \param asked ascending: bodies examined just before, whose slots have their
    /// contacts with this one
    template <bool exact = false>
    [[gnu::flatten]] void examine(const State& state, BodyId body, Counts& counts, std::span<const Change> asked = {})
    {
        Best best;
        if (!state.is_fixed(body)) {  // a fixed body leaves the asking to the others
            offer_planes<Kinematics>(state, body, counts, best.key.time,
                                     [&](const Key& key, bool rough) { take<exact>(state, key, 0, rough, best); });
            const auto was_asked = [&](BodyId other) {
                const auto at = std::lower_bound(asked.begin(), asked.end(), other,
                                                 [](const Change& c, BodyId wanted) { return c.body < wanted; });
                return at != asked.end() && at->body == other;
            };
            const bool some_in_piece = state.bodies.some_in_piece();
            for (const BodyId other : neighbours(body)) {
                if (some_in_piece && are_kept_apart(state, body, other)) continue;
                if (asked.empty() || !was_asked(other)) offer<exact>(state, body, other, best, counts);
            }
        }
        keep(static_cast<std::size_t>(body), best);
    }

    /// Whether a window of a heap keeps two bodies apart: they share it, or one stood still as the other's was taken.
    /// Roots would find the rounding of bodies that touch.
    static bool are_kept_apart(const State& state, BodyId a, BodyId b)
    {
        const bool a_is_in = state.bodies.is_in_heap_window(a), b_is_in = state.bodies.is_in_heap_window(b);
        if (a_is_in && b_is_in) return state.bodies.share_window(a, b);
        if (!a_is_in && !b_is_in) return false;
        const BodyId still = a_is_in ? b : a, other = a_is_in ? a : b;
        const auto* held = state.bodies.as<Held>(still);
        if (!state.is_fixed(still) && !(held && held->rests)) return false;
        const std::vector<BodyId>& known = state.bodies.as<Windowed>(other)->piece->near->bodies;
        return state.flight(still).start <= state.flight(other).start &&
               std::binary_search(known.begin(), known.end(), still);
    }

    void keep(std::size_t slot, const Best& best)
    {
        if (best.key != queue_.key(slot)) queue_.set(slot, best.key);
        predictions_[slot] = best.prediction;
        if constexpr (Kinematics::is_certified) runner_up_[slot] = best.runner_up;
    }

    template <bool exact>
    void take(const State& state, Key key, std::uint32_t stamp, bool rough, Best& best) const
    {
        if constexpr (exact)
            if (rough) key.time = Kinematics::exact_time(state, key.a, key.b);
        best.take(key, stamp, rough && !exact);
    }

    /// Takes the contact with `other` if it comes before the best one so far.
    template <bool exact>
    void offer(const State& state, BodyId body, BodyId other, Best& best, Counts& counts) const
    {
        const BodyId a = std::min(body, other), b = std::max(body, other);
        ++counts.pair_tests;
        const ContactTime contact = Kinematics::pair_time(state, a, b, best.key.time);
        if (!contact.comes) return;
        ++counts.root_solves;
        take<exact>(
            state, {contact.time, contact.swept ? Scheduled::intrusion : Scheduled::pair_impact, a, Partner::sphere(b)},
            state.bodies.stamp(other), contact.rough, best);
    }

    /// Predicts when the body leaves its grid cell.
    void watch_cell(const State& state, BodyId body, const EpochTime& now, Counts& counts)
    {
        if constexpr (has_cells) {
            constexpr bool gravity = Kinematics::has_gravity;
            Flight f;
            if constexpr (gravity) {
                f = filed_path(state, body, now);
            } else {
                const Flight& own = state.flight(body);
                f.velocity = own.velocity;
                f.place = moved(state.frame, own.place, state.frame.between(own.start, now) * own.velocity);
            }
            double soonest = std::numeric_limits<double>::infinity();
            Partner wall;
            const auto keep_wall = [&](const Root& root, int axis, bool upper) {
                ++counts.root_solves;
                // Starting to fall on the wall itself (pressed) is leaving, too.
                if (root.kind == RootKind::none || !(root.t < soonest)) return;
                soonest = root.t;
                wall = Partner::cell_wall(axis, upper);
            };
            for (int axis = 0; axis < 3; ++axis) {
                const double v = f.velocity[axis], g = gravity ? state.acceleration(f)[axis] : 0;
                const double slack = gravity ? broad_.slack() : 0;
                const auto root = [&](double height, double speed, double pull) {
                    if constexpr (Kinematics::has_drag)
                        return damped_plane_root(height + slack, speed, pull, state.drag);
                    else
                        return gravity ? plane_root(height + slack, speed, pull) : uniform_plane_root(height, speed);
                };
                if (v < 0 || g < 0)
                    keep_wall(root(broad_.above_lower_wall(state.frame, body, axis, f.place), v, g), axis, false);
                if (v > 0 || g > 0)
                    keep_wall(root(broad_.below_upper_wall(state.frame, body, axis, f.place), -v, -g), axis, true);
            }
            Key leaving;
            if (soonest < std::numeric_limits<double>::infinity())
                leaving = {state.frame.after(now, soonest), Scheduled::cell_crossing, body, wall};
            queue_.set(static_cast<std::size_t>(state.count() + body), leaving);
        }
    }

    BroadPhase broad_;
    Queue queue_;                          ///< slot i: contact of body i; slot count + i: its cell crossing
    std::vector<BodyId> found_;            ///< room for all bodies
    std::vector<Prediction> predictions_;  ///< by body
    std::vector<EpochTime> runner_up_;     ///< by body, see Best
};

}  // namespace carom
