#include "study/matching.hpp"

#include "study/tolerances.hpp"

#include <algorithm>
#include <cmath>

namespace carom::study {

namespace {

bool exempt_at(const PairImpacts& pair, double time)
{
    return std::any_of(pair.exempt.begin(), pair.exempt.end(),
                       [&](const TimeSpan& span) { return span.begin <= time && time <= span.end; });
}

struct PairMatch {
    std::vector<double> missed, invented;
    std::int64_t expected = 0, left_over = 0, late = 0, found = 0;
};

/// Whether an own series of the run, closed at one of `rests`, stands for an impact at `time`: the last impact found
/// before that rest is earlier, and the rest is not.
bool closed_by_rest(const std::vector<double>& found, const std::vector<double>& rests, const MatchWindow& window,
                    double time)
{
    if (found.empty()) return false;
    // Later rests follow later impacts: the first one that may do decides.
    const auto rest = std::partition_point(rests.begin(), rests.end(),
                                           [&](double r) { return r + window.width < time || r < found.front(); });
    return rest != rests.end() && *std::prev(std::upper_bound(found.begin(), found.end(), *rest)) < time;
}

PairMatch match_pair(const PairImpacts& expected, const std::vector<double>& found, const std::vector<double>& rests,
                     const MatchWindow& window)
{
    PairMatch result;
    std::vector<bool> taken(expected.times.size(), false);
    std::size_t first = 0;  // everything before is too early for this and all later found impacts
    for (const double time : found) {
        while (first < taken.size() && expected.times[first] < time - window.width) ++first;
        std::size_t candidate = first;
        bool near = false, matched = false;
        for (; candidate < taken.size() && expected.times[candidate] <= time + window.width; ++candidate) {
            near = true;
            if (taken[candidate]) continue;
            taken[candidate] = matched = true;
            result.late += std::abs(expected.times[candidate] - time) > window.in_time &&
                           expected.times[candidate] <= window.horizon;
            break;
        }
        result.found += time <= window.horizon;
        if (!matched && time <= window.horizon) ++result.left_over;
        if (!near && time <= window.horizon && !exempt_at(expected, time)) result.invented.push_back(time);
    }
    for (std::size_t i = 0; i < taken.size() && expected.times[i] <= window.horizon; ++i) {
        ++result.expected;
        if (!taken[i] && !closed_by_rest(found, rests, window, expected.times[i]))
            result.missed.push_back(expected.times[i]);
    }
    return result;
}

/// Keeps the first ones in time, if there are more than `most`.
void shorten(std::vector<ImpactMismatch>& list, std::size_t most)
{
    if (list.size() <= most) return;
    std::sort(list.begin(), list.end(), [](const auto& x, const auto& y) { return x.time < y.time; });
    if (list.size() > max_listed_mismatches) list.resize(max_listed_mismatches);
}

}  // namespace

MatchResult match_impacts(const ExpectedImpacts& expected, std::span<const FoundImpact> found,
                          std::span<const FoundImpact> rests, const MatchWindow& window)
{
    std::map<Pair, std::pair<std::vector<double>, std::vector<double>>> by_pair;
    for (const auto& [pair, impacts] : expected) by_pair[pair];
    for (const FoundImpact& each : found) by_pair[{each.a, each.b}].first.push_back(each.time);
    for (const FoundImpact& each : rests) by_pair[{each.a, each.b}].second.push_back(each.time);

    MatchResult result;
    const PairImpacts nothing;
    for (auto& [pair, times] : by_pair) {
        std::sort(times.first.begin(), times.first.end());
        std::sort(times.second.begin(), times.second.end());
        const auto known = expected.find(pair);
        const PairMatch match =
            match_pair(known == expected.end() ? nothing : known->second, times.first, times.second, window);
        result.expected += match.expected;
        result.late += match.late;
        result.found += match.found;
        result.missed += static_cast<std::int64_t>(match.missed.size());
        result.mistimed += std::min(static_cast<std::int64_t>(match.missed.size()), match.left_over);
        result.invented += static_cast<std::int64_t>(match.invented.size());
        for (const double t : match.missed) result.missed_list.push_back({t, pair.first, pair.second});
        for (const double t : match.invented) result.invented_list.push_back({t, pair.first, pair.second});
        shorten(result.missed_list, mismatches_between_sorts);
        shorten(result.invented_list, mismatches_between_sorts);
    }
    shorten(result.missed_list, 0);
    shorten(result.invented_list, 0);
    return result;
}

}  // namespace carom::study
