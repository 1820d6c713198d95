#include "study/compared_reference.hpp"

#include "study/matching.hpp"
#include "study/tolerances.hpp"

#include <algorithm>

namespace carom::study {

namespace {

/// All impacts of the reference, bounces of series among them as far as a sample can tell them apart, ascending.
std::vector<double> impact_times(const Scene& scene, const Reference& reference, double interval)
{
    std::vector<double> times;
    for (const auto& [pair, impacts] : expected_impacts(scene, reference, shortest_sampled_flight * interval))
        times.insert(times.end(), impacts.times.begin(), impacts.times.end());
    std::sort(times.begin(), times.end());
    return times;
}

OnProgress named_again(const OnProgress& on_progress)
{
    if (!on_progress) return {};
    return [&on_progress](Progress now) {
        now.stage += " at its samples";
        now.what += " at its samples";
        return on_progress(now);
    };
}

}  // namespace

ComparedReference make_compared_reference(const Scene& scene, double until, std::size_t intervals,
                                          const OnProgress& on_progress)
{
    ComparedReference result;
    result.asked_for = result.until = until;
    result.times = sample_times(until, intervals, {});
    result.reference = make_reference(scene, until, result.times.asked, on_progress);
    const Reference& reference = result.reference;
    result.reason = reference.reason;
    if (reference.stopped || reference.until <= 0) return result;
    const double end = std::min(until, reference.until), interval = end / static_cast<double>(intervals);
    SampleTimes times = sample_times(end, intervals, impact_times(scene, reference, interval));
    if (times.asked == result.times.asked) return result;
    result.until = end;
    result.times = std::move(times);
    result.reference = make_reference(scene, end, result.times.asked, named_again(on_progress));
    result.until = std::min(end, result.reference.until);
    return result;
}

}  // namespace carom::study
