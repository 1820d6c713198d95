#include "study/compared_reference.hpp"

#include "study/matching.hpp"
#include "study/tolerances.hpp"

#include <algorithm>

namespace carom::study {

namespace {

/// All impacts of the reference, bounces of series among them as far as a sample can tell them apart, ascending.
std::vector<double> impact_times(const Reference& reference, double interval)
{
    std::vector<double> times;
    for (const auto& [pair, impacts] : expected_impacts(reference, shortest_sampled_flight * interval))
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

/// Samples taken for each that is wanted, so that one run serves wherever the reference ends.
std::size_t spare_samples(const Scene& scene, std::size_t intervals)
{
    const std::size_t states = std::max<std::size_t>(1, scene.spheres.size()) * intervals;
    return std::clamp<std::size_t>(most_reference_states / states, 1, most_spare_samples);
}

/// Those of all samples that are nearest to equal intervals from the first to the last. \pre intervals < samples
void keep_spread(ComparedReference& compared, std::size_t intervals)
{
    Reference& reference = compared.reference;
    const std::size_t last = reference.samples.size() - 1;
    SampleTimes times;
    std::vector<std::vector<BodyState>> samples;
    for (std::size_t k = 0; k <= intervals; ++k) {
        const std::size_t chosen = (2 * k * last + intervals) / (2 * intervals);
        times.grid.push_back(reference.sample_times[chosen]);
        times.sample.push_back(k);
        samples.push_back(std::move(reference.samples[chosen]));
    }
    times.asked = times.grid;
    reference.sample_times = times.grid;
    reference.samples = std::move(samples);
    compared.times = std::move(times);
    compared.until = compared.times.grid.back();
}

}  // namespace

ComparedReference make_compared_reference(const Scene& scene, double until, std::size_t intervals,
                                          const OnProgress& on_progress)
{
    ComparedReference result;
    result.until = until;
    result.times = sample_times(until, intervals * spare_samples(scene, intervals), {});
    result.reference = make_reference(scene, until, result.times.asked, on_progress);
    result.reason = result.reference.reason;
    const bool is_spread = result.reference.samples.size() > intervals;
    if (is_spread) keep_spread(result, intervals);
    if (result.reference.stopped) return result;
    if (result.reference.until <= 0) {  // nothing is compared: the runs show their states all the same
        result.times = sample_times(until, intervals, {});
        return result;
    }
    const double end = is_spread ? result.until : std::min(until, result.reference.until);
    const double interval = end / static_cast<double>(intervals);
    const std::vector<double> impacts = impact_times(result.reference, interval);
    SampleTimes times =
        is_spread ? beside_impacts(result.times.grid, interval, impacts) : sample_times(end, intervals, impacts);
    if (times.asked == result.times.asked) return result;
    result.times = std::move(times);
    result.reference = make_reference(scene, end, result.times.asked, named_again(on_progress));
    result.until = std::min(end, result.reference.until);
    return result;
}

}  // namespace carom::study
