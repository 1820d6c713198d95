/// \file
/// Prints "NAME HASH" of the event run of each scene given, plain and certified: two builds of this program must print
/// the same.
#include <carom/io.hpp>
#include <carom/simulate.hpp>

#include <cinttypes>
#include <cstdio>

int main(int argc, char** argv)
{
    try {
        for (int i = 1; i < argc; ++i) {
            const carom::Scene scene = carom::read_scene(argv[i]);
            for (const bool certified : {false, true}) {
                carom::EventDriven method;
                method.certified = certified;
                carom::RunOptions options;
                // What a build without optimisation can do; piles solve systems at each event.
                const bool lossy = scene.materials[0].restitution < 1 && scene.spheres.size() > 20;
                if (certified || lossy) options.max_events = lossy ? 1000 : 3000;
                const carom::Outcome run = carom::simulate(scene, method, options);
                std::printf("%s%s %s %" PRId64 " impacts %016" PRIx64 "\n", scene.name.c_str(),
                            certified ? ", certified" : "", carom::name(run.status), run.counts.impacts,
                            run.event_hash);
            }
        }
    } catch (const carom::InputError& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 3;
    }
}
