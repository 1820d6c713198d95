#include "broad/cell_grid.hpp"

#include "broad/all_pairs.hpp"
#include "support/random.hpp"

#include <catch2/catch.hpp>
#include <set>

using namespace carom;
using carom::test::Random;

namespace {

template <class Broad>
std::multiset<BodyId> neighbours(const Broad& broad, BodyId body)
{
    std::multiset<BodyId> found;
    broad.neighbours(body, [&](BodyId other) { found.insert(other); });
    return found;
}

/// Spheres as points, where the grid believes them to be.
struct World {
    Frame frame;
    std::vector<Place> places;
    double reach;
    CellGrid grid;

    World(const Frame& f, std::vector<Place> p, double r) : frame(f), places(std::move(p)), reach(r), grid(f, places, r)
    {
    }

    /// Everybody within reach is found, once, and nobody is found by himself. Returns how many pairs are within reach.
    int require_complete() const
    {
        int close = 0;
        for (std::size_t i = 0; i < places.size(); ++i) {
            const auto body = static_cast<BodyId>(i);
            const auto found = neighbours(grid, body);
            CHECK(found.count(body) == 0);
            for (const BodyId other : found) CHECK(found.count(other) == 1);
            for (std::size_t j = 0; j < places.size(); ++j) {
                if (i == j) continue;
                const Vec3 r = test_separation(places[i], places[j]);
                if (r.norm() > reach) continue;
                ++close;
                CHECK(found.count(static_cast<BodyId>(j)) == 1);
            }
        }
        return close;
    }

    Vec3 test_separation(const Place& a, const Place& b) const
    {
        Vec3 r;
        for (int k = 0; k < 3; ++k)
            r[k] = static_cast<double>(a.cell[k] - b.cell[k]) * frame.cell_size + (a.local[k] - b.local[k]);
        return r;
    }

    /// Move a body and step the grid through every wall on its way.
    int move(BodyId body, const Vec3& displacement)
    {
        Place& place = places[static_cast<std::size_t>(body)];
        place = moved(frame, place, displacement);
        int steps = 0;
        for (int axis = 0; axis < 3; ++axis) {
            for (; grid.above_lower_wall(frame, body, axis, place) < 0; ++steps) grid.step(body, axis, -1);
            for (; grid.below_upper_wall(frame, body, axis, place) < 0; ++steps) grid.step(body, axis, 1);
        }
        return steps;
    }
};

World scattered(Random& random, int count, double side, double reach, const Vec3& centre)
{
    const Frame frame{1, 2 * power_of_two_below(reach)};
    std::vector<Place> places;
    for (int i = 0; i < count; ++i) places.push_back(moved(frame, place_at(frame, centre), random.in_cube(side / 2)));
    return {frame, places, reach};
}

}  // namespace

TEST_CASE("every pair within reach is found, near and 1e9 away from the origin")
{
    Random random(1);
    for (const Vec3& centre : {Vec3(0, 0, 0), Vec3(1e9, -1e9, 3e8), Vec3(-123.456, 0.1, 1e9)})
        for (const double side : {2.0, 10.0, 50.0}) {
            const World world = scattered(random, 150, side, 1.1, centre);
            CHECK(world.require_complete() >= (side < 20 ? 50 : 0));
        }
}

TEST_CASE(
    "every pair within reach is found after random moves, however far "
    "some have gone")
{
    Random random(2);
    for (const Vec3& centre : {Vec3(0, 0, 0), Vec3(1e9, -1e9, 3e8)}) {
        World world = scattered(random, 80, 10, 1.1, centre);
        int steps = 0;
        for (int round = 0; round < 20; ++round) {
            for (BodyId body = 0; body < 80; ++body) steps += world.move(body, random.in_cube(body < 3 ? 500 : 1));
            world.require_complete();
        }
        CHECK(steps > 1000);
    }
}

TEST_CASE(
    "bodies that share an entry of the table without being near are told "
    "apart")
{
    // Two clusters, a multiple of any table length apart.
    const Frame frame{1, 1};
    std::vector<Place> places;
    for (int i = 0; i < 8; ++i) {
        places.push_back(place_at(frame, {0.3 * i, 0.1, 0.2}));
        places.push_back(place_at(frame, {0.3 * i + 0x1p30, 0.1, 0.2}));
    }
    const World world(frame, places, 1);
    world.require_complete();
    for (BodyId i = 0; i < 16; ++i)
        for (const BodyId other : neighbours(world.grid, i)) CHECK(other % 2 == i % 2);
}

TEST_CASE("the walls of a body's cell enclose its place to the bit")
{
    Random random(4);
    for (const Vec3& centre : {Vec3(0, 0, 0), Vec3(1e9, -1e9, 3e8)}) {
        const World world = scattered(random, 200, 10, 0.37, centre);
        for (BodyId body = 0; body < 200; ++body)
            for (int axis = 0; axis < 3; ++axis) {
                const Place& place = world.places[static_cast<std::size_t>(body)];
                const double above = world.grid.above_lower_wall(world.frame, body, axis, place);
                const double below = world.grid.below_upper_wall(world.frame, body, axis, place);
                // Filed by a coordinate rounded to a double: that far it may be off its cell.
                CHECK(above >= -1e-16 * 1e9);
                CHECK(below >= -1e-16 * 1e9);
                CHECK(above + below >= 0.37);
            }
    }
}

TEST_CASE("all pairs visits everybody else")
{
    const AllPairs pairs(4);
    CHECK(neighbours(pairs, 0) == std::multiset<BodyId>{1, 2, 3});
    CHECK(neighbours(pairs, 2) == std::multiset<BodyId>{0, 1, 3});
    CHECK(neighbours(AllPairs(1), 0).empty());
}
