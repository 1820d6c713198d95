#include <catch2/catch.hpp>
#include <chrono>
#include <limits>
#include <set>

#include "core/random.hpp"
#include "scene/pair_gap.hpp"
#include "scene/sphere_grid.hpp"
#include "scene/validate.hpp"

using namespace carom;

namespace {

Sphere ball(const std::string& id, double radius, const Vec3& position)
{
    Sphere s;
    s.id = id;
    s.radius = radius;
    s.position = position;
    return s;
}

Scene scene_of(std::vector<Sphere> spheres)
{
    Scene s;
    s.end_time = 1;
    s.spheres = std::move(spheres);
    return s;
}

Plane floor_plane(std::optional<double> thickness = {})
{
    Plane p;
    p.id = "floor";
    p.thickness = thickness;
    return p;
}

}  // namespace

TEST_CASE("overlapping spheres are named with depth and cure, touching ones are not", "[scene]")
{
    CHECK(find_overlaps(scene_of({ball("a", 1, {0, 0, 0}), ball("b", 1, {2, 0, 0})}), false).empty());
    CHECK(find_overlaps(scene_of({ball("a", 1, {0, 0, 0}), ball("b", 1, {2 - 0.9e-9, 0, 0})}), false).empty());
    CHECK(find_overlaps(scene_of({ball("a", 1, {0, 0, 0}), ball("b", 1, {2 - 1.1e-9, 0, 0})}), false).size() == 1);
    // The tolerance follows the smaller of the two.
    CHECK(find_overlaps(scene_of({ball("a", 1, {0, 0, 0}), ball("b", 0.1, {1.1 - 0.9e-9, 0, 0})}), false).size() == 1);
    const auto lines = find_overlaps(scene_of({ball("a", 1, {0, 0, 0}), ball("b", 0.5, {0, 1.25, 0})}), false);
    REQUIRE(lines.size() == 1);
    CHECK(lines[0].find(
              "/spheres/1: sphere \"b\" overlaps sphere \"a\" (/spheres/0) by 0.25 (move one by at least 0.250") == 0);
    CHECK(lines[0].find("or pass --allow-overlap") != std::string::npos);
    CHECK(find_overlaps(scene_of({ball("a", 1, {0, 0, 0}), ball("b", 0.5, {0, 1.25, 0})}), true).empty());
}

TEST_CASE("a sphere in a wall or in a plate overlaps it", "[scene]")
{
    Scene s = scene_of({ball("a", 1, {0, 0, 0.75})});
    s.planes = {floor_plane()};
    REQUIRE(find_overlaps(s, false).size() == 1);
    CHECK(find_overlaps(s, false)[0].find("sphere \"a\" overlaps plane \"floor\" (/planes/0) by 0.25") !=
          std::string::npos);
    CHECK(find_overlaps(s, true).empty());
    s.planes = {floor_plane(0.5)};
    s.spheres[0].position.z() = -1.25;  // touches the plate from below
    CHECK(find_overlaps(s, false).empty());
    s.spheres[0].position.z() = -1.125;
    CHECK(find_overlaps(s, false).size() == 1);
}

TEST_CASE("a centre inside a plate has no side, even where overlap is allowed", "[scene]")
{
    Scene s = scene_of({ball("a", 1, {0, 0, 0.25})});
    s.planes = {floor_plane(0.5)};
    for (const bool allow : {false, true}) {
        const auto lines = find_overlaps(s, allow);
        REQUIRE(lines.size() == 1);
        CHECK(lines[0].find("the centre of sphere \"a\" is inside plate \"floor\"") != std::string::npos);
    }
    s.planes = {floor_plane(0.0)};
    s.spheres[0].position.z() = 0;
    CHECK(find_overlaps(s, true).size() == 1);
    s.spheres[0].position.z() = 1e-9;
    CHECK(find_overlaps(s, true).empty());
}

TEST_CASE("bodies that cannot move may overlap each other, and nothing else may overlap them", "[scene]")
{
    Scene s = scene_of({ball("bump", 1, {0, 0, 0}), ball("next", 1, {0.5, 0, -3}), ball("a", 1, {0, 0, 2})});
    for (const std::size_t i : {0u, 1u}) s.spheres[i].fixed = true;
    s.spheres[1].position = {0.5, 0, 0};
    s.spheres[2].position = {0.25, 0, 2};
    s.planes = {floor_plane(), floor_plane(0.5)};  // cut through both; one is behind nothing and inside a plate
    s.planes[1].id = "plate";
    CHECK(find_overlaps(s, false).empty());
    s.spheres[2].position = {0.25, 0, 1.75};
    CHECK(find_overlaps(s, false).size() == 2);  // with both bumps
    s.spheres[2].position = {5, 0, 0.75};
    CHECK(find_overlaps(s, false).size() == 2);  // with floor and plate
    s.spheres[2].position = {0.25, 0, 2};
    s.spheres[1].fixed = false;
    CHECK(find_overlaps(s, false).size() == 3);  // it moves among the others: inside the plate, in the floor, in a bump
}

TEST_CASE("many overlaps are counted after the first twenty", "[scene]")
{
    std::vector<Sphere> row;
    for (int i = 0; i < 31; ++i) row.push_back(ball("s" + std::to_string(i), 1, {1.5 * i, 0, 0}));
    const auto lines = find_overlaps(scene_of(row), false);
    REQUIRE(lines.size() == 21);
    CHECK(lines.back() == "/spheres: and 10 more overlaps");
    std::vector<Sphere> heap(2000, ball("s", 1, {0, 0, 0}));
    CHECK(find_overlaps(scene_of(heap), false).back() == "/spheres: and at least 9980 more overlaps");
}

TEST_CASE("the grid finds the same overlaps as a look at all pairs, for any mix of sizes", "[scene]")
{
    Random random(11);
    std::size_t overlaps = 0;
    for (int round = 0; round < 40; ++round) {
        const double spread = round % 2 == 0 ? 1 : 1000;  // of the radii
        std::vector<Sphere> spheres;
        for (int i = 0; i < 200; ++i) {
            const double u = random.uniform();
            const double radius = 0.3 / (1 + (spread - 1) * u * u);
            const double x = random.uniform(-4, 4), y = random.uniform(-4, 4), z = random.uniform(-1, 1);
            spheres.push_back(ball(std::to_string(i), radius, {x, y, z}));
        }
        std::vector<double> radii;
        for (const auto& s : spheres) radii.push_back(s.radius);
        using Pairs = std::set<std::pair<std::size_t, std::size_t>>;
        const auto overlap = [&](std::size_t i, std::size_t j) {
            return sphere_gap(spheres[i].position, radii[i], spheres[j].position, radii[j]) < 0;
        };
        Pairs expected, found;
        for (std::size_t i = 0; i < spheres.size(); ++i)
            for (std::size_t j = 0; j < i; ++j)
                if (overlap(i, j)) expected.insert({j, i});
        SphereGrid grid;
        for (const std::size_t i : largest_first(radii)) {
            grid.visit_near(spheres[i].position, radii[i], [&](std::size_t j) {
                if (overlap(i, j)) CHECK(found.insert({std::min(i, j), std::max(i, j)}).second);
                return true;
            });
            grid.insert(i, spheres[i].position, radii[i]);
        }
        CHECK(found == expected);
        overlaps += expected.size();
    }
    CHECK(overlaps > 200);
}

TEST_CASE("a grid that knows its radii takes spheres in any order, moves and forgets them", "[scene]")
{
    Random random(5);
    std::vector<double> radii;
    for (int i = 0; i < 300; ++i) radii.push_back(random.uniform(0.01, 0.5));
    SphereGrid grid(radii);
    for (int round = 0; round < 3; ++round) {
        grid.clear();
        std::vector<Vec3> places;
        std::size_t found = 0, expected = 0;
        for (std::size_t i = 0; i < radii.size(); ++i) {
            const double x = random.uniform(-2, 2), y = random.uniform(-2, 2), z = random.uniform(-2, 2);
            const Vec3 place(x, y, z);
            const auto overlap = [&](std::size_t j) { return sphere_gap(place, radii[i], places[j], radii[j]) < 0; };
            for (std::size_t j = 0; j < i; ++j) expected += overlap(j) ? 1 : 0;
            grid.visit_near(place, radii[i], [&](std::size_t j) {
                REQUIRE(j < i);
                found += overlap(j) ? 1 : 0;
                return true;
            });
            grid.insert(i, place, radii[i]);
            places.push_back(place);
            if (i % 3 > 0) continue;
            Vec3& moved = places[i / 2];  // some of them again and again, some by less than a cell
            const Vec3 to = moved + (i % 2 == 0 ? 0.01 : 1.0) * Vec3(0.5 - random.uniform(), 1, 0);
            grid.move(i / 2, moved, to, radii[i / 2]);
            moved = to;
        }
        CHECK(found == expected);
        CHECK(expected > 100);
    }
}

TEST_CASE("a grid takes places that are out of every range", "[scene]")
{
    SphereGrid grid;
    const double inf = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();
    std::size_t n = 0;
    for (const double x : {0.0, 1e300, -1e300, inf, -inf, nan}) grid.insert(n++, Vec3(x, 0, x), 1);
    std::set<std::size_t> near;
    grid.visit_near(Vec3(1e300, 0, 1e300), 1, [&](std::size_t i) { return near.insert(i).second; });
    CHECK(near.contains(1));
}

TEST_CASE("gaps are right for lengths of any size", "[scene]")
{
    for (const double scale : {1.0, 1e-160, 1e150, 1e-300}) {
        CHECK(sphere_gap({0, 0, 0}, scale, {3 * scale, 4 * scale, 0}, scale) == Approx(3 * scale));
        CHECK(find_overlaps(scene_of({ball("a", scale, {0, 0, 0}), ball("b", scale, {2.5 * scale, 0, 0})}), false)
                  .empty());
        CHECK(find_overlaps(scene_of({ball("a", scale, {0, 0, 0}), ball("b", scale, {1.5 * scale, 0, 0})}), false)
                  .size() == 1);
    }
}

TEST_CASE("a hundred thousand spheres are validated in a second", "[scene]")
{
    std::vector<Sphere> spheres;
    for (int i = 0; i < 100'000; ++i)
        spheres.push_back(ball("s" + std::to_string(i), 0.5, {1.0 * (i % 50), 1.0 * (i / 50 % 50), 1.0 * (i / 2500)}));
    Scene s = scene_of(spheres);
    s.planes = {floor_plane()};
    s.planes[0].offset = -0.5;
    const auto start = std::chrono::steady_clock::now();
    CHECK(validate(s).empty());
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
    // All pairs would take half a minute; the factor is for debug builds, sanitizers and busy machines.
    CHECK(taken.count() < 10);
    s.spheres[77'777].position.x() += 1e-6;
    CHECK(validate(s).size() == 1);
}
