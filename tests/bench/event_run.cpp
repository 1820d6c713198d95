/// \file
/// Whole event-driven runs of catalogue scenes: time an impact.
#include <carom/io.hpp>
#include <carom/simulate.hpp>

#include <benchmark/benchmark.h>

#include <cstdlib>

namespace {

void event_run(benchmark::State& state, const char* name)
{
    const carom::Scene scene = carom::read_scene(carom::find_scene(name, CAROM_SCENE_DIR));
    std::int64_t impacts = 0;
    for (auto _ : state) {
        const carom::Outcome run = carom::simulate(scene, carom::EventDriven{});
        if (run.status != carom::Status::reached_end) std::abort();
        impacts += run.counts.impacts;
    }
    state.SetItemsProcessed(impacts);
}
BENCHMARK_CAPTURE(event_run, gas_1000, "gas_1000")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(event_run, counting_pi_4, "counting_pi_4")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(event_run, bouncing_ball, "bouncing_ball")->Unit(benchmark::kMicrosecond);

}  // namespace
