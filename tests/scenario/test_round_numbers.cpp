// Scenes as people write them: places, sizes and walls are round numbers, so that spheres are jammed exactly, meet at
// once, lie on a line, or are just touched in passing. All end, nothing meets without end, and the verifier agrees.
#include "support/recorded.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

using namespace carom;
using namespace carom::test;

namespace {

using Dice = carom::test::Random;

double pick(Dice& dice, std::initializer_list<double> choices)
{
    return choices.begin()[dice.integer(0, static_cast<int>(choices.size()) - 1)];
}

double rounded(double x, double digit)
{
    return digit * std::round(x / digit);
}

double restitution(Dice& dice)
{
    return pick(dice, {0, 0, 0.3, 0.5, 0.5, 0.9});
}

void add_walls(Scene& scene, double x, double y)
{
    add_plane(scene, "left", Vec3::UnitX(), -x);
    add_plane(scene, "right", -Vec3::UnitX(), -x);
    add_plane(scene, "front", Vec3::UnitY(), -y);
    add_plane(scene, "back", -Vec3::UnitY(), -y);
}

/// A shaft just as wide as one to three balls.
Scene shaft(Dice& dice)
{
    Scene scene = empty_scene(1.5, {0, 0, -10}, restitution(dice));
    const double x = 0.1 * dice.integer(1, 3), y = pick(dice, {0.1, 0.125, 0.15, 0.2});
    add_floor(scene);
    add_walls(scene, x, y);
    double z = 0.3;
    for (int n = dice.integer(3, 8); n > 0; --n) {
        add_sphere(scene, 0.1,
                   {rounded(dice.uniform(0.1 - x, x - 0.1), 0.01), rounded(dice.uniform(0.1 - y, y - 0.1), 0.001), z});
        z += pick(dice, {0.2, 0.21, 0.25, 0.3});
    }
    return scene;
}

/// A groove between walls; at 60 degrees three balls are jammed in it.
Scene groove(Dice& dice)
{
    Scene scene = empty_scene(1.5, {0, 0, -10}, restitution(dice));
    const double steep = pick(dice, {1, 0.5, 2, 1.7320508}), y = pick(dice, {0.1, 0.15, 0.175, 0.2});
    add_plane(scene, "left", {steep, 0, 1});
    add_plane(scene, "right", {-steep, 0, 1});
    add_plane(scene, "front", Vec3::UnitY(), -y);
    add_plane(scene, "back", -Vec3::UnitY(), -y);
    for (int n = dice.integer(2, 6), k = 0; k < n; ++k)
        add_sphere(
            scene, 0.1,
            {rounded(dice.uniform(-0.2, 0.2), 0.01), rounded(dice.uniform(0.1 - y, y - 0.1), 0.01), 0.7 + 0.22 * k});
    return scene;
}

/// Balls fall on, between or just past three fixed ones.
Scene bowl(Dice& dice)
{
    Scene scene = empty_scene(1.5, {0, 0, -10}, restitution(dice));
    const double around = pick(dice, {0.15, 0.2, 0.12});
    for (int k = 0; k < 3; ++k) {
        const double angle = 2 * 3.14159265358979 * k / 3;
        add_sphere(scene, 0.1, {around * std::cos(angle), rounded(around * std::sin(angle), 1e-9), 0});
        scene.spheres.back().fixed = true;
    }
    for (int n = dice.integer(1, 5), k = 0; k < n; ++k)
        add_sphere(scene, 0.1, {pick(dice, {0, 0, 0.01, 0.05}), pick(dice, {0, 0, 0.02}), 0.4 + 0.25 * k}, {0, 0, 0},
                   pick(dice, {1, 1, 10, 0.1}));
    add_plane(scene, "floor", Vec3::UnitZ(), -0.1);
    add_walls(scene, 0.4, 0.4);
    return scene;
}

/// A square lattice at rest, hit from the side.
Scene lattice(Dice& dice)
{
    Scene scene = empty_scene(1.5, {0, 0, -10}, restitution(dice));
    const int wide = dice.integer(2, 4), high = dice.integer(1, 3);
    for (int i = 0; i < wide; ++i)
        for (int k = 0; k < high; ++k) add_sphere(scene, 0.1, {0.2 * i, 0, 0.1 + 0.2 * k});
    add_sphere(scene, 0.1, {-1, pick(dice, {0, 0.01, 0.1}), pick(dice, {0.1, 0.2, 0.3})},
               {pick(dice, {1, 3, 10}), 0, 0}, pick(dice, {1, 5}));
    add_floor(scene);
    if (dice.coin()) add_plane(scene, "right", -Vec3::UnitX(), -(0.2 * (wide - 1) + 0.1));
    return scene;
}

/// A row that fills a slot, or nearly, and shears.
Scene row(Dice& dice)
{
    const Vec3 gravities[] = {{10, 0, 0}, {0, 10, 0}, {0, 0, -10}, {7, 0, -7}, {0, 0, 0}};
    Scene scene = empty_scene(1, gravities[dice.integer(0, 4)], restitution(dice));
    const double r = pick(dice, {0.1, 0.125, 0.07});
    const int n = dice.integer(2, 6);
    for (int k = 0; k < n; ++k)
        add_sphere(scene, r, {0, 0, r + 2 * r * k},
                   {pick(dice, {0, 1, -1, 0.1, dice.uniform(-1, 1)}), pick(dice, {0, 0, dice.uniform(-1, 1)}),
                    pick(dice, {0, 0, 0, 0.5, -0.5})},
                   pick(dice, {1, 1, 2, 10}));
    add_floor(scene);
    add_plane(scene, "ceiling", -Vec3::UnitZ(), -(2 * r * n + pick(dice, {0, 0, 0, 1e-9, 1e-7, 1e-5})));
    if (dice.coin()) add_walls(scene, 1, 1);
    return scene;
}

struct Family {
    const char* name;
    Scene (*make)(Dice&);
    int scenes;
};

std::string checked(const Scene& scene, std::int64_t most_events = 20'000)
{
    MemorySource run = recorded(scene);
    if (run.description.end->time != scene.end_time) return "does not end";
    if (run.description.end->events > most_events) return "has too many events";
    const Certificate found = verify(run);
    return found.violations.empty() ? "" : found.violations.front().what;
}

constexpr Family families[] = {
    {"shaft", shaft, 16}, {"groove", groove, 24}, {"bowl", bowl, 24}, {"lattice", lattice, 8}, {"row", row, 80}};

void check_all(std::uint64_t first, int times)
{
    for (const Family& family : families)
        for (int k = 0; k < times * family.scenes; ++k) {
            Dice dice(first + static_cast<std::uint64_t>(k));
            INFO(family.name << ' ' << k);
            CHECK(checked(family.make(dice)) == "");
        }
}

}  // namespace

TEST_CASE("scenes in round numbers end, without impacts without end, and hold", "[round]")
{
    check_all(1, 1);
}

TEST_CASE("what fills a slot and shears has few impacts, and needs no guard", "[round]")
{
    for (std::uint64_t seed = 1; seed <= 200; ++seed) {
        Dice dice(seed);
        const Scene scene = row(dice);
        const Recorded run = record(scene);
        CAPTURE(seed);
        CHECK(run.events.size() < 2000);
        CHECK(run.outcome.counts.guarded == 0);
    }
}

TEST_CASE("whichever method the guard falls back on, what it leaves holds", "[round]")
{
    for (const GuardFallback fallback : {GuardFallback::moreau, GuardFallback::velocity, GuardFallback::pbd}) {
        std::int64_t windows = 0;
        for (std::uint64_t seed = 1; seed <= 8; ++seed) {
            Dice dice(seed);
            Scene scene = shaft(dice);
            scene.guard.impacts = 1;
            scene.guard.fallback = fallback;
            CAPTURE(seed, static_cast<int>(fallback));
            CHECK(checked(scene, 1'000'000) == "");
            windows += record(scene).outcome.counts.guarded;
        }
        CHECK(windows > 20);
    }
}

TEST_CASE("scenes that were hard for an engine of an earlier day hold", "[round]")
{
    struct Hard {
        Scene (*make)(Dice&);
        std::initializer_list<std::uint64_t> seeds;
    };
    const Hard all[] = {{shaft, {1061, 1202, 1249, 1319, 1454, 200126, 200234, 200455}},
                        {groove, {1001, 1148}},
                        {bowl, {1098, 1101, 1147, 1248, 1305, 1414, 1495, 1514, 1600, 1670, 1686, 200077, 200851}},
                        {row, {1125, 3201, 200787, 201119}}};
    for (const Hard& hard : all)
        for (const std::uint64_t seed : hard.seeds) {
            Dice dice(seed);
            CAPTURE(seed);
            CHECK(checked(hard.make(dice)) == "");
        }
}

// Of 10,000 some five are refused: mostly contacts open by a slow rebound that go on to close.
TEST_CASE("so do thirty times as many", "[.round-long]")
{
    check_all(1001, 30);
}
