/// Certified runs: on the flights as stored, in exact-enough arithmetic of this test's own, no gap is ever negative.
#include <carom/simulate.hpp>

#include <boost/multiprecision/mpfr.hpp>
#include <catch2/catch.hpp>

#include "core/random.hpp"

#include <map>
#include <vector>

using namespace carom;
using Real =
    boost::multiprecision::number<boost::multiprecision::mpfr_float_backend<110>, boost::multiprecision::et_off>;

namespace {

struct Recorded {
    RunFrame frame;
    std::vector<std::vector<FlightRecord>> flights;  // by body
    Outcome outcome;
};

Recorded record(const Scene& scene, bool certified, BroadPhase broad_phase = BroadPhase::automatic)
{
    Recorded r;
    r.flights.resize(scene.spheres.size());
    Observer observer;
    observer.on_frame = [&](const RunFrame& frame) { r.frame = frame; };
    observer.on_flight = [&](const FlightRecord& f) { r.flights[static_cast<std::size_t>(f.body)].push_back(f); };
    EventDriven method;
    method.certified = certified;
    method.broad_phase = broad_phase;
    r.outcome = simulate(scene, method, {}, observer);
    return r;
}

/// Position and velocity at a time, each coordinate a polynomial of it.
struct Path {
    Real start, x[3], v[3], a[3];
};

Path path(const Recorded& r, const FlightRecord& f)
{
    Path p;
    p.start = Real(f.start.epoch) * r.frame.epoch_length + Real(f.start.offset);
    for (std::size_t k = 0; k < 3; ++k) {
        p.x[k] = Real(f.cell[k]) * r.frame.cell_size + Real(f.local[k]) + Real(f.local_low[k]);
        p.v[k] = Real(f.velocity[k]) + Real(f.velocity_low[k]);
        p.a[k] = r.frame.accelerations[static_cast<std::size_t>(f.acceleration)][static_cast<Eigen::Index>(k)];
    }
    return p;
}

/// Least value of C = |r|^2 - S^2 of two flights from `from` to `to`, both under the same acceleration.
Real least_squared_gap(const Path& a, const Path& b, const Real& s, const Real& from, const Real& to)
{
    Real rr = 0, rv = 0, vv = 0;
    for (int k = 0; k < 3; ++k) {
        const Real ta = from - a.start, tb = from - b.start;
        const Real r = a.x[k] + ta * (a.v[k] + ta * a.a[k] / 2) - b.x[k] - tb * (b.v[k] + tb * b.a[k] / 2);
        const Real v = a.v[k] + ta * a.a[k] - b.v[k] - tb * b.a[k];
        rr += r * r;
        rv += r * v;
        vv += v * v;
    }
    const Real length = to - from;
    Real t = 0;
    if (rv < 0 && vv > 0) t = -rv / vv < length ? Real(-rv / vv) : length;
    return rr + 2 * rv * t + vv * t * t - s * s;
}

/// Least gap of any pair of spheres, divided by S; of the floor and walls the least height.
double deepest(const Scene& scene, const Recorded& r)
{
    const Real end = scene.end_time;
    Real deepest = 1;
    std::vector<std::vector<Path>> paths;
    for (const auto& flights : r.flights) {
        paths.emplace_back();
        for (const auto& f : flights) paths.back().push_back(path(r, f));
    }
    const auto until = [&](std::size_t body, std::size_t k) {
        return k + 1 < paths[body].size() ? paths[body][k + 1].start : end;
    };
    for (std::size_t i = 0; i < paths.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) {
            const Real s = Real(scene.spheres[i].radius) + Real(scene.spheres[j].radius);
            for (std::size_t k = 0, l = 0; k < paths[i].size() && l < paths[j].size();) {
                const Real from = std::max(paths[i][k].start, paths[j][l].start);
                const Real to_i = until(i, k), to_j = until(j, l), to = std::min(to_i, to_j);
                if (from < to || from == to)
                    deepest =
                        std::min<Real>(deepest, least_squared_gap(paths[i][k], paths[j][l], s, from, to) / (2 * s * s));
                (to_i <= to_j ? k : l) += 1;
            }
        }
    for (std::size_t i = 0; i < paths.size(); ++i)
        for (std::size_t k = 0; k < paths[i].size(); ++k)
            for (const Plane& plane : scene.planes) {
                const Path& p = paths[i][k];
                Real h = -Real(plane.offset) - Real(scene.spheres[i].radius), w = 0, g = 0;
                for (int c = 0; c < 3; ++c) {
                    h += Real(plane.normal[c]) * p.x[c];
                    w += Real(plane.normal[c]) * p.v[c];
                    g += Real(plane.normal[c]) * p.a[c];
                }
                const Real length = until(i, k) - p.start;
                for (const Real& t : {Real(0), length}) deepest = std::min<Real>(deepest, h + t * (w + t * g / 2));
                if (g > 0 && w < 0 && -w / g < length) deepest = std::min<Real>(deepest, h - w * w / (2 * g));
            }
    return static_cast<double>(deepest);
}

Scene stirred(std::uint64_t seed, bool gravity, int count = 8)
{
    Random random(seed);
    Scene scene;
    if (gravity) scene.gravity = {0.3, -0.2, -9.81};
    scene.end_time = 4;
    for (int axis = 0; axis < 3; ++axis)
        for (int side : {1, -1}) {
            Plane wall;
            wall.normal = side * Vec3::Unit(axis);
            wall.offset = side == 1 ? 0 : -1;
            scene.planes.push_back(wall);
        }
    Plane tilted;
    tilted.normal = Vec3(1, 2, 3).normalized();
    tilted.offset = 0.2;
    scene.planes.push_back(tilted);
    for (int i = 0; i < count; ++i) {
        Sphere s;
        s.radius = i % 3 == 0 ? 0.12 : 0.03;
        s.mass = i % 2 == 0 ? 1 : 1e-3;
        s.position = Vec3(i % 2 + 0.5, i / 2 % 2 + 0.5, i / 4 + 0.5) / 2 + Vec3::Constant(0.01 * random.uniform(-1, 1));
        for (int k = 0; k < 3; ++k) s.velocity[k] = random.uniform(-2, 2);
        scene.spheres.push_back(s);
    }
    return scene;
}

}  // namespace

TEST_CASE("in a certified run no gap is negative, at any time, of any pair or plane", "[certified]")
{
    for (const bool gravity : {false, true})
        for (std::uint64_t seed = 1; seed <= 4; ++seed) {
            const Scene scene = stirred(seed, gravity);
            CAPTURE(gravity, seed);
            const Recorded run = record(scene, true);
            REQUIRE(run.outcome.status == Status::reached_end);
            CHECK(run.outcome.counts.impacts > 100);
            CHECK(run.outcome.max_penetration == 0);
            CHECK(deepest(scene, run) >= 0);
        }
}

TEST_CASE("a run in plain doubles does dip below zero, by roundings: the check can fail", "[certified]")
{
    const Scene scene = stirred(1, true);
    const double depth = deepest(scene, record(scene, false));
    CHECK(depth < 0);
    CHECK(depth > -1e-14);
}

TEST_CASE("a certified run finds the impacts of a plain one, at the same times to roundings", "[certified]")
{
    Scene scene = stirred(5, true);
    scene.end_time = 0.5;  // before roundings have grown
    const Recorded plain = record(scene, false), certified = record(scene, true);
    CHECK(plain.outcome.counts.impacts == certified.outcome.counts.impacts);
    for (std::size_t i = 0; i < scene.spheres.size(); ++i)
        CHECK((plain.outcome.final[i].position - certified.outcome.final[i].position).norm() < 1e-9);
}

TEST_CASE("certified runs do not depend on the broad phase, nor on where and when the scene lies", "[certified]")
{
    Scene scene = stirred(6, true);
    const Recorded all = record(scene, true, BroadPhase::all_pairs), grid = record(scene, true, BroadPhase::cell_grid);
    CHECK(all.outcome.event_hash == grid.outcome.event_hash);
    scene.origin = {1e9, -3e8, 7e9};
    scene.start_time.epoch = std::int64_t(1) << 40;
    CHECK(record(scene, true).outcome.event_hash == all.outcome.event_hash);
}

TEST_CASE("two contacts at exactly one time are one instant, two that differ by a rounding are not", "[certified]")
{
    Scene scene;
    scene.end_time = 2;
    for (const Vec3& position : {Vec3(0, 0, 0), Vec3(3, 1, 0), Vec3(3, -1, 0)}) {
        Sphere s;
        s.radius = 1;
        s.position = position;
        scene.spheres.push_back(s);
    }
    scene.spheres[0].velocity = {1, 0, 0};
    scene.spheres[1].radius = scene.spheres[2].radius = 0.9;
    CHECK(record(scene, true).outcome.counts.clusters == 1);
    scene.spheres[2].position.x() = 3 + 0x1p-50;
    CHECK(record(scene, true).outcome.counts.clusters == 0);
    CHECK(record(scene, false).outcome.counts.clusters == 1);  // within its tie tolerance
}

TEST_CASE("a wall that comes just before a grazing sphere is first, however rough a first look at the times is",
          "[certified]")
{
    // Half a chord of 1e-k: the time at which the moving sphere meets the fixed one is known at first to some 1e-15 *
    // 10^k.
    int wall_first = 0, sphere_first = 0;
    for (int k = 2; k <= 7; ++k)
        for (int step = -40; step <= 40; ++step) {
            const double half_chord = std::pow(10, -k), x = 2.3, y = std::sqrt(1 - half_chord * half_chord);
            const double ahead = step * 0.1 * 1e-15 / half_chord;  // of the wall
            Scene scene;
            scene.end_time = 4;
            scene.spheres.resize(2);
            scene.spheres[0].radius = scene.spheres[1].radius = 0.5;
            scene.spheres[0].velocity = {1, 0, 0};
            scene.spheres[1].position = {x, y, 0};
            scene.spheres[1].fixed = true;
            scene.planes.resize(1);
            scene.planes[0].normal = {-1, 0, 0};
            scene.planes[0].offset = -(x - half_chord + 0.5 - ahead);
            const Real of_sphere = Real(x) - sqrt(1 - Real(y) * Real(y)),
                       of_wall = -Real(scene.planes[0].offset) - Real(0.5);
            if (abs(of_sphere - of_wall) < 1e-15) continue;
            std::vector<Event> events;
            Observer observer;
            observer.on_event = [&](const Event& e) { events.push_back(e); };
            EventDriven method;
            method.certified = true;
            const Outcome outcome = simulate(scene, method, {}, observer);
            CAPTURE(k, step);
            CHECK(outcome.max_penetration == 0);
            REQUIRE(!events.empty());
            const bool wall = of_wall < of_sphere;
            CHECK((events[0].b == 2) == wall);
            ++(wall ? wall_first : sphere_first);
        }
    CHECK(wall_first > 100);
    CHECK(sphere_first > 100);
}

TEST_CASE("certified runs of inelastic spheres come to rest as plain ones do", "[certified]")
{
    Scene scene;
    scene.gravity = {0, 0, -9.81};
    scene.end_time = 5;
    scene.materials[0].restitution = 0.8;
    Sphere ball;
    ball.radius = 0.1;
    ball.position = {0, 0, 1.1};
    scene.spheres.push_back(ball);
    Plane floor;
    floor.normal = {0, 0, 1};
    scene.planes.push_back(floor);
    const Recorded run = record(scene, true);
    REQUIRE(run.outcome.rest_times[0]);
    CHECK(*run.outcome.rest_times[0] == Approx(9 * std::sqrt(2 / 9.81)).epsilon(1e-13));
    CHECK(run.outcome.final[0].mode == Mode::resting);
}
