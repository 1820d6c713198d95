/// \file
/// carom_generated_scenes [COUNT] [SEED] [--seconds S] [--out DIR] [--only INDEX] [--keep]
///
/// COUNT scenes (40) of the series SEED (1), 2 time units each, at most S seconds (20) each, and a table. What fails is
/// shrunk and written to DIR, if there is one. --only runs one scene and prints what it says; --keep writes scenes as
/// they were drawn. Exit 1 if a target is missed.
#include "generated/generate.hpp"
#include "generated/shrink.hpp"
#include "generated/tally.hpp"
#include "generated/write_scene.hpp"

#include <carom/io.hpp>

#include <cstdio>
#include <cstdlib>
#include <optional>
#include <string_view>

namespace {

using namespace carom::test;

struct Options {
    std::uint64_t count = 40, seed = 1;
    double seconds = 20;
    std::string out;
    std::optional<std::uint64_t> only;
    bool keep = false;
};

std::optional<Options> parse(int argc, char** argv)
{
    Options options;
    int place = 0;
    for (int i = 1; i < argc; ++i) {
        const std::string_view word = argv[i];
        const bool has_value = i + 1 < argc;
        if (word == "--keep")
            options.keep = true;
        else if (word == "--seconds" && has_value)
            options.seconds = std::strtod(argv[++i], nullptr);
        else if (word == "--out" && has_value)
            options.out = argv[++i];
        else if (word == "--only" && has_value)
            options.only = std::strtoull(argv[++i], nullptr, 10);
        else if (word.starts_with("-") || place > 1)
            return {};
        else
            (place++ == 0 ? options.count : options.seed) = std::strtoull(argv[i], nullptr, 10);
    }
    if (options.count == 0 || !(options.seconds > 0)) return {};
    return options;
}

void say(std::uint64_t index, const std::string& kind, const Trial& t, const std::string& wrong)
{
    std::printf(
        "scene %llu (%s): %s at t = %.9g after %.2f s, %lld impacts, busiest %.3g, deepest %.3g r (stated %.3g r): "
        "%s\n",
        static_cast<unsigned long long>(index), kind.c_str(), wrong.empty() ? "fine" : wrong.c_str(), t.time,
        t.cpu_seconds, static_cast<long long>(t.counts.impacts), t.busiest_window, t.penetration, t.stated, t.message);
    std::fflush(stdout);
}

/// Shrunk with a tenth of the time for each try: what takes too long is to be found in less than a minute or two.
carom::Scene shrunk(const carom::Scene& scene, const std::string& wrong, double seconds)
{
    constexpr double tenth = 0.1;
    const auto still_fails = [&](const carom::Scene& s) {  // as it will be when somebody reads the file
        return complaint(run_trial(carom::parse_scene(scene_text(s), s.name), tenth * seconds)) == wrong;
    };
    return still_fails(scene) ? shrink(scene, still_fails) : scene;
}

}  // namespace

int main(int argc, char** argv)
{
    const std::optional<Options> options = parse(argc, argv);
    if (!options) {
        std::fputs("usage: carom_generated_scenes [COUNT] [SEED] [--seconds S] [--out DIR] [--only INDEX] [--keep]\n",
                   stderr);
        return 2;
    }
    Tally tally;
    const std::uint64_t first = options->only.value_or(0), last = options->only ? first + 1 : options->count;
    for (std::uint64_t index = first; index < last; ++index) {
        const GeneratedScene drawn = generate_scene(options->seed, index);
        const Trial trial = run_trial(drawn.scene, options->seconds);
        tally.add(index, drawn.kind, trial);
        const std::string wrong = complaint(trial);
        if (!wrong.empty() || options->only) say(index, drawn.kind, trial, wrong);
        const std::string file = options->out + "/" + drawn.kind + "_" + std::to_string(options->seed) + "_" +
                                 std::to_string(index) + ".json";
        if (options->out.empty()) continue;
        if (options->keep)
            write_scene(drawn.scene, file);
        else if (!wrong.empty())
            write_scene(shrunk(drawn.scene, wrong, options->seconds), file);
    }
    std::fputs(tally.table(options->seconds).c_str(), stdout);
    return tally.targets_met() ? 0 : 1;
}
