#include "support/scenes.hpp"

#include <catch2/catch.hpp>

using namespace carom;
using namespace carom::test;

namespace {

Scene drop(double restitution)
{
    Scene scene = empty_scene(6, earth, restitution);
    add_floor(scene);
    add_sphere(scene, 0.1, {0, 0, 1.1});
    return scene;
}

}  // namespace

TEST_CASE("a drop from h = 1 first hits at sqrt(2h/g) and rests at sqrt(2h/g)(1+e)/(1-e)")
{
    for (const double e : {0.5, 0.8}) {
        const Recorded run = record(drop(e));
        const double fall = std::sqrt(2 / 9.81);
        REQUIRE_FALSE(run.events.empty());
        CHECK(run.events[0].time == Approx(0.451523640985731).epsilon(1e-14));
        REQUIRE(run.outcome.rest_times[0].has_value());
        CHECK(*run.outcome.rest_times[0] == Approx(fall * (1 + e) / (1 - e)).epsilon(1e-12));
        CHECK(*run.outcome.rest_times[0] == Approx(e == 0.5 ? 1.354570923 : 4.063713).epsilon(1e-6));
        CHECK(run.outcome.final[0].mode == Mode::resting);
        CHECK(run.outcome.status == Status::reached_end);
    }
}

TEST_CASE("a drop from h = 1 with e = 0.5 travels 5/3 in all")
{
    // Each bounce to its apex and back; heights follow from the speeds of the events.
    Scene scene = drop(0.5);
    scene.rest.series_below = 1e-12;
    double path = 1;
    for (const Event& event : record(scene).events) {
        if (event.kind != EventKind::impact) continue;
        const double speed = event.impulse.z() * 0.5 / 1.5;  // impulse (1+e) v_in, leaves with e v_in
        path += 2 * speed * speed / (2 * 9.81);
    }
    CHECK(path == Approx(5.0 / 3).epsilon(1e-12));
}

TEST_CASE("bounces of an elastic ball reach their height again after 10 s")
{
    Scene scene = drop(1);
    scene.end_time = 10;
    const Recorded run = record(scene);
    const double fall = std::sqrt(2 / 9.81);
    REQUIRE(run.events.size() > 5);
    for (std::size_t k = 0; k < run.events.size(); ++k)
        CHECK(run.events[k].time == Approx(fall * static_cast<double>(2 * k + 1)).epsilon(1e-14));
    CHECK(energy(scene, run.outcome.final) == Approx(9.81 * 1.1).epsilon(1e-14));
}
