#include <catch2/catch.hpp>

#include "reference_scenes.hpp"

#include <algorithm>
#include <cmath>

using namespace carom;
using namespace carom::test;

TEST_CASE("A dropped ball first hits the floor after sqrt(2h/g) and rests after sqrt(2h/g)(1+e)/(1-e)", "[reference]")
{
    for (const double e : {0.5, 0.75, 0.8}) {
        Scene scene = drop(1, e);
        const std::vector<double> times{0, 0.25, 6};
        const Reference ref = make_reference(scene, 6, times);
        CHECK(ref.reason.empty());
        CHECK(ref.until == 6);
        CHECK(ref.kind == Reference::Kind::closed_form);
        REQUIRE(ref.impacts.size() >= 2);
        CHECK(ref.impacts[0].time == Approx(0.451523640985731).epsilon(1e-15).margin(0));
        CHECK(ref.impacts[0].b == scene.plane_body(0));
        REQUIRE(ref.series.size() == 1);
        CHECK(ref.series[0].end == Approx(std::sqrt(2 / 9.81) * (1 + e) / (1 - e)).epsilon(1e-14).margin(0));
        CHECK(ref.series[0].start == ref.impacts.back().time);
        // Bounce k rises to e^(2k); the first below 1e-3 of the radius begins the series.
        const double height = std::pow(e, 2.0 * static_cast<double>(ref.impacts.size()));
        CHECK(height < 1e-3 * 0.125);
        CHECK(height / (e * e) >= 1e-3 * 0.125);
        REQUIRE(ref.samples.size() == 3);
        CHECK(ref.samples[0][0].mode == Mode::flying);
        CHECK(ref.samples[1][0].position.z() == Approx(1.125 - 9.81 * 0.03125).epsilon(1e-15));
        CHECK(ref.samples[2][0].mode == Mode::resting);
        CHECK(ref.samples[2][0].velocity == Vec3::Zero());
        CHECK(ref.samples[2][0].position == Vec3(0, 0, 0.125));
        CHECK(ref.root_solves == static_cast<std::int64_t>(1));
    }
}

TEST_CASE("Inside a series height and tangential motion are the geometric sums", "[reference]")
{
    const double h = 0x1p-11, e = 0.5, v0 = std::sqrt(2 * 9.81 * h) * e, t0 = std::sqrt(2 * h / 9.81), g_t = 0.5;
    const double end = t0 + 2 * v0 / (9.81 * (1 - e));
    std::vector<double> times;
    for (int k = 0; k <= 200; ++k) times.push_back(k * 0.00016 + 2e-6);
    for (const double alpha : {1.0, 0.75, 0.5}) {
        Scene scene = drop(h, e, alpha, {0.3, 0, 0});
        scene.gravity = {g_t, 0, -9.81};
        const Reference ref = make_reference(scene, 1, times);
        REQUIRE(ref.reason.empty());
        CHECK(ref.impacts.size() == 1);
        REQUIRE(ref.series.size() == 1);
        CHECK(ref.series[0].start == Approx(t0).epsilon(1e-15).margin(0));
        CHECK(ref.series[0].end == Approx(end).epsilon(1e-15).margin(0));
        CHECK(ref.series[0].normal_speed == Approx(v0).epsilon(1e-15).margin(0));
        CHECK(ref.series[0].gravity == 9.81);
        int in_series = 0, sliding = 0;
        for (std::size_t k = 0; k < times.size(); ++k) {
            const BodyState& state = ref.samples[k][0];
            if (times[k] < t0) continue;
            double t = t0, w = v0, x = 0.3 * t0 + g_t * t0 * t0 / 2, v = alpha * (0.3 + g_t * t0), height = 0;
            for (int bounce = 0; bounce < 60 && times[k] < end; ++bounce) {
                const double d = 2 * w / 9.81, s = std::min(d, times[k] - t);
                height = w * s - 9.81 * s * s / 2;
                x += v * s + g_t * s * s / 2;
                v = v + g_t * s;
                if (s < d) break;
                t += d;
                w *= e;
                v *= alpha;
            }
            if (times[k] < end) {
                CHECK(state.mode == Mode::series);
                CHECK(state.position.z() == Approx(0.125 + height).epsilon(1e-14));
                CHECK(state.position.x() == Approx(x).epsilon(1e-13));
                CHECK(state.velocity.x() == Approx(v).epsilon(1e-12));
                ++in_series;
            } else {
                const double v_end = alpha == 1 ? 0.3 + g_t * times[k] : g_t * (times[k] - end);
                CHECK(state.mode == Mode::sliding);
                CHECK(state.position.z() == 0.125);
                CHECK(state.velocity.x() == Approx(v_end).epsilon(1e-13).margin(1e-16));
                ++sliding;
            }
        }
        CHECK(in_series > 50);
        CHECK(sliding > 10);
    }
}

TEST_CASE("Almost no friction still stops the slide at the end of a series", "[reference]")
{
    Scene scene = drop(0.01, 0.5, 1 - 1e-9, {1e6, 0, 0});
    const Reference ref = run_to(scene, 1);
    CHECK(ref.samples[0][0].mode == Mode::resting);
    CHECK(ref.samples[0][0].position.x() == Approx(1e6 * ref.series[0].end).epsilon(1e-7));
}

TEST_CASE("With e = 0 the first impact is the last and sliding begins at once", "[reference]")
{
    Scene scene = drop(1, 0, 0.5, {2, 0, 0});
    const Reference ref = run_to(scene, 1);
    CHECK(ref.impacts.size() == 1);
    REQUIRE(ref.series.size() == 1);
    CHECK(ref.series[0].end == ref.series[0].start);
    CHECK(ref.samples[0][0].mode == Mode::sliding);
    CHECK(ref.samples[0][0].velocity == Vec3(1, 0, 0));
    const double t1 = std::sqrt(2 / 9.81);
    CHECK(ref.samples[0][0].position.x() == Approx(2 * t1 + (1 - t1)).epsilon(1e-15));
}

TEST_CASE("An elastic ball keeps its energy over many bounces and is back after each period", "[reference]")
{
    Scene scene = drop(1, 1);
    const double period = 2 * std::sqrt(2 / 9.81);
    const Reference ref = run_to(scene, 1000.5 * period);
    CHECK(ref.impacts.size() == 1001);
    REQUIRE(ref.samples.size() == 1);
    CHECK(energy(scene, ref.samples[0]) == Approx(9.81 * 1.125).epsilon(1e-15));
    CHECK(ref.impacts[1000].time == Approx(1000.5 * period).epsilon(1e-14));
    CHECK(ref.series.empty());
}

TEST_CASE("A tangential factor acts on the velocity along the plane at each impact", "[reference]")
{
    Scene scene = drop(1, 0.75, 0.5, {2, -1, 0});
    const Reference ref = run_to(scene, 0.5);
    REQUIRE(ref.impacts.size() == 1);
    const double after = 0.5 - std::sqrt(2 / 9.81);
    CHECK(ref.samples[0][0].velocity.x() == 1);
    CHECK(ref.samples[0][0].velocity.y() == -0.5);
    CHECK(ref.samples[0][0].velocity.z() == Approx(0.75 * std::sqrt(2 * 9.81) - 9.81 * after).epsilon(1e-14));
}

TEST_CASE("A frictionless slide down an incline is g sin(theta) t^2 / 2", "[reference]")
{
    Scene scene = drop(0, 0.5);
    const double theta = 0.5235987755982988;
    const Vec3 n(-std::sin(theta), 0, std::cos(theta));
    scene.planes = {plane("incline", n, 0)};
    scene.spheres[0].position = n * 0.125;
    const Reference ref = run_to(scene, 3);
    CHECK(ref.reason.empty());
    CHECK(ref.impacts.empty());
    CHECK(ref.samples[0][0].mode == Mode::sliding);
    const Vec3 moved = ref.samples[0][0].position - scene.spheres[0].position;
    CHECK(moved.norm() == Approx(9.81 * std::sin(theta) * 9 / 2).epsilon(1e-15));
    CHECK(std::abs(n.dot(moved)) < 1e-14);
    CHECK(moved.z() < 0);
}

TEST_CASE("A ball that slides on the floor bounces off a wall and slides on", "[reference]")
{
    Scene scene = drop(0, 0.5, 1, {1, 0.25, 0});
    scene.planes.push_back(plane("wall", {-1, 0, 0}, -1.125));
    const Reference ref = run_to(scene, 3);
    CHECK(ref.reason.empty());
    REQUIRE(ref.impacts.size() == 1);
    CHECK(ref.impacts[0].time == 1);
    CHECK(ref.impacts[0].b == scene.plane_body(1));
    CHECK(ref.samples[0][0].mode == Mode::sliding);
    CHECK(ref.samples[0][0].position == Vec3(0, 0.75, 0.125));
    CHECK(ref.samples[0][0].velocity == Vec3(-0.5, 0.25, 0));
}

TEST_CASE("A bullet rebounds from a plate of any thickness, from either side", "[reference]")
{
    for (const double side : {1.0, -1.0}) {
        for (const double thickness : {0.0, 0x1p-20}) {
            Scene scene;
            scene.spheres = {ball("bullet", {-side * 1024, 0, 0}, {side * 4096, 0, 0}, 1, 0x1p-7)};
            scene.planes = {plane("plate", {1, 0, 0}, 0.5)};
            scene.planes[0].thickness = thickness;
            const double travel = std::abs(0.5 + side * 1024) - 0x1p-7 - thickness / 2;
            const Reference ref = run_to(scene, 1);
            REQUIRE(ref.impacts.size() == 1);
            CHECK(ref.impacts[0].time == travel / 4096);
            CHECK(ref.samples[0][0].velocity == Vec3(-side * 4096, 0, 0));
        }
    }
}

TEST_CASE("A wall met during a series breaks it off, and the next bounce begins another", "[reference]")
{
    Scene scene = drop(1e-4, 0.5, 1, {0.25, 0, 0});
    scene.planes.push_back(plane("wall", {-1, 0, 0}, -0.125 - 2e-3));
    const Reference ref = run_to(scene, 1);
    CHECK(ref.reason.empty());
    REQUIRE(ref.series.size() == 2);
    REQUIRE(ref.impacts.size() == 3);
    CHECK(ref.impacts[1].b == scene.plane_body(1));
    CHECK(ref.impacts[1].time == Approx(8e-3).epsilon(1e-14));
    CHECK(ref.series[0].end == ref.impacts[1].time);
    CHECK(ref.series[1].start == ref.impacts[2].time);
    // As if there were no wall, which keeps the normal motion.
    CHECK(ref.series[1].end == Approx(std::sqrt(2e-4 / 9.81) * 3).epsilon(1e-12));
    CHECK(ref.samples[0][0].velocity.x() == -0.125);
}

TEST_CASE("A slide meets a ramp and takes off, or an overhang, and turns back", "[reference]")
{
    Scene scene = drop(0, 0.5, 1, {1, 0, 0});
    scene.planes.push_back(plane("ramp", {-0.8, 0, 0.6}, -0.8));
    const std::vector<double> times{1, 10};
    const Reference ramp = make_reference(scene, 10, times);
    CHECK(ramp.reason.empty());
    scene.planes[1] = plane("overhang", {-0.8, 0, -0.6}, -0.8);
    const Reference overhang = run_to(scene, 10);
    CHECK(overhang.reason.empty());
    REQUIRE(overhang.impacts.size() >= 2);  // with both at once
    CHECK(overhang.impacts[0].time == overhang.impacts[1].time);
    CHECK(overhang.samples[0][0].velocity.x() < 0);
    CHECK(std::abs(overhang.samples[0][0].position.z() - 0.125) < 1e-15);
}
