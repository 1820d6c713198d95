#include "cli/tunnel_settings.hpp"

#include "cli/exit_codes.hpp"
#include "cli/peer_rows.hpp"
#include "core/names.hpp"
#include "peers/peers.hpp"
#include "tunnel/peers.hpp"
#include "tunnel/scene_throws.hpp"

#include <carom/error.hpp>

#include <fmt/format.h>

#include <algorithm>

namespace carom::cli {

namespace {

std::vector<tunnel::Peers> all_peers()
{
    return {tunnel::fcl_peers(), tunnel::libccd_peers()};
}

bool contains(const std::vector<std::string>& words, const std::string& word)
{
    return std::find(words.begin(), words.end(), word) != words.end();
}

tunnel::Matrix matrix_of(const Choices& choices)
{
    tunnel::Matrix matrix;
    matrix.speed = choices.numbers("speed", matrix.speed);
    matrix.thickness = choices.numbers_from_zero("thickness", matrix.thickness);
    matrix.radius = choices.numbers("radius", matrix.radius);
    matrix.dt = choices.numbers("dt", matrix.dt);
    matrix.trials = choices.integer("trials", matrix.trials);
    matrix.offsets = choices.numbers_from_zero("offset", matrix.offsets);
    for (const double offset : matrix.offsets)
        if (!(offset < 1))
            throw UsageError(
                fmt::format("--offset: {} is no hit (offsets are parts of the sum of the radii, below 1)", offset));
    const std::vector<std::string> known = words_of(tunnel::target_names);
    matrix.targets.clear();
    for (const std::string& word : choices.words("target", known, known, "target"))
        matrix.targets.push_back(*value_named<tunnel::Target>(word, tunnel::target_names));
    return matrix;
}

/// Motions between contacts: both where they differ.
std::vector<Integrator> integrators_of(const Scene& scene)
{
    if (scene.gravity.isZero(0) && scene.drag == 0) return {Integrator::euler};
    return {Integrator::euler, Integrator::parabola};
}

void add_peer(const tunnel::Peers& peers, const std::string& name, bool has_scene, TunnelSettings& settings)
{
    const std::string why = has_scene ? "collision libraries are thrown with in the matrix only" : peers.absent;
    if (!why.empty()) {
        settings.absent.push_back({name, why});
        return;
    }
    for (const tunnel::Contestant& who : peers.contestants)
        if (who.method == name) settings.contestants.push_back(who);
}

/// Searches for critical speeds leave walls out: an option that asks for them says so, or is refused.
void note_walls(TunnelSettings& settings)
{
    const std::vector<tunnel::Target>& targets = settings.matrix.targets;
    const auto walls = std::count(targets.begin(), targets.end(), tunnel::Target::wall);
    if (walls == 0) return;
    if (walls == static_cast<std::ptrdiff_t>(targets.size()))
        throw UsageError(
            "--bisect: nothing is behind a wall, so that no speed is critical (add plate or sphere to "
            "--target, or leave --bisect out)");
    settings.absent.push_back({"critical speeds at walls", "nothing is behind one"});
}

void add_engine(const std::string& name, const std::function<bool()>& keep_going, TunnelSettings& settings)
{
    if (const auto program = peers::program_of(name))
        settings.contestants.push_back(peers::peer_contestant(name, *program, keep_going));
    else
        settings.absent.push_back({name, peers::how_to_get(name)});
}

void add_methods(const Choices& choices, const Scene& scene, const std::string& file,
                 const std::function<bool()>& keep_going, TunnelSettings& settings)
{
    const bool has_scene = !file.empty();
    std::vector<std::string> usual = method_names();
    const std::vector<tunnel::Peers> libraries = all_peers();
    for (const tunnel::Peers& each : libraries) usual.insert(usual.end(), each.names.begin(), each.names.end());
    std::vector<std::string> known = usual;  // engines are slow, so that they come when they are called
    known.insert(known.end(), peers::peer_names().begin(), peers::peer_names().end());
    const std::vector<std::string> wanted = choices.words("methods", usual, known, "method");
    for (const std::string& method : method_names()) {
        if (!contains(wanted, method)) continue;
        if (has_scene && method == method_names().front()) {
            settings.absent.push_back({method, "its run is the truth of a scene"});
            continue;
        }
        for (const Integrator integrator : integrators_of(scene)) {
            StepOptions step;
            step.integrator = integrator;
            step.seed = settings.matrix.seed;
            settings.contestants.push_back(tunnel::contestant(method, step));
            if (settings.contestants.back().is_exact) break;
        }
    }
    if (has_scene && !choices.has("methods")) return;  // nobody asked for libraries
    for (const std::string& name : peers::peer_names()) {
        if (!contains(wanted, name)) continue;
        expect_peers_know(scene, file);
        add_engine(name, keep_going, settings);
    }
    for (const tunnel::Peers& each : libraries)
        for (const std::string& name : each.names)
            if (contains(wanted, name)) add_peer(each, name, has_scene, settings);
}

}  // namespace

TunnelSettings tunnel_settings(const TunnelArguments& args, const GlobalArguments& global, const Scene& scene,
                               const std::string& file, const std::function<bool()>& keep_going)
{
    const bool has_scene = !file.empty();
    const Choices choices(args.given, scene.tunnel, file + ": /tunnel");
    choices.expect_known(
        {"speed", "thickness", "radius", "dt", "target", "offset", "methods", "trials", "bisect", "max_seconds"});
    if (has_scene)
        for (const char* option : {"thickness", "radius", "target", "offset"})
            if (args.given.contains(option))
                throw UsageError(
                    fmt::format("--{}: the scene gives the bodies (leave the option out, or the scene)", option));
    if (!has_scene && !args.set.empty())
        throw UsageError("--set: there is no scene to change (name one: carom tunnel SCENE --set ...)");
    if (has_scene && !tunnel::some_body_moves(scene))
        throw InputError({file +
                          ": /spheres: none of them moves at the start, and tunnel scales the speed of the fastest "
                          "(give one a velocity)"});
    TunnelSettings settings;
    settings.matrix = matrix_of(choices);
    settings.matrix.seed = global.seed.value_or(scene.seed);
    settings.bisect = choices.flag("bisect");
    if (settings.bisect && choices.has("target")) note_walls(settings);
    settings.max_seconds = choices.number("max_seconds", settings.max_seconds);
    add_methods(choices, scene, file, keep_going, settings);
    return settings;
}

}  // namespace carom::cli
