/// \file
/// Prediction: the next event of each body, in one slot of the queue: a contact, or leaving what the broad phase knows.
/// Three parameters that know nothing of each other, each with a slow exact twin: times of contacts (Kinematics),
/// bodies that may meet (BroadPhase), the first event (Queue).
#pragma once

#include "motion/window_piece.hpp"
#include "predict/broad_phase.hpp"
#include "predict/first_contact.hpp"
#include "predict/leaving.hpp"
#include "queue/event_queue.hpp"

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
        : tracks_(state),
          broad_(make_broad_phase<BroadPhase>(state, tracks_.origin())),
          queue_(static_cast<std::size_t>(state.count())),
          found_(static_cast<std::size_t>(state.count())),
          predictions_(static_cast<std::size_t>(state.count())),
          runner_up_(Kinematics::is_certified ? predictions_.size() : 0, never)
    {
        for (const Plane& plane : state.scene.planes) planes_.emplace_back(plane, tracks_.origin_position());
        if constexpr (has_lists) {
            near_planes_.resize(predictions_.size());
            for (BodyId i = 0; i < state.count(); ++i) find_near_planes(i);
        }
        for (BodyId i = 0; i < state.count(); ++i) examine(state, i, {}, counts);
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
            if (!predictions_[next.slot].rough) return false;
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

    /// Predicts the next contacts and the next cells of bodies whose flights have
    /// just changed, each pair among them once. \param changes bodies ascending
    void flights_changed(const State& state, std::span<const Change> changes, const EpochTime& now, Counts& counts)
    {
        if constexpr (has_tracks)
            for (const Change& change : changes) tracks_.follow(state, change.body, now);
        for (std::size_t i = 0; i < changes.size(); ++i)
            examine(state, changes[i].body, now, counts, {changes.first(i), changes.subspan(i + 1)});
    }

    /// Carries out that a body leaves what the broad phase knows of it.
    void leave(const State& state, const Key& key, Counts& counts)
    {
        if constexpr (has_lists) {
            const Track own = tracks_.at(state, key.a, tracks_.age(state.frame, key.time));
            if (own.is_parabola) {
                const Vec3 place(own.place[0], own.place[1], own.place[2]),
                    v(own.velocity[0], own.velocity[1], own.velocity[2]);
                const double speed = length(v);
                broad_.file(key.a, place + (speed > 0 ? ahead * broad_.escape_radius() / speed : 0) * v);
            } else
                broad_.file(key.a, separation(state.frame, filed_path(state, key.a, key.time).place, broad_.origin()));
            find_near_planes(key.a);
            ++counts.list_rebuilds;
        } else if constexpr (BroadPhase::bodies_leave) {
            broad_.step(key.a, key.b.index / 2, key.b.index % 2 == 0 ? -1 : 1);
            ++counts.cell_crossings;
        }
        examine(state, key.a, key.time, counts);
    }

    /// The bodies that may touch this one before either of them leaves; valid until the next call.
    std::span<const BodyId> neighbours(BodyId body)
    {
        if constexpr (has_lists) {
            return broad_.of(body);
        } else {
            std::size_t count = 0;
            broad_.neighbours(body, [&](BodyId other) { found_[count++] = other; });
            return {found_.data(), count};
        }
    }

    /// See Neighbourhood.
    bool is_alone(const State& state, BodyId body, Partner partner, const EpochTime& now)
    {
        if constexpr (!has_tracks) return false;
        const double age = tracks_.age(state.frame, now);
        const Track own = tracks_.at(state, body, age);
        if (!own.is_parabola) return false;
        for (std::size_t p = 0; p < planes_.size(); ++p)
            if (!is_far(body, p) && partner != Partner::plane(static_cast<int>(p)) &&
                !planes_[p].is_out_of_reach(state, own, 0))
                return false;
        for (const BodyId other : tracks_.in_reach(state, own, age, neighbours(body), left_))
            if (partner != Partner::sphere(other)) return false;
        return true;
    }
    /// As `neighbours`, and all whose surfaces are up to the largest diameter apart.
    std::span<const BodyId> wide_neighbours(BodyId body)
    {
        std::size_t count = 0;
        broad_.wide_neighbours(body, [&](BodyId other) { found_[count++] = other; });
        return {found_.data(), count};
    }

private:
    static constexpr bool has_lists = BroadPhase::has_lists;
    /// Quick looks before the exact kernel is asked. All pairs do without: for few spheres, and as the slow exact twin.
    static constexpr bool has_tracks = BroadPhase::bodies_leave;

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
    /// Others whose flights changed with that of a body, ascending.
    struct Together {
        std::span<const Change> asked{};    ///< examined just before: their slots have
                                            ///< their contacts with the body
        std::span<const Change> waiting{};  ///< not yet examined: their slots have nothing to say

        static bool contains(std::span<const Change> changes, BodyId body)
        {
            const auto at = std::lower_bound(changes.begin(), changes.end(), body,
                                             [](const Change& c, BodyId wanted) { return c.body < wanted; });
            return at != changes.end() && at->body == body;
        }
    };

    /// Finds the earliest event of a body.
    template <bool exact = false>
    [[gnu::flatten]] void examine(const State& state, BodyId body, const EpochTime& now, Counts& counts,
                                  const Together& together = {})
    {
        Best best;
        if constexpr (has_tracks) {
            const Survey survey(state, tracks_, body, now);
            // A fixed body leaves the asking to the others.
            if (!state.is_fixed(body)) look_around<exact>(state, survey, together, best, counts);
            const Key away = leaving<Kinematics>(state, broad_, body, survey.own, now, best.key.time);
            if (away < best.key) {
                best.key = away;
                best.prediction = {};
            }
        } else if (!state.is_fixed(body)) {
            offer_own<exact>(state, body, best, counts, [](int) { return false; });
            const std::span<const BodyId> near = neighbours(body);
            counts.pair_tests += static_cast<std::int64_t>(near.size());
            for (const BodyId other : near)
                if (!Together::contains(together.asked, other)) offer<exact>(state, body, other, best, counts);
        }
        keep(static_cast<std::size_t>(body), best);
    }

    /// Finds the earliest contact of a body by quick looks.
    template <bool exact>
    void look_around(const State& state, const Survey& survey, const Together& together, Best& best, Counts& counts)
    {
        const BodyId body = survey.body;
        const std::span<const BodyId> near = neighbours(body);
        counts.pair_tests += static_cast<std::int64_t>(near.size());
        const std::span<Meeting> meetings =
            tracks_.template meetings<Kinematics::has_gravity>(body, survey.age, near, meetings_);
        offer_meetings<exact>(state, survey, together, meetings, best, counts);
        const double time = survey.up_to(state, limit(best));
        offer_own<exact>(state, body, best, counts, [&](int p) {
            const auto plane = static_cast<std::size_t>(p);
            return is_far(body, plane) ||
                   (survey.own.is_parabola && planes_[plane].is_out_of_reach(state, survey.own, time));
        });
        for (const Meeting& meeting : meetings)
            if (meeting.soonest == Meeting::unknown && !Together::contains(together.asked, meeting.other))
                offer<exact>(state, body, meeting.other, best, counts);
    }

    /// Takes the contacts with planes and the end of the motion, where they come before the best one so far.
    template <bool exact, class OutOfReach>
    void offer_own(const State& state, BodyId body, Best& best, Counts& counts, const OutOfReach& is_out_of_reach)
    {
        offer_planes<Kinematics>(
            state, body, counts, limit(best),
            [&](const Key& key, bool rough) { take<exact>(state, key, 0, rough, best); }, is_out_of_reach);
    }

    /// The time after which nothing changes the best event.
    static const EpochTime& limit(const Best& best)
    {
        return Kinematics::is_certified ? best.runner_up : best.key.time;
    }

    /// Asks for contacts of which the soonest time is known, soonest first, until no other can come before the best
    /// event. One that certainly does not come before its partner's own next event is left out: it is found when that
    /// one comes, for the partner is examined again.
    template <bool exact>
    void offer_meetings(const State& state, const Survey& survey, const Together& together, std::span<Meeting> meetings,
                        Best& best, Counts& counts)
    {
        for (auto rest = meetings.begin(); rest != meetings.end(); ++rest) {
            std::iter_swap(rest, std::min_element(rest, meetings.end(), [](const Meeting& a, const Meeting& b) {
                               return a.soonest < b.soonest;
                           }));
            if (rest->soonest == Meeting::unknown || rest->soonest > survey.up_to(state, limit(best))) return;
            if (Together::contains(together.asked, rest->other)) continue;
            if constexpr (!Kinematics::is_certified)
                if (rest->soonest > 0 &&
                    rest->soonest > survey.up_to(state, queue_.key(static_cast<std::size_t>(rest->other)).time) &&
                    !Together::contains(together.waiting, rest->other))
                    continue;
            offer<exact>(state, survey.body, rest->other, best, counts);
        }
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
        if (state.bodies.some_in_piece() && are_kept_apart(state, body, other)) return;
        const BodyId a = std::min(body, other), b = std::max(body, other);
        const ContactTime contact = Kinematics::pair_time(state, a, b, limit(best));
        if (!contact.comes) return;
        ++counts.root_solves;
        take<exact>(
            state, {contact.time, contact.swept ? Scheduled::intrusion : Scheduled::pair_impact, a, Partner::sphere(b)},
            state.bodies.stamp(other), contact.rough, best);
    }

    /// Notes the planes that a body may touch while it is filed where it is. The
    /// last bit stands for all beyond.
    void find_near_planes(BodyId body)
    {
        std::uint64_t& near = near_planes_[static_cast<std::size_t>(body)];
        near = 0;
        for (std::size_t p = 0; p < planes_.size(); ++p)
            if (planes_[p].is_near(broad_.centre(body), broad_.reach(body))) near |= bit_of(p);
    }
    static std::uint64_t bit_of(std::size_t plane) { return std::uint64_t{1} << std::min<std::size_t>(plane, 63); }
    /// Whether the body certainly does not touch a plane before it leaves.
    bool is_far(BodyId body, std::size_t plane) const
    {
        if constexpr (has_lists)
            return (near_planes_[static_cast<std::size_t>(body)] & bit_of(plane)) == 0;
        else
            return false;
    }

    Tracks tracks_;
    BroadPhase broad_;
    std::vector<TrackPlane> planes_;
    std::vector<std::uint64_t> near_planes_;  ///< by body, a bit for each plane; of lists alone
    std::vector<Meeting> meetings_;           ///< room for those of one body
    Queue queue_;                             ///< slot i: the next event of body i
    std::vector<BodyId> found_;               ///< room for all bodies
    std::vector<BodyId> left_;                ///< of neighbours, by a quick look
    std::vector<Prediction> predictions_;     ///< by body
    std::vector<EpochTime> runner_up_;        ///< by body, see Best
};

}  // namespace carom
