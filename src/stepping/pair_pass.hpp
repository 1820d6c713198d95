/// \file
/// One pass over all pairs of spheres that tests each where the pairs before it have left the two.
///
/// The result is that of the plain double loop, bit for bit, in time near linear: a pair that did not overlap when the
/// pass began can only do so at its turn because one of the two was moved, so pairs of a sphere are looked for again
/// each time it is: in a list of those near it, made once a pass, or in the grid once some sphere has moved farther
/// than the lists reach. (This project's own.)
#pragma once

#include "stepping/moved_spheres.hpp"
#include "stepping/pass_order.hpp"
#include "stepping/system.hpp"

#include <optional>
#include <span>
#include <vector>

namespace carom::stepping {

class PairPass {
public:
    explicit PairPass(const std::vector<double>& radius) : list_(radius.size()), moved_(radius) {}

    /// Calls correct(contact) for each pair that overlaps at its turn; it may change positions of the two, no others.
    /// \param overlapping all pairs that overlap now, in index order: what Detector::find_pairs found just now
    template <class Correct>
    void run(System& system, const std::vector<Contact>& overlapping, Correct&& correct)
    {
        begin(system, overlapping);
        std::size_t next = 0;
        Visit last;
        for (bool first = true; next < known_.size() || !late_.empty(); first = false) {
            const bool is_late = next == known_.size() || (!late_.empty() && late_.front() < known_[next]);
            const Visit visit = is_late ? pop_late() : known_[next++];
            if (!first && visit == last) continue;  // found twice
            last = visit;
            Bodies& bodies = system.bodies;
            const std::size_t a = index(visit.a), b = index(visit.b);
            if (!overlaps(bodies, a, b)) continue;  // an earlier correction has parted them
            const Gap gap = sphere_gap(bodies.position[a], bodies.position[b], bodies.radius[a] + bodies.radius[b]);
            const Vec3 before_a = bodies.position[a], before_b = bodies.position[b];
            correct(Contact{gap.value, visit.a, visit.b, gap.normal});
            if (bodies.position[a] != before_a) look_again(system, visit.a, visit);
            if (bodies.position[b] != before_b) look_again(system, visit.b, visit);
        }
    }

private:
    static std::size_t index(BodyId body) { return static_cast<std::size_t>(body); }
    static bool overlaps(const Bodies& bodies, std::size_t a, std::size_t b)
    {
        const Vec3 d = bodies.position[a] - bodies.position[b];
        return overlap(d.x(), d.y(), d.z(), bodies.radius[a] + bodies.radius[b]);
    }
    static bool later(const Visit& x, const Visit& y) { return x > y; }

    void begin(System& system, const std::vector<Contact>& overlapping);
    Visit pop_late();
    /// Pairs of sphere i that overlap now and whose turn is still to come.
    void look_again(System& system, BodyId i, const Visit& now);
    void look_at(System& system, BodyId i, BodyId j, const Visit& now);
    /// Spheres that may overlap sphere i while none has moved by more than the margin.
    std::span<const BodyId> neighbours(const System& system, BodyId i);
    /// The end of the lists: some sphere has moved too far.
    void give_up_lists(const System& system);

    std::optional<PassOrder> order_;
    std::vector<Vec3> at_begin_;  ///< positions when the pass began
    std::vector<Visit> known_;    ///< overlapping when the pass began, in the order of the pass
    std::vector<Visit> late_;     ///< overlapping since: a heap, the next one in front

    struct List {
        std::size_t begin = 0, end = 0;  ///< in listed_
        bool is_made = false;
    };
    bool lists_hold_ = true;       ///< no sphere has moved by more than the margin in this pass
    double margin_ = 0;            ///< [length]
    std::vector<List> list_;       ///< of each sphere
    std::vector<BodyId> touched_;  ///< spheres with a list
    std::vector<BodyId> listed_;
    MovedSpheres moved_;  ///< once the lists do not hold
};

}  // namespace carom::stepping
