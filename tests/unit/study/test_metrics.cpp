#include <carom/metrics.hpp>

#include "make_sphere.hpp"
#include "study/deepest_overlap.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>
#include <random>

using namespace carom;

namespace {

/// Uniform in [low, high) from the bits of the generator: the same on every machine.
double uniform(std::mt19937_64& generator, double low, double high)
{
    return low + (high - low) * static_cast<double>(generator() >> 11U) * 0x1p-53;
}

Scene cloud(std::size_t n, std::uint64_t seed, const Vec3& size)
{
    std::mt19937_64 generator(seed);
    Scene scene;
    scene.gravity = Vec3(0.5, 0, -9.81);
    for (std::size_t i = 0; i < n; ++i) {
        Sphere s;
        s.radius = uniform(generator, 0.01, 0.1);
        s.mass = uniform(generator, 0.5, 2);
        for (int axis = 0; axis < 3; ++axis) {
            s.position[axis] = uniform(generator, 0, size[axis]);
            s.velocity[axis] = uniform(generator, -1, 1);
        }
        scene.spheres.push_back(s);
    }
    scene.planes.push_back({"floor", Vec3::UnitZ(), 0, std::nullopt, 0});
    scene.planes.push_back({"plate", Vec3(0.6, 0, 0.8), 0.7, 0.02, 0});
    return scene;
}

double brute_force_penetration(const Scene& scene, const std::vector<BodyState>& states)
{
    double deepest = 0;
    for (std::size_t i = 0; i < states.size(); ++i) {
        for (const Plane& plane : scene.planes)
            deepest = std::max(deepest, -plane_gap(plane, scene.spheres[i], states[i].position));
        for (std::size_t j = 0; j < i; ++j)
            deepest = std::max(deepest, scene.spheres[i].radius + scene.spheres[j].radius -
                                            (states[i].position - states[j].position).norm());
    }
    return deepest;
}

}  // namespace

TEST_CASE("the deepest overlap is that of all pairs and planes", "[metrics]")
{
    std::mt19937_64 generator(9);
    for (std::uint64_t seed = 1; seed <= 60; ++seed) {
        // Long in one direction, dense and sparse, few and many: overlaps from none to thousands.
        const Vec3 size = seed % 3 == 0 ? Vec3(0.3, 9, 0.3) : seed % 3 == 1 ? Vec3(1, 1, 1) : Vec3(30, 2, 20);
        Scene scene = cloud(5 + 3 * seed, seed, size);
        if (seed % 4 != 0) scene.planes.clear();  // otherwise the planes hide the pairs
        if (seed % 5 == 0)                        // sizes of ratio 1000
            for (Sphere& s : scene.spheres) s.radius = std::pow(10, uniform(generator, -4, -1));
        if (seed % 6 == 0) scene.spheres[seed % scene.spheres.size()].radius = 0.7;
        if (seed % 7 == 0)  // a place where positions have no digits to spare
            for (Sphere& s : scene.spheres) s.position += Vec3(0x1p33, 0, 0);
        const std::vector<BodyState> states = initial_states(scene);
        CAPTURE(seed);
        CHECK(max_penetration(scene, states) ==
              Approx(brute_force_penetration(scene, states)).epsilon(1e-14).margin(1e-15));
    }
}

TEST_CASE("looking for the deepest overlap tests as many pairs as there are spheres, within a factor", "[metrics]")
{
    const auto tests_for_one = [](std::size_t n, double large) {
        const double side = std::cbrt(static_cast<double>(n));
        Scene scene = cloud(n, 3, Vec3::Constant(side));
        if (large > 0) scene.spheres[0].radius = large * side;
        study::DeepestOverlap overlap(scene);
        CHECK(overlap.of(initial_states(scene)) == max_penetration(scene, initial_states(scene)));
        return static_cast<double>(overlap.pair_tests()) / static_cast<double>(n);
    };
    for (const double large : {0.0, 0.25}) {  // a quarter of the box: it overlaps a share of the others
        CAPTURE(large);
        CHECK(tests_for_one(16'000, large) < 1.3 * tests_for_one(1'000, large));
        CHECK(tests_for_one(16'000, large) < 30);
    }
}

TEST_CASE("bodies that cannot move overlap nothing that cannot move", "[metrics]")
{
    Scene scene;
    for (int i = 0; i < 40; ++i) {
        scene.spheres.push_back(make_sphere("fixed", 0.5, Vec3(0.8 * i, 0, 0.25)));
        scene.spheres.back().fixed = true;
    }
    scene.planes.push_back({"floor", Vec3::UnitZ(), 0, std::nullopt, 0});
    CHECK(max_penetration(scene, initial_states(scene)) == 0);
    scene.spheres[3].fixed = false;
    CHECK(max_penetration(scene, initial_states(scene)) == Approx(0.25));  // the floor; 0.2 with its neighbours
    scene.planes.clear();
    CHECK(max_penetration(scene, initial_states(scene)) == Approx(0.2));
}

TEST_CASE("bodies that are nowhere overlap nothing", "[metrics]")
{
    Scene scene = cloud(50, 8, Vec3(1, 1, 1));
    std::vector<BodyState> states = initial_states(scene);
    states[4].position[1] = std::numeric_limits<double>::quiet_NaN();
    states[5].position = Vec3(0, 0, -std::numeric_limits<double>::infinity());
    Scene without = scene;
    std::vector<BodyState> others = states;
    for (const int gone : {5, 4}) {
        without.spheres.erase(without.spheres.begin() + gone);
        others.erase(others.begin() + gone);
    }
    CHECK(max_penetration(scene, states) == max_penetration(without, others));
}

TEST_CASE("spheres apart do not penetrate, and touching ones neither", "[metrics]")
{
    Scene scene;
    scene.spheres.push_back(make_sphere("a", 0.5, Vec3(0, 0, 0.5)));
    scene.spheres.push_back(make_sphere("b", 0.5, Vec3(1, 0, 0.5)));
    scene.planes.push_back({"floor", Vec3::UnitZ(), 0, std::nullopt, 0});
    CHECK(max_penetration(scene, initial_states(scene)) == 0);
    scene.spheres[1].position[0] = 0.75;
    CHECK(max_penetration(scene, initial_states(scene)) == 0.25);
}

TEST_CASE("bodies that cannot move penetrate nothing but those that can, and have not escaped", "[metrics]")
{
    Scene scene;
    scene.spheres.push_back(make_sphere("bump", 0.5, Vec3(0, 0, -0.25)));
    scene.spheres.push_back(make_sphere("next", 0.5, Vec3(0.125, 0, -0.25)));
    scene.spheres.push_back(make_sphere("ball", 0.5, Vec3(0, 0, 0.625)));
    scene.spheres[0].fixed = scene.spheres[1].fixed = true;
    scene.planes.push_back({"floor", Vec3::UnitZ(), 0, std::nullopt, 0});
    CHECK(max_penetration(scene, initial_states(scene)) == 0.125);  // 0.5 + 0.5 - 0.875, of ball and bump
    scene.spheres[2].position.z() = 3;
    CHECK(max_penetration(scene, initial_states(scene)) == 0);
    CHECK(escaped(scene, initial_states(scene)) == 0);
    scene.spheres[0].fixed = false;
    CHECK(max_penetration(scene, initial_states(scene)) == 0.875);  // of two that are 0.125 apart
    CHECK(escaped(scene, initial_states(scene)) == 1);
}

TEST_CASE("a plate penetrates from both sides and a half-space from one", "[metrics]")
{
    Scene scene;
    scene.spheres.push_back(make_sphere("a", 0.5, Vec3(0, 0, -0.4)));
    scene.planes.push_back({"plate", Vec3::UnitZ(), 0, 0.25, 0});
    CHECK(max_penetration(scene, initial_states(scene)) == Approx(0.225));
    scene.planes[0].thickness.reset();
    CHECK(max_penetration(scene, initial_states(scene)) == Approx(0.9));
}

TEST_CASE("energy and momentum are the sums over the bodies", "[metrics]")
{
    const Scene scene = cloud(50, 7, Vec3(3, 3, 3));
    const std::vector<BodyState> states = initial_states(scene);
    long double kinetic = 0, total = 0, momentum_x = 0;
    for (const Sphere& s : scene.spheres) {
        kinetic += static_cast<long double>(s.mass) * s.velocity.squaredNorm() / 2;
        total += static_cast<long double>(s.mass) * (s.velocity.squaredNorm() / 2 - scene.gravity.dot(s.position));
        momentum_x += static_cast<long double>(s.mass) * s.velocity[0];
    }
    CHECK(kinetic_energy(scene, states) == Approx(static_cast<double>(kinetic)).epsilon(1e-14));
    CHECK(total_energy(scene, states) == Approx(static_cast<double>(total)).epsilon(1e-14));
    CHECK(momentum(scene, states)[0] == Approx(static_cast<double>(momentum_x)).epsilon(1e-13));
}

TEST_CASE("a ball that fell one metre has the energy it had", "[metrics]")
{
    Scene scene;
    scene.gravity = Vec3(0, 0, -9.81);
    scene.spheres.push_back(make_sphere("ball", 0.1, Vec3(0, 0, 1.1)));
    scene.spheres.back().mass = 2;
    std::vector<BodyState> fallen = initial_states(scene);
    CHECK(total_energy(scene, fallen) == Approx(2 * 9.81 * 1.1));
    fallen[0].position[2] = 0.1;
    fallen[0].velocity[2] = -std::sqrt(2 * 9.81);
    CHECK(std::abs(energy_difference(scene, fallen, initial_states(scene))) < 1e-14);
}

TEST_CASE("who cannot move has no energy, wherever the scene puts it", "[metrics]")
{
    Scene scene;
    scene.gravity = Vec3(0, 0, -10);
    scene.spheres.push_back(make_sphere("ball", 0.5, Vec3(0, 0, 2)));
    scene.spheres.push_back(make_sphere("peg", 0.5, Vec3(4, 0, 1e6)));
    scene.spheres[0].mass = 3;
    scene.spheres[1].fixed = true;
    CHECK(total_energy(scene, initial_states(scene)) == 60);
    scene.spheres[1].position.z() = -1e6;
    CHECK(total_energy(scene, initial_states(scene)) == 60);
    scene.spheres[1].fixed = false;
    CHECK(total_energy(scene, initial_states(scene)) == 60 - 1e7);
}

TEST_CASE("an energy difference survives energies that are a billion times as large", "[metrics]")
{
    Scene scene;
    scene.gravity = Vec3(0, 0, -10);
    scene.spheres.push_back(make_sphere("ball", 0.1, Vec3(0, 0, 0x1p40)));
    scene.spheres.back().mass = 1;
    std::vector<BodyState> moved = initial_states(scene);
    moved[0].velocity = Vec3(0x1p-20, 0, 0);
    CHECK(energy_difference(scene, moved, initial_states(scene)) == 0x1p-41);
    CHECK(total_energy(scene, moved) - total_energy(scene, initial_states(scene)) == 0);  // what it is there to avoid
}

TEST_CASE("centres behind a half-space have escaped, behind a plate they have not", "[metrics]")
{
    Scene scene;
    for (const double z : {0.5, 0.01, -0.01, -3.0}) scene.spheres.push_back(make_sphere("s", 0.1, Vec3(0, 0, z)));
    scene.planes.push_back({"plate", Vec3::UnitZ(), 0, 0.1, 0});
    CHECK(escaped(scene, initial_states(scene)) == 0);
    scene.planes.push_back({"floor", Vec3::UnitZ(), 0, std::nullopt, 0});
    CHECK(escaped(scene, initial_states(scene)) == 2);
    std::vector<BodyState> states = initial_states(scene);
    states[0].position[1] = std::numeric_limits<double>::quiet_NaN();
    CHECK(escaped(scene, states) == 3);
}

TEST_CASE("deviations are root mean square and largest distances", "[metrics]")
{
    std::vector<BodyState> a(2), b(2);
    a[0].position = Vec3(3, 4, 0);
    b[1].velocity = Vec3(0, 0, -2);
    CHECK(position_deviation(a, b).max == 5);
    CHECK(position_deviation(a, b).rms == Approx(5 / std::sqrt(2.0)));
    CHECK(velocity_deviation(a, b).max == 2);
    a[1].position[0] = std::numeric_limits<double>::quiet_NaN();
    CHECK(std::isnan(position_deviation(a, b).max));
}

TEST_CASE("energy is kept only if every contact that can occur keeps it", "[metrics]")
{
    Scene scene;
    scene.materials = {{"steel", 1, 1, ""}, {"lead", 0.2, 1, ""}, {"felt", 1, 0.5, ""}};
    scene.spheres.push_back(make_sphere("a", 1));
    scene.spheres.back().material = 0;
    scene.planes.push_back({"floor", Vec3::UnitZ(), 0, std::nullopt, 0});
    CHECK(conserves_energy(scene));  // lead and felt are nowhere

    SECTION("a lossy wall")
    {
        scene.planes.push_back({"wall", Vec3::UnitX(), 0, std::nullopt, 2});
        CHECK_FALSE(conserves_energy(scene));
    }
    SECTION("one lossy sphere meets the floor")
    {
        scene.spheres.push_back(make_sphere("b", 1));
        scene.spheres.back().material = 1;
        CHECK_FALSE(conserves_energy(scene));
    }
    SECTION("a lossy material that no wall shares, and one sphere of it")
    {
        scene.planes.clear();
        scene.spheres = {make_sphere("b", 1)};
        scene.spheres.back().material = 1;
        CHECK(conserves_energy(scene));
        scene.spheres.push_back(scene.spheres[0]);
        CHECK_FALSE(conserves_energy(scene));
    }
    SECTION("attenuation between two of one kind needs two of them")
    {
        scene.contacts.push_back({0, 0, std::nullopt, std::nullopt, 0.9});
        CHECK(conserves_energy(scene));
        scene.spheres.push_back(scene.spheres[0]);
        CHECK_FALSE(conserves_energy(scene));
    }
    SECTION("lossy bodies that cannot move do not meet each other")
    {
        scene.planes[0].material = 1;
        scene.spheres.push_back(make_sphere("b", 1));
        scene.spheres.push_back(make_sphere("c", 1));
        for (const std::size_t peg : {1u, 2u}) {
            scene.spheres[peg].fixed = true;
            scene.spheres[peg].material = 1;
        }
        const auto lossless = [](int a, int b) { return ContactRule{a, b, 1.0, 1.0, std::nullopt}; };
        scene.contacts = {lossless(0, 1)};
        CHECK(conserves_energy(scene));
        scene.spheres[2].fixed = false;
        CHECK_FALSE(conserves_energy(scene));
        scene.contacts.push_back(lossless(1, 1));
        CHECK(conserves_energy(scene));
    }
}
