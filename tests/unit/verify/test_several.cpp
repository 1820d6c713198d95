#include "handmade.hpp"

#include "verify/cone.hpp"

using namespace carom;
using namespace carom::test;

namespace {

Scene tower(int n, double end_time)
{
    Scene scene = empty_scene(end_time, earth, 0.5);
    for (int i = 0; i < n; ++i) add_sphere(scene, 0.5, {0, 0, i + 0.5});
    add_floor(scene);
    return scene;
}

Handmade standing(const Scene& scene)
{
    Handmade run(scene);
    for (std::size_t i = 0; i < scene.spheres.size(); ++i) run.start(Mode::resting, several_supports);
    return run;
}

Scene groove(const Vec3& gravity)
{
    Scene scene = empty_scene(2, gravity);
    add_sphere(scene, 0.1, {0, 0, 0.1 / std::sqrt(0.5)});
    add_plane(scene, "left", {1, 0, 1});
    add_plane(scene, "right", {-1, 0, 1});
    return scene;
}

Scene row_on_a_slope()
{
    Scene scene = empty_scene(2, {1, 0, -8});
    add_floor(scene);
    add_sphere(scene, 0.5, {0, 0, 0.5});
    add_sphere(scene, 0.5, {1, 0, 0.5}, Vec3::Zero(), 3);
    return scene;
}

/// Three touching balls, the first comes in at speed 1 and arrives at t = 1; they leave it with these velocities.
Handmade cradle(const Vec3& after)
{
    Scene scene = empty_scene(2);
    add_sphere(scene, 0.5, {-2, 0, 0}, {1, 0, 0});
    add_sphere(scene, 0.5, {0, 0, 0});
    add_sphere(scene, 0.5, {1, 0, 0});
    Handmade run(scene);
    run.start(Mode::flying).acceleration = 0;
    run.start(Mode::resting, several_supports);
    run.start(Mode::resting, several_supports);
    run.event(EventKind::impact, 1, 0, 1, {-1, 0, 0}, {after.x() - 1, 0, 0});
    run.event(EventKind::impact, 1, 1, 2, {-1, 0, 0}, {-after.z(), 0, 0});
    const bool stays = after.x() == 0 && after.y() == 0;
    if (stays) {
        run.event(EventKind::rest, 1, 0, 1, {-1, 0, 0});
        run.event(EventKind::release, 1, 1, 2, {-1, 0, 0});
    }
    for (BodyId i = 0; i < 3; ++i) {
        FlightRecord& f =
            run.add(i, 1, {i - 1.0, 0, 0}, {after[i], 0, 0}, stays && i < 2 ? Mode::resting : Mode::flying,
                    stays && i < 2 ? several_supports : -1);
        f.acceleration = 0;
    }
    return run;
}

/// Two balls of e = 1/2 meet at t = 1 with this closing speed and stay together.
Handmade sticking(double speed, double v_c)
{
    Scene scene = empty_scene(3, Vec3::Zero(), 0.5);
    scene.rest.closing_speed = v_c;
    scene.rest.window = 0.25;
    add_sphere(scene, 0.5, {-1 - speed, 0, 0}, {speed, 0, 0});
    add_sphere(scene, 0.5, {0, 0, 0});
    Handmade run(scene);
    for (int i = 0; i < 2; ++i) run.start(Mode::flying).acceleration = 0;
    run.event(EventKind::impact, 1, 0, 1, {-1, 0, 0}, {-speed / 2, 0, 0});
    run.event(EventKind::rest, 1, 0, 1, {-1, 0, 0});
    for (BodyId i = 0; i < 2; ++i) run.add(i, 1, {i - 1.0, 0, 0}, {speed / 2, 0, 0}, Mode::sliding, several_supports);
    return run;
}

}  // namespace

TEST_CASE("a cone is what its edges add up to", "[verify]")
{
    using verification::is_in_cone;
    const Vec3 x = Vec3::UnitX(), y = Vec3::UnitY(), z = Vec3::UnitZ();
    CHECK(is_in_cone({}, Vec3::Zero(), 1e-9));
    CHECK_FALSE(is_in_cone({}, z, 1e-9));
    CHECK(is_in_cone({z}, 3 * z, 1e-9));
    CHECK_FALSE(is_in_cone({z}, -z, 1e-9));
    CHECK(is_in_cone({x, y}, x + 2 * y, 1e-9));
    CHECK_FALSE(is_in_cone({x, y}, x - y, 1e-9));
    CHECK(is_in_cone({x, y, z}, {1, 2, 3}, 1e-9));
    CHECK_FALSE(is_in_cone({x, y, z}, {1, 2, -1e-6}, 1e-9));
    CHECK(is_in_cone({x, -x, y, -y, z}, {-1, -2, 3}, 1e-9));
}

TEST_CASE("a tower at rest holds for a million seconds, with grid and without", "[verify]")
{
    for (const int n : {3, 60})
        for (const bool all : {false, true}) {
            const Certificate c = standing(tower(n, 1e6)).examined(all);
            CHECK_HOLDS(c);
            CHECK(c.body_seconds.exact == n * 1e6);
        }
    // Declared contacts may be off by 1e-9 r: an overlap of the start may stay, that is all.
    Scene close = tower(3, 10);
    close.spheres[2].position.z() -= 4e-10;
    CHECK_HOLDS(standing(close).examined());
}

TEST_CASE("what rests on nothing, too high, too deep or on what cannot hold it is refused", "[verify]")
{
    Scene scene = tower(3, 10);
    scene.spheres[2].position.z() += 1e-6;
    CHECK_REFUSED(standing(scene).examined(), "sphere 2 is held by contacts that cannot push it so");
    scene = tower(3, 10);
    scene.planes.clear();
    CHECK_REFUSED(standing(scene).examined(), "sphere 0 is held by contacts");
    scene = tower(3, 10);
    scene.spheres[2].position.x() += 1e-3;  // leans
    CHECK_FALSE(standing(scene).examined().holds());
    scene = tower(3, 10);
    Handmade sinking = standing(scene);
    sinking.source.flights[2].local[2] -= 1e-6;
    CHECK_FALSE(sinking.examined().holds());
    Handmade moving = standing(scene);
    moving.source.flights[1].velocity[0] = 1e-9;
    CHECK_REFUSED(moving.examined(), "rests and moves");
}

TEST_CASE("a ball in a groove rests at sqrt(2) r, and slides along it as gravity says", "[verify]")
{
    Handmade rest(groove(earth));
    rest.start(Mode::resting, several_supports);
    CHECK_HOLDS(rest.examined());
    Scene high = groove(earth);
    high.spheres[0].position.z() += 1e-6;
    Handmade above(high);
    above.start(Mode::resting, several_supports);
    CHECK_REFUSED(above.examined(), "cannot push it so");

    for (const Vec3& own : {Vec3(0, 2, 0), Vec3(0, 2, 1e-3), Vec3(0, 1, 0), Vec3(1e-3, 2, 0)}) {
        Handmade slide(groove({0, 2, -9.81}));
        slide.start(Mode::sliding, several_supports, own);
        if (own == Vec3(0, 2, 0))
            CHECK_HOLDS(slide.examined());
        else
            CHECK_FALSE(slide.examined().holds());
    }
}

TEST_CASE("spheres that slide down together in contact hold, unless one is faster", "[verify]")
{
    const Scene scene = row_on_a_slope();
    for (const double second : {1.0, 1.001, 0.999}) {
        Handmade run(scene);
        run.start(Mode::sliding, several_supports, {1, 0, 0});
        run.start(Mode::sliding, several_supports, {second, 0, 0});
        const Certificate c = run.examined();
        CHECK(c.holds() == (second == 1));
        if (second == 1) CHECK(c.body_seconds.exact + c.body_seconds.bounded + c.body_seconds.in_contact == 4);
    }
}

TEST_CASE("the impact of a cradle holds, and its contacts are counted", "[verify]")
{
    const Certificate c = cradle({0, 0, 1}).examined();
    CHECK_HOLDS(c);
    CHECK(c.clusters == 1);
    CHECK(c.impulses == 2);
    CHECK(c.rests_on_spheres == 1);
    CHECK(c.releases_of_spheres == 1);
    CHECK_HOLDS(cradle({-0.25, 0.625, 0.625}).examined());  // loses energy, which is not looked at
}

TEST_CASE("cluster impacts that lose momentum, gain energy, pull, or close afterwards are refused", "[verify]")
{
    Handmade faster = cradle({0, 0, 1});
    faster.source.flights[5].velocity[0] = 1 + 1e-9;
    CHECK_REFUSED(faster.examined(), "beside its impulses");
    CHECK_REFUSED(cradle({-0.5, 0.25, 1.25}).examined(), "gain energy");
    CHECK_REFUSED(cradle({0.5, 0.25, 0.25}).examined(), "closes further");
    CHECK_FALSE(cradle({0.5, 0.75, -0.25}).examined().holds());
    Handmade pulled = cradle({0, 0, 1});
    for (Event& e : pulled.source.events) e.normal *= -1;
    CHECK_FALSE(pulled.examined().holds());
    // A body that several contacts hold may not move on by itself.
    Handmade alone = standing(tower(2, 2));
    alone.add(1, 1, {0, 0, 1.5}, {0, 0, 0}, Mode::resting, several_supports);
    CHECK_REFUSED(alone.examined(), "without an event");
}

TEST_CASE("no rebound: below v_c, where a rebound below v_c is held, and less than tau_p after the last", "[verify]")
{
    CHECK_HOLDS(sticking(0.25, 0.3).examined());
    CHECK_HOLDS(sticking(0.25, 0.2).examined());  // too fast for that, but its rebound of 0.125 is slow, and held
    CHECK_REFUSED(sticking(0.25, 0.1).examined(), "not that of its contact");
    Handmade elastic = sticking(0.25, 0.3);
    elastic.source.description.materials[0].restitution = 1;
    CHECK_REFUSED(elastic.examined(), "not that of its contact");

    // A bounce between two balls and a wall close by: the second impact of the pair comes after 1/8 or 1/2.
    for (const double wait : {0.125, 0.5}) {
        Scene scene = empty_scene(4, Vec3::Zero(), 0.5);
        scene.rest.closing_speed = 1e-3;
        scene.rest.window = 0.25;
        add_sphere(scene, 0.5, {-3, 0, 0}, {2, 0, 0});
        add_sphere(scene, 0.5, {0, 0, 0});
        Handmade run(scene);
        for (int i = 0; i < 2; ++i) run.start(Mode::flying).acceleration = 0;
        // v = 2 -> (1/2, 3/2); then by a forged kick of a third body they close again: here a wall turns the second.
        run.source.description.planes = {Plane{"wall", {-1, 0, 0}, -0.5 - 1.5 * wait, {}, 0}};
        const double t1 = 1, t2 = t1 + wait;
        run.event(EventKind::impact, t1, 0, 1, {-1, 0, 0}, {-1.5, 0, 0});
        run.add(0, t1, {-1, 0, 0}, {0.5, 0, 0}, Mode::flying).acceleration = 0;
        run.add(1, t1, {0, 0, 0}, {1.5, 0, 0}, Mode::flying).acceleration = 0;
        run.event(EventKind::impact, t2, 1, 2, {-1, 0, 0}, {-2.25, 0, 0});
        run.add(1, t2, {1.5 * wait, 0, 0}, {-0.75, 0, 0}, Mode::flying).acceleration = 0;
        // Gap now: wait; closing at 1.25.
        const double t3 = t2 + wait / 1.25, x = -1 + 0.5 * (t3 - t1);
        run.event(EventKind::impact, t3, 0, 1, {-1, 0, 0}, {-0.625, 0, 0});
        run.event(EventKind::rest, t3, 0, 1, {-1, 0, 0});
        run.add(0, t3, {x, 0, 0}, {-0.125, 0, 0}, Mode::sliding, several_supports);
        run.add(1, t3, {x + 1, 0, 0}, {-0.125, 0, 0}, Mode::sliding, several_supports);
        const Certificate c = run.examined();
        INFO(first_violation(c));
        CHECK(c.holds() == (wait < 0.25 / 1.8));
    }
}

TEST_CASE("numeric pieces are measured where they end and how deep they reach", "[verify]")
{
    Scene scene = empty_scene(2, {0, 0, -1});
    add_sphere(scene, 0.5, {0, 0, 2}, {1, 0, 0});
    add_sphere(scene, 0.5, {0, 0, 1});
    scene.spheres[1].fixed = true;
    // Over the top of the fixed one: |r|^2 = 1 + (1 - a) t^2 + a^2 t^4 / 4.
    const auto run = [&](double a, double jump, double kick) {
        Handmade made(scene);
        made.start(Mode::numeric, several_supports, {0, 0, -a});
        made.start(Mode::fixed);
        made.add(0, 1, {1, 0, 2 - a / 2 + jump}, {1, 0, -a + kick}, Mode::numeric, several_supports);
        return made.examined();
    };
    const Certificate c = run(0.5, 1e-7, 1e-5);
    CHECK_HOLDS(c);
    CHECK(c.body_seconds.numeric == 2);
    CHECK(c.largest_numeric_jump == Approx(1e-7).epsilon(1e-6));
    CHECK(c.largest_numeric_kick == Approx(1e-5).epsilon(1e-6));
    CHECK(c.numeric_depth == 0);
    const Certificate deep = run(1.1, 0, 0);
    CHECK_HOLDS(deep);
    CHECK(deep.numeric_depth == Approx(1 - std::sqrt(1 - 0.01 / 1.21)).epsilon(1e-9));
    CHECK(deep.smallest_gap == -deep.numeric_depth);
    CHECK_REFUSED(run(1.2, 0, 0), "overlap");
    CHECK_REFUSED(run(0.5, 0.01, 0), "jumps");
}

TEST_CASE("windows of the guard are straight lines, and counted", "[verify]")
{
    Scene scene = empty_scene(3, Vec3::Zero(), 0.5);
    add_sphere(scene, 0.5, {0, 0, 0}, {0.5, 0, 0});
    add_sphere(scene, 0.5, {1.5, 0, 0}, {-0.5, 0, 0});
    const auto run = [&](double depth, const auto& forge) {
        Handmade made(scene);
        for (int i = 0; i < 2; ++i) made.start(Mode::flying).acceleration = 0;
        made.event(EventKind::guard, 0.25, 0, no_body, Vec3::Zero());
        const double x0 = 0.125, x1 = 1.375, v = (0.25 + depth) / 2;
        made.add(0, 0.25, {x0, 0, 0}, {v, 0, 0}, Mode::numeric).guarded = true;
        made.add(1, 0.25, {x1, 0, 0}, {-v, 0, 0}, Mode::numeric).guarded = true;
        made.add(0, 1.25, {x0 + v, 0, 0}, {-0.25, 0, 0}, Mode::flying).acceleration = 0;
        made.add(1, 1.25, {x1 - v, 0, 0}, {0.25, 0, 0}, Mode::flying).acceleration = 0;
        forge(made.source);
        return made.examined();
    };
    const auto nothing = [](MemorySource&) {};
    const Certificate c = run(0, nothing);
    CHECK_HOLDS(c);
    CHECK(c.guards == 1);
    CHECK(c.body_seconds.guarded == 2);
    CHECK(c.guarded_depth < 1e-15);
    CHECK(c.body_seconds.exact + c.body_seconds.bounded == 4);
    CHECK_REFUSED(run(0.625, nothing), "overlap");
    CHECK_REFUSED(run(0, [](MemorySource& s) { s.events[0].b = 1; }), "bodies that are not there");
    CHECK_REFUSED(run(0, [](MemorySource& s) { s.events[0].kind = EventKind::impact; }), "bodies that are not there");
    CHECK_REFUSED(run(0,
                      [](MemorySource& s) {
                          s.flights[2].acceleration = own_acceleration;
                          s.flights[2].own[1] = 1e-9;
                      }),
                  "no straight line");
    CHECK_REFUSED(run(0, [](MemorySource& s) { s.flights[2].mode = Mode::flying; }), "");
}

TEST_CASE("what a mode does not have is refused", "[verify]")
{
    const auto forged = [&](const auto& forge) {
        Handmade run = standing(tower(2, 1));
        forge(run.source.flights[1]);
        return run.examined();
    };
    CHECK_HOLDS(forged([](FlightRecord&) {}));
    CHECK_REFUSED(forged([](FlightRecord& f) { f.support = -1; }), "support");
    CHECK_REFUSED(forged([](FlightRecord& f) { f.support = -3; }), "not there");
    CHECK_REFUSED(forged([](FlightRecord& f) { f.acceleration = -2; }), "not there");
    CHECK_REFUSED(forged([](FlightRecord& f) { f.mode = Mode::flying; }), "support");
    CHECK_REFUSED(forged([](FlightRecord& f) { f.guarded = true; }), "guarded");
    CHECK_REFUSED(forged([](FlightRecord& f) { f.own[0] = std::numeric_limits<double>::quiet_NaN(); }), "range");
    CHECK_REFUSED(forged([](FlightRecord& f) {
                      f.acceleration = own_acceleration;
                      f.own[2] = 1e-6;
                  }),
                  "rests and moves");
}

TEST_CASE("a settle is an impulse: forged ones are seen in the speeds", "[verify]")
{
    Handmade held = standing(tower(2, 2));
    held.event(EventKind::settle, 1, 0, 1, {0, 0, -1}, {0, 0, 0.25});
    for (BodyId i = 0; i < 2; ++i) held.add(i, 1, {0, 0, 0.5 + i}, {0, 0, 0}, Mode::resting, several_supports);
    CHECK_REFUSED(held.examined(), "beside its impulses");
}
