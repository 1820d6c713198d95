/// \file
/// carom_generated_hashes [COUNT] [SEED] [EVENTS]
///
/// Prints "INDEX KIND, STATUS IMPACTS HASH" of the event run of COUNT scenes (200) of the series SEED (1), plain and
/// certified, each up to EVENTS events (2000): a change of the engine that should change nothing prints the same.
#include "generated/generate.hpp"

#include <carom/simulate.hpp>

#include <cinttypes>
#include <cstdio>
#include <cstdlib>

int main(int argc, char** argv)
{
    const auto number = [&](int place, std::uint64_t fallback) {
        return argc > place ? std::strtoull(argv[place], nullptr, 10) : fallback;
    };
    const std::uint64_t count = number(1, 200), seed = number(2, 1);
    carom::RunOptions options;
    options.max_events = static_cast<std::int64_t>(number(3, 2000));
    for (std::uint64_t index = 0; index < count; ++index) {
        const carom::test::GeneratedScene drawn = carom::test::generate_scene(seed, index);
        for (const bool certified : {false, true}) {
            carom::EventDriven method;
            method.certified = certified;
            const carom::Outcome run = carom::simulate(drawn.scene, method, options);
            std::printf("%" PRIu64 " %s%s, %s %" PRId64 " %016" PRIx64 "\n", index, drawn.kind.c_str(),
                        certified ? " certified" : "", carom::name(run.status), run.counts.impacts, run.event_hash);
            std::fflush(stdout);
        }
    }
}
