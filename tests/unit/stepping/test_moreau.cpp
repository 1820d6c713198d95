#include "run_all.hpp"
#include "small_scenes.hpp"
#include "stepping/contact_solver.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

using namespace carom;
using namespace carom::test;

namespace {

const Vec3 earth(0, 0, -9.81);

Moreau moreau(double dt, int sweeps = 100)
{
    Moreau method{steps(dt)};
    method.sweeps = sweeps;
    return method;
}

/// Touching balls of radius 1/2 in a row along x: every centre is a double, every gap exactly 0.
Scene touching_row(const std::vector<double>& masses, const std::vector<double>& speeds, double restitution)
{
    std::vector<Sphere> spheres;
    for (std::size_t i = 0; i < masses.size(); ++i)
        spheres.push_back(ball(0.5, Vec3(static_cast<double>(i), 0, 0), Vec3(speeds[i], 0, 0), masses[i]));
    Scene scene = scene_of(std::move(spheres));
    scene.materials[0].restitution = restitution;
    return scene;
}

/// Speeds along x after one step.
std::vector<double> after_impact(const Scene& scene, const Moreau& method)
{
    std::vector<double> speeds;
    for (const BodyState& s : run_discrete(scene, method, until(method.dt)).final) speeds.push_back(s.velocity.x());
    return speeds;
}

void check_speeds(const std::vector<double>& found, const std::vector<double>& expected)
{
    REQUIRE(found.size() == expected.size());
    for (std::size_t i = 0; i < found.size(); ++i) CHECK(found[i] == Approx(expected[i]).margin(1e-12));
}

/// Highest place in each of `parts` equal parts of a run.
std::vector<double> peaks(const Scene& scene, const Moreau& method, double time, std::size_t parts)
{
    std::vector<double> highest(parts, 0);
    Observer observer;
    observer.sample_times = sample_grid(time, 100 * parts);
    observer.on_sample = [&](std::size_t k, double, std::span<const BodyState> s) {
        double& peak = highest[std::min(k / 100, parts - 1)];
        peak = std::max(peak, s[0].position.z());
    };
    run_discrete(scene, method, until(time), observer);
    return highest;
}

}  // namespace

TEST_CASE("moreau: an elastic ball keeps its height for fifty bounces, up to the fall of one step", "[stepping]")
{
    const Scene scene = scene_of({ball(0.1, Vec3(0, 0, 1.1))}, {wall(Vec3::UnitZ(), 0)}, earth);
    for (const double dt : {1e-3, 1e-4}) {
        const double impact_speed = std::sqrt(2 * 9.81);
        for (const double peak : peaks(scene, moreau(dt), 45, 20))
            CHECK(std::abs(peak - 1.1) < 2 * impact_speed * dt + 1e-3);  // 100 samples a part: 1 mm from the top
    }
}

TEST_CASE("moreau: an inelastic ball stops on the floor and enters nothing", "[stepping]")
{
    Scene scene = scene_of({ball(0.1, Vec3(0, 0, 1.1), Vec3(0.25, 0, 0))}, {wall(Vec3::UnitZ(), 0)}, earth);
    scene.materials[0].restitution = 0;
    for (const double dt : {0.01, 0.0137, 1e-3}) {
        const Outcome outcome = run_discrete(scene, moreau(dt), until(2));
        CHECK(outcome.max_penetration < 1e-15);
        CHECK(outcome.final[0].position.z() == Approx(0.1).epsilon(1e-14));
        CHECK(std::abs(outcome.final[0].velocity.z()) < 1e-14);
        CHECK(outcome.final[0].velocity.x() == 0.25);
    }
}

TEST_CASE("moreau: an inelastic ball with a wide step does not pass or leave what it hits", "[stepping]")
{
    Scene scene = scene_of({ball(0.1, Vec3(0, 0, 0), Vec3(1, 0, 0)), ball(0.1, Vec3(0.9, 0, 0)),
                            ball(0.1, Vec3(1.101, 0, 0))});  // the second is driven into the third within the step
    scene.materials[0].restitution = 0;
    const Outcome outcome = run_discrete(scene, moreau(0.3), until(6));
    CHECK(outcome.max_penetration < 1e-14);
    for (const BodyState& s : outcome.final) CHECK(s.velocity.x() == Approx(1.0 / 3).epsilon(1e-12));
}

TEST_CASE("moreau: a touching cradle scatters as Newton's complementarity problem says", "[stepping]")
{
    check_speeds(after_impact(touching_row({1, 1, 1, 1, 1}, {1, 0, 0, 0, 0}, 1), moreau(1e-3)),
                 {-0.6, 0.4, 0.4, 0.4, 0.4});
    check_speeds(after_impact(touching_row({1, 2, 1}, {1, 0, 0}, 1), moreau(1e-3)), {-0.5, 0.5, 0.5});
    check_speeds(after_impact(touching_row({1, 1, 1}, {1, 0, -1}, 1), moreau(1e-3)), {-1, 0, 1});
    check_speeds(after_impact(touching_row({1, 1}, {1, 0}, 0.5), moreau(1e-3)), {0.25, 0.75});
    check_speeds(after_impact(touching_row({1, 1, 1, 1}, {1, 0, 0, 0}, 0), moreau(1e-3)), {0.25, 0.25, 0.25, 0.25});
}

TEST_CASE("moreau: fewer sweeps than it takes leave contacts unsatisfied", "[stepping]")
{
    // One sweep from the left is the pair law in turn, and the last ball takes it all.
    check_speeds(after_impact(touching_row({1, 1, 1}, {1, 0, 0}, 0), moreau(1e-3, 1)), {0.5, 0.25, 0.25});
    check_speeds(after_impact(touching_row({1, 1, 1}, {1, 0, 0}, 0), moreau(1e-3)), {1.0 / 3, 1.0 / 3, 1.0 / 3});
    CHECK(run_discrete(touching_row({1}, {1}, 0), moreau(1e-3, 0), until(1)).status == Status::unresolved);
}

TEST_CASE("moreau: Bernoulli's problem and a corner", "[stepping]")
{
    const double third = std::sqrt(0.75);  // height of a triangle of side 1
    for (const auto& [e, first, along, across] :
         {std::array{1.0, -0.2, 0.6, 0.34641016151377546}, std::array{0.0, 0.4, 0.3, 0.17320508075688773}}) {
        Scene scene = scene_of({ball(0.5, Vec3(0, 0, 0), Vec3(1, 0, 0)), ball(0.5 * (1 + 1e-15), Vec3(third, 0.5, 0)),
                                ball(0.5 * (1 + 1e-15), Vec3(third, -0.5, 0))});
        scene.materials[0].restitution = e;
        const Outcome outcome = run_discrete(scene, moreau(1e-6), until(1e-6));
        CHECK(outcome.final[0].velocity.x() == Approx(first).epsilon(1e-9));
        for (const int side : {1, 2}) {
            const Vec3& v = outcome.final[static_cast<std::size_t>(side)].velocity;
            CHECK(v.x() == Approx(along).epsilon(1e-9));
            CHECK(v.y() == Approx(side == 1 ? across : -across).epsilon(1e-9));
        }
    }
    const Scene corner = scene_of({ball(0.5, Vec3(0.5, 0.5, 0.5), Vec3(-1, -2, -3))},
                                  {wall(Vec3::UnitX(), 0), wall(Vec3::UnitY(), 0), wall(Vec3::UnitZ(), 0)});
    CHECK((run_discrete(corner, moreau(1e-3), until(1e-3)).final[0].velocity - Vec3(1, 2, 3)).norm() < 1e-14);
}

TEST_CASE("moreau: a tower rests with the overlap of a few steps of gravity, and the floor carries it", "[stepping]")
{
    for (const double e : {0.0, 0.5}) {
        std::vector<double> depths;
        for (const double dt : {1e-2, 5e-3}) {
            const Outcome outcome = run_discrete(tower(5, e), moreau(dt), until(10));
            INFO("e " << e << ", dt " << dt);
            for (const BodyState& s : outcome.final) CHECK(s.velocity.norm() < 1e-3);
            CHECK(outcome.final[4].position.z() > 0.9 - 10 * 9.81 * dt * dt);
            CHECK(outcome.plane_impulses[0] / 10 == Approx(5 * 9.81).epsilon(0.01));
            depths.push_back(outcome.max_penetration);
        }
        if (e == 0) CHECK(depths[1] < 1e-6);            // what a hundred sweeps leave
        if (e > 0) CHECK(depths[1] < 0.3 * depths[0]);  // with the square of the step
    }
}

TEST_CASE("moreau: momentum is kept by a crowd of any masses and restitutions", "[stepping]")
{
    for (const double e : {0.0, 0.6, 1.0}) {
        Scene scene = gas(60, 0.12, 1.6, 5);
        scene.planes.clear();
        scene.materials[0].restitution = e;
        for (std::size_t i = 0; i < scene.spheres.size(); ++i) scene.spheres[i].mass = i % 3 == 0 ? 1e3 : 0.5;
        Vec3 before = Vec3::Zero(), after = Vec3::Zero();
        double largest = 0;
        for (const Sphere& s : scene.spheres) {
            before += s.mass * s.velocity;
            largest = std::max(largest, s.mass);
        }
        const Outcome outcome = run_discrete(scene, moreau(1e-2), until(0.5));
        for (std::size_t i = 0; i < scene.spheres.size(); ++i)
            after += scene.spheres[i].mass * outcome.final[i].velocity;
        CHECK(outcome.counts.impacts > 30);
        CHECK((after - before).norm() < 1e-12 * largest * 60);
    }
}

TEST_CASE("moreau: tangential factors act where a sphere meets a plane, not where it lies on it", "[stepping]")
{
    Scene scene = scene_of({ball(0.1, Vec3(0, 0, 1.1), Vec3(2, 0, 0))}, {wall(Vec3::UnitZ(), 0)}, earth);
    scene.materials[0] = Material{"felt", 0, 0.5, ""};
    CHECK(run_discrete(scene, moreau(1e-3), until(3)).final[0].velocity.x() == Approx(1).epsilon(1e-12));
}

TEST_CASE("the solver satisfies every contact of a random set, or has none", "[stepping]")
{
    using namespace carom::stepping;
    std::mt19937_64 random(11);
    for (int trial = 0; trial < 300; ++trial) {
        const std::size_t n = 2 + trial % 6;
        std::vector<Sphere> spheres;
        for (std::size_t i = 0; i < n; ++i)
            spheres.push_back(ball(1, Vec3::Zero(), uniform_vector(random, -1, 1), 0.5 + uniform(random)));
        Bodies bodies = make_bodies(scene_of(spheres));
        const std::vector<Vec3> start = bodies.velocity;
        std::vector<ContactRow> rows;
        for (std::size_t a = 0; a < n; ++a)
            for (std::size_t b = a + 1; b < n + 1; ++b) {
                if (uniform(random) < 0.5) continue;
                ContactRow row;
                row.contact.a = static_cast<BodyId>(a);
                row.contact.b = static_cast<BodyId>(b);  // n: a wall
                row.contact.normal = uniform_vector(random, -1, 1).normalized();
                row.least = 0.5 * uniform(random) - 0.5;
                rows.push_back(row);
            }
        Patience endless;
        const int sweeps = solve_contacts(bodies, rows, 100000, endless);
        CAPTURE(trial, sweeps);
        CHECK(sweeps < 100000);
        std::vector<Vec3> expected = start;
        for (const ContactRow& row : rows) {
            const auto a = static_cast<std::size_t>(row.contact.a), b = static_cast<std::size_t>(row.contact.b);
            expected[a] += row.impulse * bodies.inverse_mass[a] * row.contact.normal;
            if (b < n) expected[b] -= row.impulse * bodies.inverse_mass[b] * row.contact.normal;
            const Vec3 relative = b < n ? Vec3(bodies.velocity[a] - bodies.velocity[b]) : bodies.velocity[a];
            const double above = relative.dot(row.contact.normal) - row.least;
            CHECK(row.impulse >= 0);
            CHECK(above > -1e-8);
            CHECK(row.impulse * above < 1e-8);
        }
        for (std::size_t i = 0; i < n; ++i) CHECK((expected[i] - bodies.velocity[i]).norm() < 1e-10);
    }
}
