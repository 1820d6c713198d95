/// \file
/// Every pair, every time: which pairs are examined when, so that none is left out.
///
/// A pair of flights is examined when the first of the two ends, or when a slab of time does, whichever comes first,
/// from the moment at which both had begun. In a slab each flight is entered in the cells that it may sweep until the
/// slab's end; who does not share a neighbourhood of cells in it cannot touch. Few spheres need no cells and no slabs.
#pragma once

#include "core/patience.hpp"
#include "verify/cells.hpp"
#include "verify/gaps.hpp"
#include "verify/quick_look.hpp"

#include <optional>

namespace carom::verification {

class Coverage {
public:
    Coverage(const RunData& data, const Flights& flights, Findings& findings, Patience& patience, bool all_pairs);

    /// All spheres are on their first flights.
    void begin();
    /// Time goes on to `now`: slabs that end before are examined.
    void advance(const EpochTime& now);
    /// The flight of a body ends now: examine it against everybody, and count its time.
    void close(BodyId body, const EpochTime& now);
    /// The body is on a new flight.
    void open(BodyId body, const EpochTime& now);
    /// The run ends: everybody's flight does.
    void finish(const EpochTime& end);
    /// The examination ends early. \pre there are spheres \return up to when nothing was left out
    EpochTime leave();
    /// A body that several contacts hold must have them, and they must be able to push it as its flight says: exactly
    /// so where the flight begins, and where it ends but for what numeric partners have rolled in their last step.
    enum class Edge { begins, ends };
    void check_support(BodyId body, const EpochTime& now, Edge edge);
    bool was_numeric(BodyId body) const { return gaps_.was_numeric(body); }
    /// Normals, towards the body, of all contacts that are closed now or open by no more than a gap [cells], if its
    /// series is over; of others on their present flights.
    std::vector<Vec3> closed_normals(BodyId body, const EpochTime& now, double gap = 0);

private:
    /// From `from`, or from the later start of the two, if that is later.
    void pair(BodyId a, BodyId b, const EpochTime& from, const EpochTime& to);
    void planes(BodyId body, const EpochTime& to);
    /// Everybody who may touch a body on its way, or more; nobody twice.
    template <class Visit>
    void visit(BodyId body, const EpochTime& from, const EpochTime& to, const Visit& visit);
    void note_step(BodyId body, const EpochTime& now);
    void set_reference(const EpochTime& at);
    /// Squared distance beyond which a pair is of no interest: neither an overlap nor the smallest gap.
    double interesting(double contact) const
    {
        return std::max(0.0, gaps_.smallest() * (gaps_.smallest() + 2 * contact));
    }
    void find_initial_overlaps();

    Box box(BodyId body, const EpochTime& from, const EpochTime& to, double& radius) const;
    EpochTime later(const EpochTime& t, double epochs) const;
    void begin_slab(const EpochTime& at);
    void end_slab(const EpochTime& at);
    void choose_duration();
    void adapt();
    void sort_bodies();

    const RunData& data_;
    const Flights& flights_;
    std::vector<Quick> quick_;
    EpochTime reference_;
    std::size_t opened_ = 0;  ///< flights since the reference
    Findings& findings_;
    Patience& patience_;
    Gaps gaps_;
    bool all_pairs_;
    std::optional<Cells> cells_;
    EpochTime slab_begin_, slab_end_;
    double longest_step_ = 0;  ///< that a numeric piece has taken so far [epochs]
    double slab_ = 1;          ///< duration, a power of two [epochs]
    std::size_t entries_at_begin_ = 0;
    std::vector<BodyId> order_;  ///< bodies, neighbours in space mostly neighbours here: their cells share memory
    std::int64_t slabs_ = 0;
};

}  // namespace carom::verification
