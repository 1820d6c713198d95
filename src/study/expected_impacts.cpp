#include "study/matching.hpp"
#include "study/tolerances.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace carom::study {

namespace {

/// The impact of `body` before number `last` in time order; -1 if there is none.
std::ptrdiff_t previous_of_body(const std::vector<ReferenceImpact>& impacts, std::ptrdiff_t last, BodyId body)
{
    for (std::ptrdiff_t i = last - 1; i >= 0; --i) {
        const ReferenceImpact& impact = impacts[static_cast<std::size_t>(i)];
        if (impact.a == body || impact.b == body) return i;
    }
    return -1;
}

/// The pair as impacts name it.
std::pair<BodyId, BodyId> pair_of(const ReferenceSeries& series)
{
    return std::minmax(series.body, series.plane);
}

/// First of the pair's impacts, at or before the start of `series`, from which on all flights are shorter than
/// `shortest_flight`.
double tail_start(const Reference& reference, const ReferenceSeries& series, double shortest_flight)
{
    const std::pair<BodyId, BodyId> pair = pair_of(series);
    const auto& impacts = reference.impacts;
    std::ptrdiff_t current = -1;
    for (std::size_t i = 0; i < impacts.size(); ++i)
        if (std::pair(impacts[i].a, impacts[i].b) == pair && impacts[i].time <= series.start)
            current = static_cast<std::ptrdiff_t>(i);
    double start = series.start;
    while (current >= 0) {
        start = impacts[static_cast<std::size_t>(current)].time;
        const std::ptrdiff_t before = previous_of_body(impacts, current, series.body);
        if (before < 0) break;
        const ReferenceImpact& earlier = impacts[static_cast<std::size_t>(before)];
        const bool same_pair = std::pair(earlier.a, earlier.b) == pair;
        if (!same_pair || start - earlier.time >= shortest_flight) break;
        current = before;
    }
    return start;
}

/// Times of the bounces of `series` whose flight before is at least `shortest_flight` (formula: reference.hpp).
std::vector<double> expand(const ReferenceSeries& series, double shortest_flight)
{
    std::vector<double> times;
    if (!(shortest_flight > 0) || !(series.gravity > 0) || !(series.restitution < 1)) return times;
    double flight = 2 * series.normal_speed / series.gravity, time = series.start;
    // Ends: flights shrink by restitution < 1, and a flight that time cannot resolve ends it too.
    while (flight >= shortest_flight && time + flight > time && time + flight <= series.end) {
        time += flight;
        times.push_back(time);
        flight *= series.restitution;
    }
    return times;
}

/// Whether the series ended before its Zeno point.
bool broken_off(const ReferenceSeries& series)
{
    const double length = 2 * series.normal_speed / (series.gravity * (1 - series.restitution));
    return series.end < series.start + length * (1 - series_rounding);
}

void add_series(const Reference& reference, double shortest_flight, ExpectedImpacts& expected)
{
    for (const ReferenceSeries& series : reference.series) {
        PairImpacts& pair = expected[pair_of(series)];
        double begin = series.start;
        if (shortest_flight > 0) {
            const std::vector<double> bounces = expand(series, shortest_flight);
            begin = bounces.empty() ? tail_start(reference, series, shortest_flight) : bounces.back();
            pair.times.insert(pair.times.end(), bounces.begin(), bounces.end());
        }
        // A series that another body broke off ends there; a complete one leaves a contact that lasts.
        double end = broken_off(series) ? series.end + shortest_flight : std::numeric_limits<double>::infinity();
        for (const ReferenceImpact& impact : reference.impacts)
            if (std::pair(impact.a, impact.b) == pair_of(series) && impact.time > series.end) {
                end = std::min(end, impact.time);
                break;
            }
        // The bounce at which the tail begins, and the impact that ends it, still count.
        std::erase_if(pair.times, [&](double t) { return t > begin && t < end && t <= series.end; });
        pair.exempt.push_back({begin, end});
    }
}

/// Exempts contacts that persist, and before them the bounces that led to them once their flights were shorter than
/// `shortest_flight`. \pre times are sorted
void add_contacts(const Reference& reference, double shortest_flight, ExpectedImpacts& expected)
{
    for (const ReferenceContact& contact : reference.contacts) {
        PairImpacts& pair = expected[{contact.a, contact.b}];
        const auto after = std::upper_bound(pair.times.begin(), pair.times.end(), contact.begin);
        auto first = after;
        double begin = contact.begin;
        while (first != pair.times.begin() && begin - *std::prev(first) < shortest_flight) begin = *--first;
        // The bounce at which the tail begins still counts.
        pair.times.erase(first == after ? after : std::next(first), after);
        pair.exempt.push_back({begin, contact.end});
    }
}

}  // namespace

ExpectedImpacts expected_impacts(const Reference& reference, double shortest_flight)
{
    ExpectedImpacts expected;
    for (const ReferenceImpact& impact : reference.impacts) expected[{impact.a, impact.b}].times.push_back(impact.time);
    add_series(reference, shortest_flight, expected);
    for (auto& [pair, impacts] : expected) std::sort(impacts.times.begin(), impacts.times.end());
    add_contacts(reference, shortest_flight, expected);
    return expected;
}

}  // namespace carom::study
