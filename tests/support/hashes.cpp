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
                if (certified && scene.drag > 0) continue;  // refused
                if (certified) options.max_events = 3000;   // what a build without optimisation can do
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
