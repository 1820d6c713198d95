/// \file
/// How near one pair comes while neither changes its flight, what that says of its bodies, and the time that each body
/// spent under the worst that was said of its flight.
#pragma once

#include "verify/ball.hpp"
#include "verify/findings.hpp"

#include <utility>

namespace carom::verification {

class Gaps {
public:
    Gaps(const RunData& data, const Flights& flights, Findings& findings);

    /// Two spheres. \pre from < to, in which neither changes its flight
    /// \param is_near quick looks would tell nothing
    void pair(BodyId a, BodyId b, const EpochTime& from, const EpochTime& to, bool is_near);
    /// The whole of a body's flight up to `to`, and a plane.
    void plane(BodyId body, int p, const EpochTime& to);
    /// The flight ends at `now`: its time is counted.
    void count(BodyId body, const EpochTime& now);

    /// Overlaps of the start may go on.
    void note_overlap(BodyId a, BodyId b);
    void note_overlap_with_plane(BodyId body, int p);

    /// Has a numeric piece ended that this body was on? Then it may have been left in an overlap.
    bool was_numeric(BodyId body) const;

    /// Gap so far [cells].
    double smallest() const { return smallest_; }

private:
    double flown(BodyId body, const Ball& ball, const EpochTime& to) const;
    void support(BodyId body, const Path& path, int p, const EpochTime& to);
    /// Meaning of a gap below the promise for those two. \param again examines with another bound
    /// \param gap_at_start how far they were apart then [cells]
    template <class Again, class Start>
    void judge(GapFound& found, BodyId a, BodyId b, double radius, const Again& again, const Start& gap_at_start);
    void judge_numeric(GapFound& found, bool guarded, double radius);
    void record(const GapFound& found, const EpochTime& from, const EpochTime& to, BodyId a, BodyId b);
    void worsen(BodyId body, Grade grade);

    const RunData& data_;
    const Flights& flights_;
    Findings& findings_;
    std::vector<std::uint8_t> grades_;  ///< of the current flights
    std::vector<std::uint8_t> past_;    ///< what persistent contacts and numeric pieces may have left behind
    std::vector<float> flown_before_;   ///< in the flight before: what is missing at an impact is missing after it, too
    double smallest_ = std::numeric_limits<double>::infinity();
    /// Pairs that overlapped at the start, and where they were.
    std::unordered_map<std::uint64_t, std::pair<Path, Path>> overlaps_;
};

/// "sphere 3 and plane 0"
std::string pair_text(const RunData& data, BodyId a, BodyId b);

}  // namespace carom::verification
