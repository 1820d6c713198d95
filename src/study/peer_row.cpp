#include "study/peer_row.hpp"

#include "study/clock.hpp"
#include "study/row_errors.hpp"

#include <algorithm>
#include <utility>

namespace carom::study {

namespace {

void put_errors(const RowMeasurer& measurer, const PeerRun& run, CompareRow& row)
{
    const SampleTimes& times = measurer.compared.times;
    RowErrors errors(measurer.scene, measurer.compared.reference, times);
    const std::size_t shown = std::min(run.samples.size(), times.asked.size());
    for (std::size_t moment = 0; moment < shown; ++moment)
        errors.sample(moment, times.asked[moment], run.samples[moment]);
    errors.put_into(row);
    row.max_penetration = row.overlap_left;  // in between nobody has looked
    row.time = shown > 0 ? times.asked[shown - 1] : 0;
    if (run.has_velocities) return;
    row.velocity_rms.reset();
    row.energy_error.reset();
    row.rest_jitter.reset();
    row.series.energy.clear();
    row.series.energy_error.clear();
}

}  // namespace

std::optional<CompareRow> measure_peer(const RowMeasurer& measurer, const Peer& peer, double dt)
{
    const std::function<bool()> keep_going = [&] { return measurer.patience.lasts(); };
    const auto ask = [&] { return peer.run(measurer.scene, dt, measurer.compared.times.asked, keep_going); };
    const double start = wall_seconds();
    const PeerRun run = ask();
    const double first = wall_seconds() - start;
    if (run.status == Status::interrupted) return std::nullopt;

    CompareRow row;
    row.method = peer.name;
    row.dt = dt;
    row.peer_settings = run.settings;
    row.steps = run.steps;
    row.status = run.status;
    row.message = run.message;
    put_errors(measurer, run, row);

    std::vector<double> seconds{run.cpu_seconds};
    while (run.status == Status::reached_end && static_cast<int>(seconds.size()) < measurer.options.repeats &&
           wall_seconds() - start + first <= measurer.options.repeat_seconds) {
        const PeerRun again = ask();
        if (again.status != Status::reached_end) break;
        seconds.push_back(again.cpu_seconds);
    }
    put_times(std::move(seconds), run.cpu_seconds, row);
    return row;
}

}  // namespace carom::study
