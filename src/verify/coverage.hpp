/// \file
/// Every pair, every time: which pairs are examined when, so that none is left out.
///
/// A pair of flights is examined when the first of the two ends, or when a slab of time does, whichever comes first,
/// from the moment at which both had begun. In a slab each flight is entered in the cells that it may sweep until the
/// slab's end; who does not share a neighbourhood of cells in it cannot touch. Few spheres need no cells and no slabs.
#pragma once

#include "verify/bounces.hpp"
#include "verify/cells.hpp"
#include "verify/findings.hpp"
#include "verify/quick_look.hpp"

#include <optional>

namespace carom::verification {

class Coverage {
public:
    Coverage(const RunData& data, const Flights& flights, Findings& findings, bool all_pairs);

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

private:
    /// A body as pairs see it: a sphere on its flight, or the ball that a series stays in.
    struct Ball {
        const Path* path;
        const Vec3* acceleration;
        double radius;
        bool is_swept;
    };
    Ball ball_of(BodyId body, std::optional<Swept>& room) const;
    double flown(BodyId body, const Ball& ball, const EpochTime& to) const;
    /// From `from`, or from the later start of the two, if that is later.
    void pair(BodyId a, BodyId b, const EpochTime& from, const EpochTime& to);
    void look_closer(BodyId a, BodyId b, const EpochTime& from, const EpochTime& to, bool is_near);
    void set_reference(const EpochTime& at);
    /// What a squared distance must exceed to be of no interest: neither an overlap nor the smallest gap.
    double interesting(double contact) const { return std::max(0.0, smallest_ * (smallest_ + 2 * contact)); }
    void record(const GapFound& found, const EpochTime& from, const EpochTime& to, BodyId a, BodyId b);
    void planes(BodyId body, const EpochTime& to);
    void plane(BodyId body, int p, const EpochTime& to);
    void support(BodyId body, int p, const EpochTime& to);
    void find_initial_overlaps();
    void count(BodyId body, const EpochTime& now);
    void worsen(BodyId body, Grade grade);

    Box box(BodyId body, const EpochTime& from, const EpochTime& to, double& radius) const;
    EpochTime later(const EpochTime& t, double epochs) const;
    void begin_slab(const EpochTime& at);
    void end_slab(const EpochTime& at);
    void choose_duration();
    void adapt();
    void sort_bodies();

    const RunData& data_;
    const Flights& flights_;
    std::vector<std::uint8_t> grades_;  ///< of the current flights
    std::vector<double> flown_before_;  ///< in the flight before: what is missing at an impact is missing after it, too
    std::vector<Quick> quick_;
    EpochTime reference_;
    std::size_t opened_ = 0;                                     ///< flights since the reference
    double smallest_ = std::numeric_limits<double>::infinity();  ///< gap so far [cells]
    Findings& findings_;
    bool all_pairs_;
    std::optional<Cells> cells_;
    EpochTime slab_begin_, slab_end_;
    double slab_ = 1;  ///< duration, a power of two [epochs]
    std::size_t entries_at_begin_ = 0;
    std::vector<BodyId> order_;  ///< bodies, neighbours in space mostly neighbours here: their cells share memory
    std::int64_t slabs_ = 0;
    /// Pairs that overlapped at the start, and where they were.
    std::unordered_map<std::uint64_t, std::pair<Path, Path>> overlaps_;
};

}  // namespace carom::verification
