#include "support/recorded.hpp"

#include <catch2/catch.hpp>

#include <bit>

using namespace carom;
using namespace carom::test;

TEST_CASE("a flight shifted by 1e-9 is refused", "[verify]")
{
    const MemorySource run = recorded(gas(9, 60, 2, {0, 0, -1}));
    for (const std::size_t i : {3UL, 61UL, run.flights.size() / 2, run.flights.size() - 1})
        for (std::size_t k = 0; k < 3; ++k) {
            MemorySource forged = run;
            forged.flights[i].local[k] += 1e-9;
            CHECK_FALSE(examined(forged).holds());
        }
}

TEST_CASE("a flip in the upper 40 bits of any number of a flight is refused", "[verify]")
{
    Random random(11);
    for (const Scene& scene : {gas(9, 50, 1, {0, 0, -1}), every_mode()}) {
        const MemorySource run = recorded(scene);
        int sizable = 0;
        constexpr int tries = 400;
        for (int i = 0; i < tries; ++i) {
            MemorySource forged = run;
            FlightRecord& f =
                forged.flights[static_cast<std::size_t>(random.uniform(0, static_cast<double>(forged.flights.size())))];
            const auto k = static_cast<std::size_t>(random.uniform(0, 3));
            const int bit = 24 + static_cast<int>(random.uniform(0, 40));
            const int which = static_cast<int>(random.uniform(0, 4));
            double* const number = which == 0   ? &f.local[k]
                                   : which == 1 ? &f.velocity[k]
                                   : which == 2 ? &f.start.offset
                                                : nullptr;
            if (number == nullptr) {
                f.cell[k] ^= std::int64_t{1} << bit;
                CHECK_FALSE(examined(forged).holds());
                continue;
            }
            const double before = *number;
            *number = std::bit_cast<double>(std::bit_cast<std::uint64_t>(before) ^ (std::uint64_t{1} << bit));
            if (*number == before) continue;  // a zero that became the other one
            constexpr double size = 1e-5;     // smaller ones: the change may be one that rounding makes, too
            sizable += std::abs(before) >= size;
            if (!examined(forged).holds()) continue;
            CHECK(std::abs(*number - before) < 1e-14);
            CHECK(std::abs(before) < size);
        }
        CHECK(sizable > tries / 4);
    }
}

TEST_CASE("forged events are refused", "[verify]")
{
    const MemorySource run = recorded(gas(9, 60, 2, {0, 0, -1}));
    REQUIRE(examined(run).holds());
    Random random(12);
    for (int i = 0; i < 30; ++i) {
        const auto at = static_cast<std::size_t>(random.uniform(0, static_cast<double>(run.events.size() - 1)));
        MemorySource deleted = run;
        deleted.events.erase(deleted.events.begin() + static_cast<std::ptrdiff_t>(at));
        for (std::size_t& after : deleted.after) after -= after > at;
        deleted.seal();
        CHECK_FALSE(examined(deleted).holds());

        MemorySource pushed = run;
        pushed.events[at].impulse *= 1 + 1e-9;
        CHECK_FALSE(examined(pushed).holds());  // by its hash, at least
        pushed.events[at].impulse = run.events[at].impulse * (1 + 1e-6);
        pushed.seal();
        CHECK_FALSE(examined(pushed).holds());

        MemorySource swapped = run;
        std::swap(swapped.events[at].at, swapped.events[at + 1].at);
        swapped.seal();
        CHECK_FALSE(examined(swapped).holds());

        MemorySource flights = run;
        const std::size_t f = 60 + at;
        if (flights.flights[f].start != flights.flights[f + 1].start) {
            std::swap(flights.flights[f].start, flights.flights[f + 1].start);
            CHECK_FALSE(examined(flights).holds());
        }
        MemorySource other = run;
        other.events[at].normal = random.in_cube(1).normalized();
        other.seal();
        CHECK_FALSE(examined(other).holds());
    }
}

TEST_CASE("an impulse larger by 1e-9 is refused by physics alone, but where rounding is as large", "[verify]")
{
    const MemorySource run = recorded(gas(9, 60, 2, {0, 0, -1}));
    int refused = 0, tried = 0;
    for (std::size_t i = 0; i < run.events.size(); i += 7) {
        MemorySource forged = run;
        forged.events[i].impulse *= 1 + 1e-9;
        forged.seal();
        refused += !examined(forged).holds();
        ++tried;
    }
    CHECK(refused == tried);
}

TEST_CASE("what a run may not do is told", "[verify]")
{
    const MemorySource run = recorded(gas(9, 60, 2, {0, 0, -1}));
    const auto refused = [&](const auto& forge, const char* why) {
        MemorySource forged = run;
        forge(forged);
        forged.seal();
        const Certificate c = examined(forged);
        INFO(first_violation(c));
        CHECK_FALSE(c.holds());
        CHECK_THAT(first_violation(c), Catch::Matchers::Contains(why));
    };
    refused([](MemorySource& s) { s.description.gravity.z() *= 1.0000001; }, "not gravity");
    refused([](MemorySource& s) { s.description.materials[0].restitution = 0.999999; }, "not that of its contact");
    refused([](MemorySource& s) { s.description.spheres[7].radius *= 1.001; }, "");
    refused([](MemorySource& s) { s.description.spheres[7].mass *= 1.001; }, "");
    refused([](MemorySource& s) { s.description.starts[7].position.x() += 1e-12; }, "where the scene says");
    refused([](MemorySource& s) { s.description.end->time = 1; }, "after the end");
    refused([](MemorySource& s) { s.flights[100].acceleration = 0; }, "not gravity");
    refused([](MemorySource& s) { s.flights[100].mode = Mode::resting; }, "support");
    refused([](MemorySource& s) { s.flights[100].body = 60; }, "nobody");
    refused([](MemorySource& s) { s.flights[100].velocity[0] = std::numeric_limits<double>::quiet_NaN(); }, "range");
}

TEST_CASE("spheres that pass through each other are found, with grid and without", "[verify]")
{
    // Two ghosts among many: no event, flights straight through.
    Scene scene = empty_scene(10);
    for (int i = 0; i < 60; ++i) add_sphere(scene, 0.3, {2.0 * i, 20, 0});
    add_sphere(scene, 0.5, {0, 0, 0}, {1, 0, 0});
    add_sphere(scene, 0.5, {10, 0.9, 0}, {-1, 0, 0});
    MemorySource source = recorded(scene);
    source.events.clear();
    source.flights.resize(scene.spheres.size());
    source.after.assign(scene.spheres.size(), 0);
    source.seal();
    for (const bool all : {false, true}) {
        const Certificate c = examined(source, all);
        CHECK_FALSE(c.holds());
        CHECK(c.violations.front().a == 60);
        CHECK(c.violations.front().b == 61);
        CHECK(c.smallest_gap == Approx(-0.1));
    }
}

TEST_CASE("a run that claims certified flights is held to gaps of 0", "[verify]")
{
    MemorySource source = recorded(gas(9, 60, 2, {0, 0, -1}));
    source.description.certified = true;
    CHECK_FALSE(examined(source).holds());
}

TEST_CASE("one flight too many at the start is a violation, also before anything is covered", "[verify]")
{
    Scene scene = empty_scene(1);
    add_sphere(scene, 1, {0, 0, 0});
    add_sphere(scene, 1, {5, 0, 0});
    MemorySource source = recorded(scene);
    source.flights.push_back(source.flights.back());
    source.after.push_back(0);
    source.seal();
    const Certificate c = examined(source);
    CHECK_FALSE(c.holds());
    CHECK(first_violation(c).find("not one for each sphere") != std::string::npos);
}
