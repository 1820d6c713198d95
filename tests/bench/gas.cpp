/// \file
/// One run of a gas of equal elastic spheres in a box with six walls, to be counted by callgrind: `carom_gas N PHI
/// IMPACTS [SEARCH] [GRAVITY]`. Prints what each impact took. Two lengths of a run, one from another, leave the start
/// and the melting of the lattice out (some 20 impacts a sphere); tests/bench/gas.sh makes the table.
#include "support/random.hpp"

#include <carom/simulate.hpp>

#include <sys/resource.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string_view>

namespace {

/// Spheres of radius 1/2 on the sites of a cubic lattice that fills the box, with velocities that are not along it.
carom::Scene gas(int count, double fraction, double gravity)
{
    carom::Scene scene;
    scene.gravity = {0, 0, -gravity};
    scene.end_time = 1e3;
    const int side = static_cast<int>(std::ceil(std::cbrt(count) - 1e-9));
    const double length = std::cbrt(count * M_PI / 6 / fraction), spacing = length / side;
    carom::test::Random random(1);
    for (int i = 0; i < count; ++i) {
        carom::Sphere s;
        s.id = std::to_string(i);
        s.radius = 0.5;
        s.mass = 1;
        s.position = spacing * carom::Vec3(i % side + 0.5, i / side % side + 0.5, i / (side * side) + 0.5);
        s.velocity = random.in_cube(1);
        scene.spheres.push_back(s);
    }
    for (int axis = 0; axis < 3; ++axis)
        for (const double sign : {1.0, -1.0}) {
            carom::Plane p;
            p.id = std::to_string(scene.planes.size());
            p.normal = sign * carom::Vec3::Unit(axis);
            p.offset = sign > 0 ? 0 : -length;
            scene.planes.push_back(p);
        }
    return scene;
}

carom::BroadPhase search(std::string_view word)
{
    if (word == "automatic") return carom::BroadPhase::automatic;
    if (word == "all_pairs") return carom::BroadPhase::all_pairs;
    if (word == "cell_grid") return carom::BroadPhase::cell_grid;
    if (word == "neighbour_lists") return carom::BroadPhase::neighbour_lists;
    std::fprintf(stderr, "carom_gas: no search %s\n", std::string(word).c_str());
    std::exit(2);
}

/// Most memory that the process has had so far [bytes].
double peak_memory()
{
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return 1024 * static_cast<double>(usage.ru_maxrss);
}

}  // namespace

int main(int argc, char** argv)
{
    if (argc < 4) {
        std::fprintf(stderr, "usage: carom_gas N PHI IMPACTS [SEARCH] [GRAVITY]\n");
        return 2;
    }
    const carom::Scene scene = gas(std::atoi(argv[1]), std::atof(argv[2]), argc > 5 ? std::atof(argv[5]) : 0);
    carom::RunOptions options;
    options.max_events = std::atoll(argv[3]);
    const double before = peak_memory();
    const carom::Outcome run =
        carom::simulate(scene, carom::EventDriven{.broad_phase = search(argc > 4 ? argv[4] : "automatic")}, options);
    const carom::Counts& c = run.counts;
    const auto each = [&](std::int64_t n) { return static_cast<double>(n) / static_cast<double>(c.impacts); };
    std::printf(
        "%lld impacts to t = %.6g, hash %016llx; an impact: %.2f pair tests, %.3f roots, %.3f stale, "
        "%.3f crossings, %.3f rebuilds; a sphere: %.0f bytes\n",
        static_cast<long long>(c.impacts), run.time, static_cast<unsigned long long>(run.event_hash),
        each(c.pair_tests), each(c.root_solves), each(c.stale), each(c.cell_crossings), each(c.list_rebuilds),
        (peak_memory() - before) / static_cast<double>(scene.spheres.size()));
}
