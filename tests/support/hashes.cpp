/// \file
/// Prints "NAME HASH" of the event run of each scene given: two builds of this program must print the same.
#include <carom/io.hpp>
#include <carom/simulate.hpp>

#include <cinttypes>
#include <cstdio>

int main(int argc, char** argv)
{
    try {
        for (int i = 1; i < argc; ++i) {
            const carom::Scene scene = carom::read_scene(argv[i]);
            const carom::Outcome run = carom::simulate(scene, carom::EventDriven{});
            std::printf("%s %s %" PRId64 " impacts %016" PRIx64 "\n", scene.name.c_str(), carom::name(run.status),
                        run.counts.impacts, run.event_hash);
        }
    } catch (const carom::InputError& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 3;
    }
}
