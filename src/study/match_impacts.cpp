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
    std::int64_t expected = 0, left_over = 0, late = 0, found = 0, absorbed = 0;
};

/// Impacts of one pair of a run, in the order of time.
struct PairFound {
    std::vector<FoundImpact> impacts;
    std::vector<double> rests;
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

/// Lets each found impact that is not taken take the first expected one that is neither taken nor further away than
/// `width`. \return how many do up to the horizon
std::int64_t take_within(double width, const PairImpacts& expected, const std::vector<FoundImpact>& found,
                         double horizon, std::vector<bool>& is_matched, std::vector<bool>& is_taken)
{
    std::int64_t count = 0;
    std::size_t first = 0;  // everything before is too early for this and all later found impacts
    for (std::size_t k = 0; k < found.size(); ++k) {
        while (first < is_taken.size() && expected.times[first] < found[k].time - width) ++first;
        if (is_matched[k]) continue;
        for (std::size_t i = first; i < is_taken.size() && expected.times[i] <= found[k].time + width; ++i) {
            if (is_taken[i]) continue;
            is_taken[i] = is_matched[k] = true;
            count += expected.times[i] <= horizon;
            break;
        }
    }
    return count;
}

bool is_near(const PairImpacts& expected, double time, double width)
{
    const auto first = std::lower_bound(expected.times.begin(), expected.times.end(), time - width);
    return first != expected.times.end() && *first <= time + width;
}

std::vector<double> times_of(const std::vector<FoundImpact>& impacts)
{
    std::vector<double> times;
    for (const FoundImpact& each : impacts) times.push_back(each.time);
    return times;
}

PairMatch match_pair(const Pair& pair, const PairImpacts& expected, const PairFound& found, const MatchWindow& window,
                     const IsAbsorbed& is_absorbed)
{
    PairMatch result;
    std::vector<bool> is_taken(expected.times.size(), false), is_matched(found.impacts.size(), false);
    if (window.in_time < window.width)
        take_within(window.in_time, expected, found.impacts, window.horizon, is_matched, is_taken);
    const std::int64_t apart = take_within(window.width, expected, found.impacts, window.horizon, is_matched, is_taken);
    if (window.in_time < window.width) result.late = apart;
    for (std::size_t k = 0; k < found.impacts.size() && found.impacts[k].time <= window.horizon; ++k) {
        const FoundImpact& each = found.impacts[k];
        ++result.found;
        if (is_matched[k] || each.is_slow) continue;
        ++result.left_over;
        if (!is_near(expected, each.time, window.width) && !exempt_at(expected, each.time))
            result.invented.push_back(each.time);
    }
    const std::vector<double> times = times_of(found.impacts);
    for (std::size_t i = 0; i < is_taken.size() && expected.times[i] <= window.horizon; ++i) {
        ++result.expected;
        if (is_taken[i] || closed_by_rest(times, found.rests, window, expected.times[i])) continue;
        if (is_absorbed && is_absorbed(pair, expected.times[i]))
            ++result.absorbed;
        else
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
                          std::span<const FoundImpact> rests, const MatchWindow& window, const IsAbsorbed& is_absorbed)
{
    std::map<Pair, PairFound> by_pair;
    for (const auto& [pair, impacts] : expected) by_pair[pair];
    for (const FoundImpact& each : found) by_pair[{each.a, each.b}].impacts.push_back(each);
    for (const FoundImpact& each : rests) by_pair[{each.a, each.b}].rests.push_back(each.time);

    MatchResult result;
    const PairImpacts nothing;
    for (auto& [pair, own] : by_pair) {
        std::stable_sort(own.impacts.begin(), own.impacts.end(),
                         [](const FoundImpact& x, const FoundImpact& y) { return x.time < y.time; });
        std::sort(own.rests.begin(), own.rests.end());
        const auto known = expected.find(pair);
        const PairMatch match =
            match_pair(pair, known == expected.end() ? nothing : known->second, own, window, is_absorbed);
        result.absorbed += match.absorbed;
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
