/// What the engine cannot resolve it says: a status, names and a time; never a hang, never a wrong answer.
#include "support/scenes.hpp"

#include <catch2/catch.hpp>

#include <array>
#include <cmath>

using namespace carom;
using namespace carom::test;

TEST_CASE("numbers whose squares leave the range of doubles are said so before the run begins")
{
    const auto outcome = [](double radius, double mass, double speed, double offset, bool certified) {
        Scene scene = empty_scene(2, earth);
        add_sphere(scene, radius, {1.125, 0, 1});
        add_sphere(scene, 0.25, {2.5, 0, 1}, {-speed, 0, 0}, mass);
        add_plane(scene, "wall", Vec3::UnitX(), -offset);
        EventDriven method;
        method.certified = certified;
        RunOptions options;
        options.max_events = 100;
        return simulate(scene, method, options);
    };
    for (const bool certified : {false, true}) {
        CHECK(outcome(0.125, 1e4, 1, 1, certified).message == "");
        for (const auto& [radius, mass, speed, offset] : {std::array{0.125, 1e4, 1e300, 1.},
                                                          {5e-324, 1., 1., 1.},
                                                          {0.125, 1e-300, 1., 1.},
                                                          {0.125, 1., 1., 1e300},
                                                          {0.125, 1e100, 1e100, 1.}}) {
            const Outcome out = outcome(radius, mass, speed, offset, certified);
            CAPTURE(radius, mass, speed, offset, out.message);
            CHECK(out.status == Status::unresolved);
            CHECK(out.message.find("range of doubles") != std::string::npos);
            CHECK(out.final.size() == 2);
            CHECK(out.time == 0);
        }
    }
}

TEST_CASE("a wall so far away that its impact is never is no impact of a certified run")
{
    Scene scene = empty_scene(1);
    add_sphere(scene, 0.5, {0, 0, 0}, {1e9, 2, 3});
    add_sphere(scene, 0.5, {2, 0, 0}, {1e9, 2, 3});
    add_plane(scene, "far", -Vec3::UnitX(), -0x1p399);
    EventDriven method;
    method.certified = true;
    const Outcome out = simulate(scene, method);
    CHECK(out.status == Status::reached_end);
    CHECK(out.counts.impacts == 0);
    CHECK(out.final[0].position.x() == Approx(1e9));
}

TEST_CASE("an end or a place that the frame cannot count to is said so; the run does not go on for ever")
{
    RunOptions options;
    Scene ball = empty_scene(1);
    add_sphere(ball, 0.1, {0, 0, 1}, {1e3, 0, 0});
    for (const bool certified : {false, true}) {
        EventDriven method;
        method.certified = certified;
        options.until = 1e12;
        CHECK(simulate(ball, method, options).status == Status::reached_end);
        for (const double until : {1e20, 1e200, 1e301}) {
            options.until = until;
            const Outcome out = simulate(ball, method, options);
            CAPTURE(until, out.message);
            CHECK(out.status == Status::unresolved);
            CHECK(out.time == 0);
        }
        options.until = 1;
        Scene dust = empty_scene(1);
        add_sphere(dust, 0.5, {-2, 0, 0}, {1, 0, 0});
        add_sphere(dust, 1e-48, {0, 0, 0});
        const Outcome out = simulate(dust, method, options);
        CHECK(out.message.find("smallest radius") != std::string::npos);
    }
}

TEST_CASE("an end so late that what falls until then leaves the range of doubles is said so")
{
    Scene scene = empty_scene(1e169, {0, 8, -9.81}, 0.8);
    add_sphere(scene, 0.1, {-1, 0, 1.1});
    add_floor(scene);
    const Outcome out = simulate(scene, EventDriven{});
    CHECK(out.status == Status::unresolved);
    CHECK(out.message.find("range of doubles") != std::string::npos);
}

TEST_CASE("an end is no reason to count times in coarse units: either they are exact or the run does not begin")
{
    for (const bool certified : {false, true}) {
        EventDriven method;
        method.certified = certified;
        RunOptions options;
        options.max_events = 1;
        for (const double end : {1., 1e6, 1e14, 1e20, 1e40, 1e110}) {
            Scene scene = empty_scene(end, earth);
            add_sphere(scene, 0.1, {0, 0, 1.1});
            add_sphere(scene, 0.1, {0, 0, 1.32});
            add_floor(scene);
            const Outcome out = simulate(scene, method, options);
            CAPTURE(certified, end, out.message);
            CHECK((out.status == Status::event_limit) == (end < 1e18));
            if (out.status == Status::event_limit) CHECK(out.time == Approx(std::sqrt(2 / 9.81)).epsilon(1e-12));
            if (out.status == Status::unresolved) CHECK(out.message.find("earlier end") != std::string::npos);
        }
    }
}
