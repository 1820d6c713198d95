/// \file
/// Prediction: who meets whom next. One queue slot a body for contacts, and one for leaving its grid cell.
#pragma once

#include "event_driven/candidates.hpp"
#include "event_driven/certified_motion.hpp"
#include "event_driven/predict_planes.hpp"
#include "event_driven/uniform_motion.hpp"
#include "queue/event_queue.hpp"

#include <carom/features.hpp>

#include <algorithm>
#include <limits>
#include <span>

namespace carom {

template <Features features, bool certified = false>
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
          partner_stamp_(state.flights.size(), 0),
          rough_(certified ? state.flights.size() : 0)
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

    /// In certified runs keys are at first times certainly before the contact. Gives the slot the time at which its
    /// event is to be carried out, a pure function of the flights; false if it has that already.
    bool refine(const State& state, const Next& next, Counts& counts)
    {
        if constexpr (certified) {
            if (next.slot >= rough_.size() || !rough_[next.slot].is) return false;
            Rough& rough = rough_[next.slot];
            const Key exact = refined(state, next.key);
            if (rough.runner_up < exact.time) {
                examine<true>(state, static_cast<BodyId>(next.slot), counts);
            } else {
                rough.is = false;
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

    /// Predict a body's next contact and its next cell.
    void flight_changed(const State& state, BodyId body, const EpochTime& now, Counts& counts)
    {
        examine(state, body, counts);
        watch_cell(state, body, now, counts);
    }

    /// The same for many at once: each pair among them is examined once. \param bodies ascending
    void flights_changed(const State& state, std::span<const BodyId> bodies, const EpochTime& now, Counts& counts)
    {
        for (std::size_t i = 0; i < bodies.size(); ++i) {
            examine(state, bodies[i], counts, bodies.first(i));
            watch_cell(state, bodies[i], now, counts);
        }
    }

    /// Carry out a cell crossing: new neighbours may come before the contact known so far.
    void cross(const State& state, const Key& crossing, Counts& counts)
    {
        auto& grid = std::get<CellGrid>(candidates_);
        const int axis = crossing.b / 2, direction = crossing.b % 2 == 0 ? -1 : 1;
        grid.step(crossing.a, axis, direction);
        ++counts.cell_crossings;

        const auto slot = static_cast<std::size_t>(crossing.a);
        Best best{queue_.key(slot), partner_stamp_[slot], certified ? rough_[slot] : Rough{}};
        grid.new_neighbours(crossing.a, axis, direction,
                            [&](BodyId other) { offer<false>(state, crossing.a, other, best, counts); });
        keep(slot, best);
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
    /// Of certified runs: is the slot's time a rough one, and until when can no other contact of its body come?
    struct Rough {
        bool is = false;
        EpochTime runner_up = never;
    };
    /// The earliest contact of a body, so far.
    struct Best {
        Key key;
        std::uint32_t stamp = 0;  ///< of its partner
        Rough rough;

        void take(const Key& other, std::uint32_t its_stamp, bool is_rough)
        {
            const bool first = other < key;
            if constexpr (certified) rough.runner_up = std::min(rough.runner_up, first ? key.time : other.time);
            if (!first) return;
            key = other;
            stamp = its_stamp;
            rough.is = is_rough;
        }
    };

    /// \param asked ascending; of pairs with them they have the contact already
    template <bool exact = false>
    void examine(const State& state, BodyId body, Counts& counts, std::span<const BodyId> asked = {})
    {
        Best best;
        if (state.flight(body).mode != Mode::fixed) {  // who never moves leaves the asking to the others
            if (certified && flies_freely(state.flight(body)))
                offer_planes<exact>(state, body, best, counts);
            else
                best.take(first_of_planes<features.gravity>(state, moving(state, body), counts), 0, false);
            for (const BodyId other : neighbours(body))
                if (asked.empty() || !std::binary_search(asked.begin(), asked.end(), other))
                    offer<exact>(state, body, other, best, counts);
        }
        keep(static_cast<std::size_t>(body), best);
    }

    void keep(std::size_t slot, const Best& best)
    {
        if (best.key != queue_.key(slot)) queue_.set(slot, best.key);
        partner_stamp_[slot] = best.stamp;
        if constexpr (certified) rough_[slot] = best.rough;
    }

    template <bool exact>
    void offer_planes(const State& state, BodyId body, Best& best, Counts& counts) const
    {
        const auto planes = static_cast<int>(state.scene.planes.size());
        counts.pair_tests += planes;
        for (int p = 0; p < planes; ++p) {
            const ContactTime contact = rough_plane_time(state, body, p);
            if (!contact.comes) continue;
            ++counts.root_solves;
            const EpochTime time = exact ? plane_time(state, body, p) : contact.time;
            best.take({time, Scheduled::plane_impact, body, state.scene.plane_body(static_cast<std::size_t>(p))}, 0,
                      !exact);
        }
    }

    static Key refined(const State& state, const Key& key)
    {
        Key exact = key;
        exact.time = key.kind == Scheduled::plane_impact ? plane_time(state, key.a, state.plane_index(key.b))
                                                         : pair_time(state, key.a, key.b);
        return exact;
    }

    /// Take the contact with `other` if it comes before the best one so far.
    template <bool exact>
    void offer(const State& state, BodyId body, BodyId other, Best& best, Counts& counts) const
    {
        const BodyId a = std::min(body, other), b = std::max(body, other);
        ++counts.pair_tests;
        Key key;
        if (certified && is_certifiable(state, a, b)) {
            if (state.contacts.between(a, b)) return;  // it persists
            const ContactTime contact = rough_pair_time(state, a, b);
            if (!contact.comes) return;
            key = {exact ? pair_time(state, a, b) : contact.time, Scheduled::pair_impact, a, b};
        } else if constexpr (features.gravity) {
            const PairMotion m = pair_motion(state, moving(state, a), moving(state, b));
            // Quartics are dear: first what may spare them.
            const bool quartic = m.acceleration_a != m.acceleration_b;
            if (quartic && (state.contacts.between(a, b) || meet_too_late(state, a, b, m, best.key.time))) return;
            const Root root = pair_root(state, m);
            if (root.kind == RootKind::none || (!quartic && state.contacts.between(a, b))) return;
            key = {state.frame.after(m.from, root.t), m.swept ? Scheduled::intrusion : Scheduled::pair_impact, a, b};
        } else {
            const UniformPairMotion m = uniform_pair_motion(state, a, b);
            const Root root = sphere_sphere_root(m.r, m.v, m.contact_distance);
            if (root.kind == RootKind::none || state.contacts.between(a, b)) return;
            key = {state.frame.after(m.from, root.t), Scheduled::pair_impact, a, b};
        }
        ++counts.root_solves;
        best.take(key, state.stamps[static_cast<std::size_t>(other)],
                  !exact && certified && is_certifiable(state, a, b));
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
                if (v < 0 || g < 0) {
                    const double above = grid->above_lower_wall(state.frame, body, axis, f.place);
                    keep(plane_root(above + grid->slack(), v, g), 2 * axis);
                }
                if (v > 0 || g > 0) {
                    const double below = grid->below_upper_wall(state.frame, body, axis, f.place);
                    keep(plane_root(below + grid->slack(), -v, -g), 2 * axis + 1);
                }
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
    std::vector<Rough> rough_;                  ///< by body; empty unless certified
};

}  // namespace carom
