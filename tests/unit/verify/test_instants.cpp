// What may happen at one instant beside a plain impact: holds, series that end, numeric pieces that join.
#include "handmade.hpp"

using namespace carom;
using namespace carom::test;

TEST_CASE("a series that another ball ends, so slowly that both rest, is not taken for one that is over", "[verify]")
{
    Scene scene = empty_scene(0.5, {0, 0, -1}, 0.5);
    scene.materials[0].tangential = 0.5;
    scene.rest.closing_speed = 1;
    add_plane(scene, "floor", {0, 0, 1});
    add_sphere(scene, 0.5, {0, 0, 0.5}, {2, 0, 0.0625});
    add_sphere(scene, 0.5, {0.21875, 0, 1.529296875}, {0.5, 0, -0.0625});
    const auto ended_with = [&](double slides) {
        Handmade run(scene);
        for (int i = 0; i < 2; ++i) run.start(Mode::flying);
        run.event(EventKind::impact, 0.125, 0, 2, {0, 0, 1}, {-1, 0, 0.09375});
        FlightRecord& bounces = run.add(0, 0.125, {0.25, 0, 0.5}, {1, 0, 0.03125}, Mode::series, 0);
        bounces.acceleration = 1;
        bounces.series = SeriesRecord{0.03125, 1, 0.5, 0.5, {1, 0, 0}, Vec3::Zero()};
        const double t = 0.1875, x = 0.3125;  // it touches the floor again, and leaves with (0.5, 0, 0.015625)
        run.event(EventKind::impact, t, 0, 1, {0, 0, -1}, {0, 0, -0.25});
        run.event(EventKind::impact, t, 0, 2, {0, 0, 1}, {0, 0, 0.234375});
        run.event(EventKind::rest, t, 0, 1, {0, 0, -1});
        run.event(EventKind::rest, t, 0, 2, {0, 0, 1});
        run.add(0, t, {x, 0, 0.5}, {slides, 0, 0}, Mode::sliding, several_supports);
        run.add(1, t, {x, 0, 1.5}, {slides, 0, 0}, Mode::sliding, several_supports);
        return run.examined();
    };
    CHECK_HOLDS(ended_with(0.5));
    CHECK_REFUSED(ended_with(1), "beside its impulses");
}

TEST_CASE("who rests on a rolling partner may do so until the end of its step, turned by what a step turns", "[verify]")
{
    Scene scene = empty_scene(1, {0, 0, -1});
    add_plane(scene, "floor", {0, 0, 1});
    add_sphere(scene, 0.5, {0, 0, 0.5});
    add_sphere(scene, 0.5, {0, 0, 1.5});
    const auto rolling = [&](double begin, double speed, int steps) {
        scene.spheres[0].position.x() = begin;
        scene.spheres[0].velocity.x() = speed;
        Handmade run(scene);
        run.start(Mode::numeric, several_supports);
        run.start(Mode::resting, several_supports);
        for (int k = 1; k < steps; ++k) {
            const double t = static_cast<double>(k) / steps;
            run.add(0, t, {begin + speed * t, 0, 0.5}, {speed, 0, 0}, Mode::numeric, several_supports);
        }
        return run.examined();
    };
    CHECK_HOLDS(rolling(0, 1e-5, 4));
    CHECK_HOLDS(rolling(0, 1e-3, 1));
    CHECK_REFUSED(rolling(0, 1e-3, 4), "sphere 1 is held by contacts that cannot push it so");
    CHECK_REFUSED(rolling(1e-5, 0, 1), "sphere 1 is held by contacts that cannot push it so");
}

TEST_CASE("an impulse acts at a gap only where the contact has closed a moment ago", "[verify]")
{
    Scene scene = empty_scene(2, Vec3::Zero(), 0.5);
    scene.rest.closing_speed = 0.25;
    scene.rest.window = 0.25;
    const double gap = 0.015;  // less than 0.25 * 0.25 / 4
    add_sphere(scene, 0.5, {-2 - gap, 0, 0}, {1, 0, 0});
    add_sphere(scene, 0.5, {0, 0, 0});
    Handmade run(scene);
    for (int i = 0; i < 2; ++i) run.start(Mode::flying).acceleration = 0;
    run.event(EventKind::impact, 1, 0, 1, {-1, 0, 0}, {-0.75, 0, 0});
    run.add(0, 1, {-1 - gap, 0, 0}, {0.25, 0, 0}, Mode::flying).acceleration = 0;
    run.add(1, 1, {0, 0, 0}, {0.75, 0, 0}, Mode::flying).acceleration = 0;
    CHECK_REFUSED(run.examined(), "is pushed at a gap of 0.015");
}

TEST_CASE("numeric pieces may follow one another at one instant, where others join; flights may not", "[verify]")
{
    Scene scene = empty_scene(2, {0, 0, -1});
    add_sphere(scene, 0.5, {0, 0, 2}, {1, 0, 0});
    add_sphere(scene, 0.5, {0, 0, 1});
    scene.spheres[1].fixed = true;
    const auto twice = [&](Mode mode, int others) {
        Handmade made(scene);
        const bool rolls = mode == Mode::numeric;
        const int support = rolls ? several_supports : -1;
        const Vec3 own = rolls ? Vec3(0, 0, -0.5) : Vec3::Zero();
        made.start(mode, support, own);
        made.start(Mode::fixed);
        const double a = rolls ? 0.5 : 1;
        for (int i = 0; i < 2; ++i) made.add(0, 1, {1, 0, 2 - a / 2}, {1, 0, -a}, mode, support, own);
        for (int i = 0; i < others; ++i) made.add(0, 1, {1, 0, 2 - a / 2}, {1, 0, -a}, mode, support, own);
        return made.examined();
    };
    for (const int others : {0, 8}) {
        CHECK_HOLDS(twice(Mode::numeric, others));
        CHECK_REFUSED(twice(Mode::flying, others), "changes its flight without an event");
    }
}

TEST_CASE("what is held opened slower than v_c, and stays", "[verify]")
{
    const double v_c = 0.25;
    const auto held = [&](double opening, double left) {
        Scene scene = empty_scene(2, Vec3::Zero(), 0.5);
        scene.rest.closing_speed = v_c;
        scene.rest.window = 0.25;
        add_sphere(scene, 0.5, {-1, 0, 0}, {-opening, 0, 0});
        add_sphere(scene, 0.5, {0, 0, 0});
        Handmade run(scene);
        for (int i = 0; i < 2; ++i) run.start(Mode::flying).acceleration = 0;
        run.event(EventKind::settle, 0, 0, 1, {-1, 0, 0}, {(opening - left) / 2, 0, 0});
        const double v0 = -(opening + left) / 2, v1 = -(opening - left) / 2;
        const Mode mode = left == 0 ? Mode::sliding : Mode::flying;
        const int support = left == 0 ? several_supports : -1;
        run.add(0, 0, {-1, 0, 0}, {v0, 0, 0}, mode, support).acceleration = 0;
        run.add(1, 0, {0, 0, 0}, {v1, 0, 0}, mode, support).acceleration = 0;
        return run.examined();
    };
    CHECK_HOLDS(held(0.99 * v_c, 0));
    CHECK_REFUSED(held(1.01 * v_c, 0), "is held though it leaves at 0.25");
    CHECK_REFUSED(held(0.5 * v_c, 0.01 * v_c), "is held and moves on nevertheless");
}
