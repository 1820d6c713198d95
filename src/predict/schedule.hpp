/// \file
/// Prediction: the next contact of each body. One queue slot a body for contacts, and one for leaving its grid cell.
/// Three parameters that know nothing of each other, each with a slow exact twin: times of contacts (Kinematics),
/// bodies that may meet (BroadPhase), the first event (Queue).
#pragma once

#include "predict/broad_phase.hpp"
#include "predict/first_contact.hpp"
#include "predict/tracks.hpp"
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
          tracks_(state),
          queue_(static_cast<std::size_t>(state.count()) * (has_cells ? 2 : 1)),
          found_(static_cast<std::size_t>(state.count())),
          predictions_(static_cast<std::size_t>(state.count())),
          runner_up_(Kinematics::is_certified ? predictions_.size() : 0, never)
    {
        for (const Plane& plane : state.scene.planes) planes_.emplace_back(plane, tracks_.origin());
        for (BodyId i = 0; i < state.count(); ++i) predict(state, i, {}, counts);
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
                examine<true>(state, static_cast<BodyId>(next.slot), next.key.time, counts);
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
        examine(state, static_cast<BodyId>(next.slot), next.key.time, counts);
    }

    /// Predicts the next contacts and the next cells of bodies whose flights have just changed, each pair among them
    /// once. \param changes bodies ascending
    void flights_changed(const State& state, std::span<const Change> changes, const EpochTime& now, Counts& counts)
    {
        for (const Change& change : changes) tracks_.follow(state, change.body, now);
        for (std::size_t i = 0; i < changes.size(); ++i)
            predict(state, changes[i].body, now, counts, {changes.first(i), changes.subspan(i + 1)});
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
            Survey survey(state, tracks_, crossing.a, crossing.time);
            candidates_.clear();
            broad_.new_neighbours(crossing.a, axis, direction,
                                  [&](BodyId other) { look_at(state, survey, other, counts); });
            offer_candidates<false>(state, survey, best, counts);
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

    /// See Neighbourhood.
    [[gnu::flatten]] bool is_alone(const State& state, BodyId body, Partner partner, const EpochTime& now) const
    {
        if constexpr (!has_tracks) return false;
        const Survey survey(state, tracks_, body, now);
        if (!survey.own.is_parabola) return false;
        for (std::size_t p = 0; p < planes_.size(); ++p)
            if (partner != Partner::plane(static_cast<int>(p)) && !planes_[p].is_out_of_reach(state, survey.own, 0))
                return false;
        bool alone = true;
        broad_.neighbours(body, [&](BodyId other) {
            alone = alone &&
                    (are_apart(state, survey.own, tracks_[other], survey.age) || partner == Partner::sphere(other));
        });
        return alone;
    }

private:
    static constexpr bool has_cells = BroadPhase::has_cells;
    static constexpr bool has_tracks = !Kinematics::has_drag;

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

    /// A body that looks for its next contact.
    struct Survey {
        Survey(const State& state, const Tracks& tracks, BodyId its_body, const EpochTime& its_now)
            : body(its_body),
              now(its_now),
              age(tracks.age(state.frame, its_now)),
              rounding(wait_rounding *
                       (state.frame.epoch_length + state.frame.between(state.flight(its_body).start, its_now))),
              own(tracks.at(state, its_body, age))
        {
        }
        /// Time from now after which contacts are certainly later than that [time].
        double up_to(const State& state, const EpochTime& time) const
        {
            const double left = state.frame.between(now, time);
            return left + (wait_rounding * std::abs(left) + rounding);
        }

        const BodyId body;
        const EpochTime now;
        const double age;       ///< of the tracks [time]
        const double rounding;  ///< of times of contact [time]
        const Track own;        ///< now
    };
    /// A contact that may come, and the time before which it does not.
    struct Candidate {
        double soonest;  ///< from now [time]
        BodyId other;
    };

    /// Others whose flights changed with that of a body, ascending.
    struct Together {
        std::span<const Change> asked{};    ///< examined just before: their slots have their contacts with the body
        std::span<const Change> waiting{};  ///< not yet examined: their slots have nothing to say

        static bool contains(std::span<const Change> changes, BodyId body)
        {
            const auto at = std::lower_bound(changes.begin(), changes.end(), body,
                                             [](const Change& c, BodyId wanted) { return c.body < wanted; });
            return at != changes.end() && at->body == body;
        }
    };

    void predict(const State& state, BodyId body, const EpochTime& now, Counts& counts, const Together& together = {})
    {
        examine(state, body, now, counts, together);
        watch_cell(state, body, now, counts);
    }

    /// Finds the earliest event of a body.
    template <bool exact = false>
    [[gnu::flatten]] void examine(const State& state, BodyId body, const EpochTime& now, Counts& counts,
                                  const Together& together = {})
    {
        Best best;
        if (!state.is_fixed(body)) {  // a fixed body leaves the asking to the others
            const Survey survey(state, tracks_, body, now);
            candidates_.clear();
            broad_.neighbours(body, [&](BodyId other) { look_at(state, survey, other, counts, together); });
            offer_candidates<exact>(state, survey, best, counts);
            const double time = survey.up_to(state, limit(best));
            offer_planes<Kinematics>(
                state, body, counts, best.key.time,
                [&](const Key& key, bool rough) { take<exact>(state, key, 0, rough, best); },
                [&](int p) {
                    return has_tracks && survey.own.is_parabola &&
                           planes_[static_cast<std::size_t>(p)].is_out_of_reach(state, survey.own, time);
                });
        }
        keep(static_cast<std::size_t>(body), best);
    }

    /// The time after which nothing changes the best event.
    static const EpochTime& limit(const Best& best)
    {
        return Kinematics::is_certified ? best.runner_up : best.key.time;
    }

    /// Makes a candidate of a neighbour, unless its contact with the body certainly never comes, or not before the
    /// neighbour's own next event: then it is found when that one comes, for the neighbour is examined again.
    void look_at(const State& state, const Survey& survey, BodyId other, Counts& counts, const Together& together = {})
    {
        ++counts.pair_tests;
        double soonest = 0;
        if constexpr (has_tracks) {
            const Track& its = tracks_[other];
            if (survey.own.is_parabola && its.is_parabola && survey.own.acceleration == its.acceleration) {
                soonest = soonest_contact<Kinematics::has_gravity>(tracks_[survey.body], its, survey.age,
                                                                   tracks_.least_square());
                if (soonest == std::numeric_limits<double>::infinity()) return;
                if constexpr (!Kinematics::is_certified)
                    if (soonest > survey.up_to(state, queue_.key(static_cast<std::size_t>(other)).time) &&
                        !Together::contains(together.waiting, other))
                        return;
            }
        }
        if (!Together::contains(together.asked, other)) candidates_.push_back({soonest, other});
    }

    /// Asks for the contacts of candidates, soonest first, until no other can come before the best event.
    template <bool exact>
    void offer_candidates(const State& state, const Survey& survey, Best& best, Counts& counts)
    {
        for (auto rest = candidates_.begin(); rest != candidates_.end(); ++rest) {
            std::iter_swap(rest, std::min_element(rest, candidates_.end(), [](const Candidate& a, const Candidate& b) {
                               return a.soonest < b.soonest;
                           }));
            if (rest->soonest > survey.up_to(state, limit(best))) return;
            offer<exact>(state, survey.body, rest->other, best, counts);
        }
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
    Tracks tracks_;
    std::vector<TrackPlane> planes_;
    std::vector<Candidate> candidates_;
    Queue queue_;                          ///< slot i: contact of body i; slot count + i: its cell crossing
    std::vector<BodyId> found_;            ///< room for all bodies
    std::vector<Prediction> predictions_;  ///< by body
    std::vector<EpochTime> runner_up_;     ///< by body, see Best
};

}  // namespace carom
