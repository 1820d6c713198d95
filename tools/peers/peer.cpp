/// \file
/// Runs a scene with another engine and prints its frames: PEER SCENE [options] > trace.csv
#include "peer.hpp"
#include "serve.hpp"
#include "stepped_run.hpp"

#include "io/frames_csv.hpp"

#include <carom/io.hpp>
#include <carom/metrics.hpp>

#include <cmath>
#include <ctime>
#include <exception>
#include <iostream>
#include <limits>
#include <map>
#include <stdexcept>

namespace carom::peers {

void expect_no_drag(const Scene& scene)
{
    if (scene.drag > 0)
        throw std::invalid_argument("/drag: the engines beside have no linear drag as carom means it (leave it out)");
}

double restitution_of(const Scene& scene, int material)
{
    return scene.materials[static_cast<std::size_t>(material)].restitution;
}

namespace {

constexpr const char* usage =
    "usage: PEER SCENE [--dt H] [--frames FPS] [--until T] [--defaults] [--ccd] [--iterations N] [--reduction P]\n"
    "       PEER --serve [--defaults] [--ccd] [--iterations N] [--reduction P]\n"
    "SCENE is a file or a name of the catalogue; H may be a fraction, 1/240. The trace goes to stdout, what was set\n"
    "and how long it took to stderr. --serve answers requests for runs on stdin, one after the other.\n";

struct Arguments {
    std::string scene;
    std::map<std::string, std::string> values;
    bool has(const std::string& name) const { return values.contains(name); }
    double number(const std::string& name, double otherwise) const
    {
        if (!has(name)) return otherwise;
        const std::string& text = values.at(name);
        const std::size_t slash = text.find('/');
        const double above = std::stod(text.substr(0, slash));
        const double value = slash == std::string::npos ? above : above / std::stod(text.substr(slash + 1));
        if (!(value >= 0)) throw std::invalid_argument(name + ": a number >= 0 is wanted");
        return value;
    }
};

Arguments parsed(int argc, char** argv)
{
    Arguments arguments;
    for (int i = 1; i < argc; ++i) {
        const std::string word = argv[i];
        if (word == "--defaults" || word == "--ccd" || word == "--serve")
            arguments.values[word] = "";
        else if (word.starts_with("--") && i + 1 < argc)
            arguments.values[word] = argv[++i];
        else if (arguments.scene.empty() && !word.starts_with("-"))
            arguments.scene = word;
        else
            throw std::invalid_argument(word + ": not understood");
    }
    for (const auto& [name, value] : arguments.values)
        if (name != "--dt" && name != "--frames" && name != "--until" && name != "--defaults" && name != "--ccd" &&
            name != "--iterations" && name != "--reduction" && name != "--serve")
            throw std::invalid_argument(name + ": unknown option");
    if (arguments.scene.empty() != arguments.has("--serve"))
        throw std::invalid_argument("a scene is wanted, or --serve");
    return arguments;
}

/// Steps between frames: frames are states of the engine, never something in between.
int steps_a_frame(double rate, double dt)
{
    const double steps = 1 / (rate * dt), whole = std::round(steps);
    if (whole < 1 || std::abs(steps - whole) > 1e-9 * whole)
        throw std::invalid_argument("--frames: 1 / (FPS * H) must be a whole number of steps");
    return static_cast<int>(whole);
}

Settings settings_of(const Arguments& arguments)
{
    Settings settings;
    settings.dt = arguments.number("--dt", settings.dt);
    settings.defaults = arguments.has("--defaults");
    settings.ccd = arguments.has("--ccd");
    if (arguments.has("--iterations")) settings.iterations = static_cast<int>(arguments.number("--iterations", 0));
    if (arguments.has("--reduction")) settings.reduction = arguments.number("--reduction", 0);
    return settings;
}

void run(const Arguments& arguments)
{
    const Scene scene = read_scene(find_scene(arguments.scene, CAROM_SCENE_DIR));
    expect_no_drag(scene);
    const Settings settings = settings_of(arguments);
    const int every = steps_a_frame(arguments.number("--frames", 1 / settings.dt), settings.dt);
    const double until = arguments.number("--until", scene.end_time);
    const auto steps = static_cast<long long>(std::floor(until / settings.dt * (1 + 1e-12)));

    const std::unique_ptr<Engine> engine = make_engine(scene, settings);
    std::cout << "# " << engine->words() << "\n# scene " << scene.name << ", step " << settings.dt << "\n";
    std::cerr << engine->words() << "; step " << settings.dt << '\n';
    io::FramesCsv frames(std::cout, scene);
    frames.write(0, states_of(*engine, scene.spheres.size()));
    std::clock_t spent = 0;
    for (long long k = 1; k <= steps; ++k) {
        const std::clock_t before = std::clock();
        engine->step();
        spent += std::clock() - before;
        if (k % every == 0)
            frames.write(static_cast<double>(k) * settings.dt, states_of(*engine, scene.spheres.size()));
    }
    const std::vector<BodyState> final = states_of(*engine, scene.spheres.size());
    const double start = total_energy(scene, initial_states(scene));
    std::cerr << "cpu_seconds " << static_cast<double>(spent) / CLOCKS_PER_SEC << "\nenergy " << start << " -> "
              << total_energy(scene, final) << '\n';
    for (std::size_t i = 0; i < std::min<std::size_t>(final.size(), 10); ++i)
        std::cerr << "velocity " << scene.spheres[i].id << ' ' << final[i].velocity.transpose() << '\n';
}

}  // namespace

}  // namespace carom::peers

int main(int argc, char** argv)
{
    for (std::ostream* stream : {&std::cout, &std::cerr}) stream->precision(std::numeric_limits<double>::max_digits10);
    try {
        const carom::peers::Arguments arguments = carom::peers::parsed(argc, argv);
        if (arguments.has("--serve"))
            carom::peers::serve(carom::peers::settings_of(arguments));
        else
            carom::peers::run(arguments);
        return 0;
    } catch (const std::invalid_argument& error) {
        std::cerr << error.what() << '\n' << carom::peers::usage;
        return 2;
    } catch (const std::exception& error) {
        std::cerr << error.what() << '\n';
        return 1;
    }
}
