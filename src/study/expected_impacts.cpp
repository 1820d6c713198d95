#include "core/expect.hpp"
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

/// First of the pair's impacts, at or before the start of `series`, from which on all flights are shorter than
/// `shortest_flight`.
double tail_start(const Reference& reference, const ReferenceSeries& series, double shortest_flight)
{
    const auto& impacts = reference.impacts;
    std::ptrdiff_t current = -1;
    for (std::size_t i = 0; i < impacts.size(); ++i)
        if (impacts[i].a == series.body && impacts[i].b == series.plane && impacts[i].time <= series.start)
            current = static_cast<std::ptrdiff_t>(i);
    double start = series.start;
    while (current >= 0) {
        start = impacts[static_cast<std::size_t>(current)].time;
        const std::ptrdiff_t before = previous_of_body(impacts, current, series.body);
        if (before < 0) break;
        const ReferenceImpact& earlier = impacts[static_cast<std::size_t>(before)];
        const bool same_pair = earlier.a == series.body && earlier.b == series.plane;
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
        PairImpacts& pair = expected[{series.body, series.plane}];
        double begin = series.start;
        if (shortest_flight > 0) {
            const std::vector<double> bounces = expand(series, shortest_flight);
            begin = bounces.empty() ? tail_start(reference, series, shortest_flight) : bounces.back();
            pair.times.insert(pair.times.end(), bounces.begin(), bounces.end());
        }
        // A series that another body broke off ends there; a complete one leaves a contact that lasts.
        double end = broken_off(series) ? series.end + shortest_flight : std::numeric_limits<double>::infinity();
        for (const ReferenceImpact& impact : reference.impacts)
            if (impact.a == series.body && impact.b == series.plane && impact.time > series.end) {
                end = std::min(end, impact.time);
                break;
            }
        // The bounce at which the tail begins, and the impact that ends it, still count.
        std::erase_if(pair.times, [&](double t) { return t > begin && t < end && t <= series.end; });
        pair.exempt.push_back({begin, end});
    }
}

bool persists(const Scene& scene, const BodyState& state, std::size_t sphere, const Plane& plane)
{
    if (state.mode != Mode::sliding && state.mode != Mode::resting) return false;
    return std::abs(plane_gap(plane, scene.spheres[sphere], state.position)) <=
           lasting_contact * scene.spheres[sphere].radius;
}

void add_persistent(const Scene& scene, const Reference& reference, ExpectedImpacts& expected)
{
    CAROM_EXPECT(reference.samples.size() <= reference.sample_times.size());
    const std::size_t n = reference.samples.size();
    for (std::size_t k = 0; k < n; ++k)
        for (std::size_t s = 0; s < scene.spheres.size(); ++s)
            for (std::size_t p = 0; p < scene.planes.size(); ++p) {
                if (!persists(scene, reference.samples[k][s], s, scene.planes[p])) continue;
                const TimeSpan span{k > 0 ? reference.sample_times[k - 1] : 0,
                                    k + 1 < n ? reference.sample_times[k + 1] : reference.until};
                auto& exempt = expected[{static_cast<BodyId>(s), scene.plane_body(p)}].exempt;
                if (!exempt.empty() && span.begin >= exempt.back().begin && span.begin <= exempt.back().end)
                    exempt.back().end = std::max(exempt.back().end, span.end);
                else
                    exempt.push_back(span);
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

ExpectedImpacts expected_impacts(const Scene& scene, const Reference& reference, double shortest_flight)
{
    ExpectedImpacts expected;
    for (const ReferenceImpact& impact : reference.impacts) expected[{impact.a, impact.b}].times.push_back(impact.time);
    add_series(reference, shortest_flight, expected);
    add_persistent(scene, reference, expected);
    for (auto& [pair, impacts] : expected) std::sort(impacts.times.begin(), impacts.times.end());
    add_contacts(reference, shortest_flight, expected);
    return expected;
}

}  // namespace carom::study
