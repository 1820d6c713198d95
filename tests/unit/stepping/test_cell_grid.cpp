#include "small_scenes.hpp"
#include "stepping/detection.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>
#include <set>

using namespace carom;
using namespace carom::test;
using stepping::Contact;
using stepping::Detector;

namespace {

struct Found {
    std::vector<Contact> contacts;
    std::int64_t tests;
};

Found find(const Scene& scene, BroadPhase how)
{
    const auto bodies = stepping::make_bodies(scene);
    Detector detector(scene, how);
    Found found;
    for (int repeat = 0; repeat < 2; ++repeat) {  // the second build must forget the first
        found.contacts.clear();
        detector.tests = 0;
        detector.find_pairs(bodies.position, bodies.radius, found.contacts);
    }
    found.tests = detector.tests;
    return found;
}

/// The contacts of all pairs, after checking that the grid finds the same ones to the last bit.
Found compare(const Scene& scene)
{
    const Found slow = find(scene, BroadPhase::all_pairs);
    const Found fast = find(scene, BroadPhase::cell_grid);
    REQUIRE(fast.contacts.size() == slow.contacts.size());
    for (std::size_t k = 0; k < slow.contacts.size(); ++k) {
        REQUIRE(fast.contacts[k].a == slow.contacts[k].a);
        REQUIRE(fast.contacts[k].b == slow.contacts[k].b);
        REQUIRE(fast.contacts[k].gap == slow.contacts[k].gap);
        REQUIRE(fast.contacts[k].normal == slow.contacts[k].normal);
    }
    const auto n = static_cast<std::int64_t>(scene.spheres.size());
    CHECK(slow.tests == n * (n - 1) / 2);
    return fast;
}

Scene random_spheres(std::size_t n, double low, double high, double smallest, double largest, std::uint64_t seed)
{
    std::mt19937_64 random(seed);
    std::vector<Sphere> spheres;
    for (std::size_t i = 0; i < n; ++i) {
        const double radius = smallest + (largest - smallest) * uniform(random);
        spheres.push_back(ball(radius, uniform_vector(random, low, high)));
    }
    return scene_of(std::move(spheres));
}

}  // namespace

TEST_CASE("The cell grid finds the contacts of all pairs in a dense heap", "[stepping]")
{
    for (const std::uint64_t seed : {1, 2, 3, 4, 5}) {
        const Found found = compare(random_spheres(700, -1, 1, 0.05, 0.05, seed));
        CHECK(found.contacts.size() > 50);
        CHECK(found.tests < 700 * 40);
    }
}

TEST_CASE("The cell grid finds the contacts of all pairs for radii of ratio 10", "[stepping]")
{
    for (const std::uint64_t seed : {1, 2, 3})
        CHECK(compare(random_spheres(600, -1, 1, 0.01, 0.1, seed)).contacts.size() > 100);
}

TEST_CASE("The cell grid finds the contacts of all pairs for any small number of spheres", "[stepping]")
{
    std::size_t contacts = 0;
    for (std::size_t n = 1; n < 90; ++n)
        contacts += compare(random_spheres(n, -0.3, 0.3, 0.05, 0.1, n)).contacts.size();
    CHECK(contacts > 1000);
}

TEST_CASE("The cell grid finds contacts among spheres scattered over a million diameters, and tests few pairs",
          "[stepping]")
{
    std::mt19937_64 random(7);
    const double r = 0.5;
    std::vector<Sphere> spheres;
    for (int i = 0; i < 400; ++i) {  // each place has two spheres whose gap is as often positive as negative
        const Vec3 p = uniform_vector(random, -1e6, 1e6);
        const Vec3 direction = uniform_vector(random, -1, 1).normalized();
        const double distance = 2 * r * (0.5 + uniform(random));
        spheres.push_back(ball(r, p));
        spheres.push_back(ball(r, p + distance * direction));
    }
    const Found found = compare(scene_of(std::move(spheres)));
    CHECK(found.contacts.size() > 150);
    CHECK(found.contacts.size() < 250);
    CHECK(found.tests < 800 * 10);
}

TEST_CASE("The cell grid finds contacts along lines and in layers, and tests few pairs", "[stepping]")
{
    for (int axis = 0; axis < 3; ++axis) {
        std::vector<Sphere> line, layer;
        for (int i = 0; i < 900; ++i) {
            line.push_back(ball(0.5, (0.999 * i - 300) * Vec3::Unit(axis)));
            layer.push_back(
                ball(0.5, 0.999 * (i % 30) * Vec3::Unit(axis) + 0.999 * (i / 30) * Vec3::Unit((axis + 1) % 3)));
        }
        const Found in_line = compare(scene_of(line));
        CHECK(in_line.contacts.size() == 899);
        CHECK(in_line.tests < 900 * 14);
        const Found in_layer = compare(scene_of(layer));
        CHECK(in_layer.contacts.size() == 2 * 30 * 29);
        CHECK(in_layer.tests < 900 * 20);
    }
}

TEST_CASE("Escaped spheres cost the cell grid neither contacts nor memory", "[stepping]")
{
    Scene scene = random_spheres(300, -1, 1, 0.1, 0.1, 3);
    const std::size_t near_contacts = compare(scene).contacts.size();
    scene.spheres[10].position = Vec3(1e15, 0, 0);
    scene.spheres[20].position = Vec3(1e15, 0, 0.15);
    scene.spheres[30].position = Vec3(-1e300, 1e300, 0);
    scene.spheres[40].position.x() = std::numeric_limits<double>::infinity();
    scene.spheres[50].position.y() = std::numeric_limits<double>::quiet_NaN();
    const Found found = compare(scene);
    CHECK(found.contacts.size() < near_contacts);
    CHECK(std::any_of(found.contacts.begin(), found.contacts.end(),
                      [](const Contact& c) { return c.a == 10 && c.b == 20; }));
}

TEST_CASE("A look around a sphere of any size misses no sphere that it touches and meets none twice", "[stepping]")
{
    const Scene scene = random_spheres(500, -1, 1, 0.02, 0.1, 11);
    const auto bodies = stepping::make_bodies(scene);
    Detector detector(scene, BroadPhase::cell_grid);
    std::vector<Contact> contacts;
    detector.find_pairs(bodies.position, bodies.radius, contacts);
    std::mt19937_64 random(12);
    for (const double radius : {0.001, 0.02, 0.1, 0.3, 3.0}) {
        CAPTURE(radius);
        std::size_t hits = 0, candidates = 0;
        for (int k = 0; k < 300; ++k) {
            const Vec3 p = uniform_vector(random, -1.2, 1.2);
            std::set<BodyId> near;
            detector.for_each_near(p, radius, [&](BodyId j) { REQUIRE(near.insert(j).second); });
            candidates += near.size();
            for (BodyId j = 0; j < 500; ++j) {
                const auto i = static_cast<std::size_t>(j);
                if ((bodies.position[i] - p).norm() > radius + bodies.radius[i]) continue;
                ++hits;
                REQUIRE(near.count(j) == 1);
            }
        }
        CHECK(hits > 10);
        if (radius < 0.2) CHECK(candidates < 300 * 500 / 4);
    }
}

namespace {

/// A lattice whose neighbours overlap a little, 1.9 radii apart, around `centre`.
std::vector<Sphere> lattice(int along, double radius, const Vec3& centre)
{
    std::vector<Sphere> spheres;
    for (int x = 0; x < along; ++x)
        for (int y = 0; y < along; ++y)
            for (int z = 0; z < along; ++z)
                spheres.push_back(
                    ball(radius, centre + 1.9 * radius * Vec3(x - along / 2, y - along / 2, z - along / 2)));
    return spheres;
}

}  // namespace

TEST_CASE("Tests of pairs grow with the number of spheres, also with a large sphere or a thousand sizes among them",
          "[stepping]")
{
    for (const int along : {8, 16, 25}) {
        const auto n = static_cast<std::int64_t>(along) * along * along;
        CAPTURE(n);
        std::vector<Sphere> with_large = lattice(along, 0.5, Vec3::Zero());
        with_large.push_back(ball(0.25 * along, Vec3::Zero()));
        CHECK(find(scene_of(with_large), BroadPhase::cell_grid).tests < 50 * n);

        std::vector<Sphere> graded = lattice(along, 0.5, Vec3::Zero());
        for (std::size_t i = 0; i < graded.size(); ++i)
            graded[i].radius = 0.5 / (1 + 999 * static_cast<double>(i) / static_cast<double>(graded.size()));
        CHECK(find(scene_of(graded), BroadPhase::cell_grid).tests < 60 * n);

        CHECK(find(scene_of(lattice(along, 0.5, Vec3(1e12, -3e12, 0))), BroadPhase::cell_grid).tests < 40 * n);
    }
}

TEST_CASE(
    "The cell grid finds the contacts of all pairs with a large sphere among small ones, for radii of ratio 1000 "
    "and far from the origin",
    "[stepping]")
{
    Scene with_large = random_spheres(700, -1, 1, 0.02, 0.02, 5);
    with_large.spheres.push_back(ball(0.6, Vec3(0.1, 0.2, 0.3)));
    with_large.spheres.push_back(ball(30, Vec3(31, 0, 0)));
    CHECK(compare(with_large).contacts.size() > 80);

    std::mt19937_64 random(6);
    Scene graded = random_spheres(700, -1, 1, 0.2, 0.2, 6);
    for (Sphere& s : graded.spheres) s.radius *= std::pow(1000, -uniform(random));
    CHECK(compare(graded).contacts.size() > 100);

    Scene far = random_spheres(700, -1, 1, 0.05, 0.1, 7);
    for (Sphere& s : far.spheres) s.position += Vec3(0x1p40, 0, -0x1p41);
    CHECK(compare(far).contacts.size() > 100);
    far.spheres[0].position = Vec3(1e300, 0, 0);  // a home that no other sphere is near
    CHECK(compare(far).contacts.size() > 100);
}

TEST_CASE("Walls are found sphere by sphere, plates from both sides", "[stepping]")
{
    const Scene scene =
        scene_of({ball(0.1, Vec3(0, 0, 0.05)), ball(0.1, Vec3(0, 0, -0.05)), ball(0.1, Vec3(0, 0, 0.2))},
                 {wall(Vec3::UnitZ(), -0.1), plate(Vec3::UnitZ(), 0, 0.02), wall(-Vec3::UnitZ(), -0.25)});
    const auto bodies = stepping::make_bodies(scene);
    Detector detector(scene);
    std::vector<Contact> contacts;
    detector.find_walls(bodies.position, bodies.radius, contacts);
    REQUIRE(contacts.size() == 4);
    CHECK(detector.tests == 9);
    CHECK((contacts[0].a == 0 && contacts[0].b == 4));
    CHECK(contacts[0].normal.z() == 1);
    CHECK(contacts[0].gap == Approx(-0.06));
    CHECK((contacts[1].a == 1 && contacts[1].b == 3));
    CHECK(contacts[1].gap == Approx(-0.05));
    CHECK((contacts[2].a == 1 && contacts[2].b == 4));
    CHECK(contacts[2].normal.z() == -1);
    CHECK(contacts[2].gap == Approx(-0.06));
    CHECK((contacts[3].a == 2 && contacts[3].b == 5));
    std::vector<Contact> one_by_one;
    for (BodyId i = 0; i < 3; ++i)
        detector.find_walls_of(i, bodies.position[static_cast<std::size_t>(i)], 0.1, one_by_one);
    REQUIRE(one_by_one.size() == contacts.size());
    for (std::size_t k = 0; k < contacts.size(); ++k) CHECK(one_by_one[k].gap == contacts[k].gap);
}
