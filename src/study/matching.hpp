/// \file
/// Which impacts of the reference a method found, missed or invented.
#pragma once

#include "reference/reference.hpp"

#include <carom/study.hpp>

#include <functional>
#include <limits>
#include <map>
#include <span>
#include <utility>
#include <vector>

namespace carom::study {

using Pair = std::pair<BodyId, BodyId>;

struct TimeSpan {
    double begin = 0, end = 0;  ///< closed [time]
};

/// Impacts of one pair, as the reference has them.
struct PairImpacts {
    std::vector<double> times;  ///< impacts that a method must find, ascending [time]
    std::vector<TimeSpan>
        exempt;  ///< here nothing is invented: persistent contact, tails of series (whose bounces are not in `times`)
};
using ExpectedImpacts = std::map<Pair, PairImpacts>;

/// The reference's impacts for a method that resolves flights of `shortest_flight` (4 steps; 0 for the event-driven
/// method, for which series stay closed). Series are expanded down to such flights. What is shorter is the tail: it
/// begins at the last bounce that was preceded by a long enough flight, wherever the reference chose to start the
/// series, and it lasts until the pair's next impact after the series. Persistent contacts are exempt, as the
/// reference lists them.
ExpectedImpacts expected_impacts(const Reference& reference, double shortest_flight);

/// An impact or rest of a run, as Event.
struct FoundImpact {
    double time = 0;
    BodyId a = no_body, b = no_body;
    bool is_slow = false;  ///< closing slower than v_c: nobody invents it
};

/// Whether a run took an impact of this pair, at this time, for rest.
using IsAbsorbed = std::function<bool(const Pair&, double)>;

struct MatchWindow {
    double width = 0;    ///< how far apart in time the two may be: 3 steps for discrete methods [time]
    double horizon = 0;  ///< end of the comparison: divergence or end of the reference [time]
    double in_time =
        std::numeric_limits<double>::infinity();  ///< how far apart they are at most to be of one time [time]
};

struct MatchResult {
    std::int64_t expected = 0;  ///< reference impacts up to the horizon that could be missed
    std::int64_t missed = 0, invented = 0;
    std::int64_t mistimed = 0;  ///< of the missed ones, those for which the pair has an impact that nothing else claims
    std::int64_t absorbed = 0;  ///< neither found nor missed: the run took them for rest
    std::int64_t late = 0;      ///< found within the width, but further apart than `in_time`
    std::int64_t found = 0;     ///< impacts of the run up to the horizon
    std::vector<ImpactMismatch> missed_list, invented_list;  ///< in time order, the first `max_listed_mismatches`
};

/// Per pair, in time order, each found impact takes the first reference impact of its pair that is not taken and at
/// most `width` away; those within `in_time` first. Missed: reference impacts up to the horizon that nothing took.
/// Invented: found impacts up to the horizon of a pair that has no reference impact, taken or not, within `width`,
/// outside exempt spans. So a method that spreads one bounce over two steps invents nothing, and one that answers again
/// and again where nothing touches does. Mistimed: as many of a pair's missed impacts as it has found ones left over:
/// they came, but too early or too late. `rests` (event-driven runs) are moments up to which a run closed a series:
/// they stand for the impacts of the pair since its last found one. `is_absorbed` is asked about impacts that would be
/// missed; it may be empty.
MatchResult match_impacts(const ExpectedImpacts& expected, std::span<const FoundImpact> found,
                          std::span<const FoundImpact> rests, const MatchWindow& window,
                          const IsAbsorbed& is_absorbed = {});

}  // namespace carom::study
