/// \file
/// The answer of two bodies to their touch, as far as one interval tells it.
#pragma once

#include "audit/around.hpp"

namespace carom::audit {

enum class Verdict : std::uint8_t {
    waits,     ///< they fly on and overlap
    missed,    ///< they have flown through each other, or overlap for too long
    found,     ///< they turn when they touch
    late,      ///< they turn after they have touched
    early,     ///< they turn before they touch
    several,   ///< they turn, but another contact may have had a part in it
    unsettled  ///< one of them has no flight
};

struct Answer {
    Verdict verdict = Verdict::waits;
    double by = 0;          ///< late, early: >= 0 [time]
    bool at_least = false;  ///< frames do not say more of `by`
    double time = 0;        ///< late, early: of the turn, or of the frame before it [time]
};

/// \param waited intervals before this one without an answer
Answer answer_to(const Scene& scene, const Touch& touch, std::size_t waited, const Interval& interval,
                 const SeenFrame& from, const SeenFrame& to, const Around& around);

/// The change of a sphere from the flight before an interval to the one after it; none if it has none, or one of them
/// is not known.
std::optional<Turn> turn_of(const BodyMotion& motion);

}  // namespace carom::audit
