#include "reference/reference.hpp"

#include "reference/integrator.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace carom {

namespace {

using Low = reference::Decimal<reference::low_digits>;
using High = reference::Decimal<reference::high_digits>;

/// Both runs of one scene, side by side.
struct Twin {
    reference::Integrator<Low> low;
    reference::Integrator<High> high;
    BodyId spheres;

    void advance(double t)
    {
        low.advance(t);
        high.advance(t);
    }

    /// States at time t into `states`. \returns 2 max |x50 - x100| plus what rounding them to double adds [length]
    double sample(double t, std::vector<BodyState>& states)
    {
        High apart2 = 0, far2 = 0;
        for (BodyId i = 0; i < spheres; ++i) {
            const reference::Vector<Low> x50 = low.flight(i).position(t);
            const reference::Flight<High>& f = high.flight(i);
            const reference::Vector<High> x = f.position(t);
            const reference::Vector<High> apart = reference::Vector<High>(High(x50.x), High(x50.y), High(x50.z)) - x;
            apart2 = std::max(apart2, dot(apart, apart));
            far2 = std::max(far2, dot(x, x));
            states.push_back({x.rounded(), f.velocity(t).rounded(), high.mode(i, t)});
        }
        const High bound = 2 * sqrt(apart2) + reference::rounding_of_double * sqrt(far2);
        return std::nextafter(static_cast<double>(bound), std::numeric_limits<double>::infinity());
    }
};

/// The earlier stop of the two runs, if one did.
template <class Run>
void shorten(Reference& reference, const Run& run)
{
    if (!run.stopped() || run.stopped_at() >= reference.until) return;
    const double t = static_cast<double>(run.stopped_at());
    reference.until = run.stopped_at() < t ? std::nextafter(t, 0.0) : t;
    reference.reason = run.reason();
}

}  // namespace

Reference make_reference(const Scene& scene, double until, std::span<const double> sample_times,
                         const OnProgress& on_progress)
{
    Reference result;
    result.kind = scene.spheres.size() == 1 ? Reference::Kind::closed_form : Reference::Kind::multiprecision;
    result.until = until;
    double limit = std::numeric_limits<double>::infinity();
    for (const Sphere& s : scene.spheres) limit = std::min(limit, reference::worst_bound * s.radius);

    Patience patience(on_progress);
    Twin twin{{scene, until, patience}, {scene, until, patience}, static_cast<BodyId>(scene.spheres.size())};
    patience.begin("reference", until, scene.units.time.empty() ? "time units" : scene.units.time);
    double good = 0;
    // The end is looked at like a sample: what lies between the last sample and it is covered by a bound, too.
    for (std::size_t k = 0; k <= sample_times.size(); ++k) {
        const bool end = k == sample_times.size() || sample_times[k] > until;
        const double t = end ? until : sample_times[k];
        twin.advance(t);
        if (!patience.lasts(t)) {
            result.stopped = true;
            result.until = good;
            result.reason = "it was stopped" + reference::at_time(good);
            break;
        }
        shorten(result, twin.low);
        shorten(result, twin.high);
        if (t > result.until) break;
        std::vector<BodyState> states;
        const double bound = twin.sample(t, states);
        if (!(bound <= limit)) {
            result.until = good;
            result.reason = "the bound exceeds 1e-6 of the smallest radius" + reference::at_time(t);
            break;
        }
        good = t;
        if (end) break;
        result.sample_times.push_back(t);
        result.bounds.push_back(bound);
        result.bound = std::max(result.bound, bound);
        result.samples.push_back(std::move(states));
    }
    auto& record = twin.high.record;
    const auto later = [&](double t) { return t > result.until; };
    result.impacts = std::move(record.impacts);
    std::erase_if(result.impacts, [&](const auto& impact) { return later(impact.time); });
    result.series = std::move(record.series);
    std::erase_if(result.series, [&](const auto& series) { return later(series.start); });
    result.contacts = std::move(record.contacts);
    for (const auto& [pair, begin] : record.since)
        result.contacts.push_back({static_cast<double>(begin), result.until, pair.first, pair.second});
    std::erase_if(result.contacts, [&](const auto& contact) { return later(contact.begin); });
    std::sort(result.contacts.begin(), result.contacts.end(),
              [](const auto& a, const auto& b) { return a.begin < b.begin; });
    result.conventions = std::move(record.conventions);
    std::erase_if(result.conventions, [&](const auto& convention) { return later(convention.time); });
    result.root_solves = record.root_solves;
    return result;
}

}  // namespace carom
