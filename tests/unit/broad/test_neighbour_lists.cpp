#include "broad/neighbour_lists.hpp"

#include "flight/flight.hpp"
#include "support/random.hpp"

#include <catch2/catch.hpp>

#include <algorithm>

using namespace carom;
using carom::test::Random;

namespace {

bool has(const NeighbourLists& lists, BodyId body, BodyId other)
{
    const auto list = lists.of(body);
    return std::count(list.begin(), list.end(), other) == 1;
}

}  // namespace

TEST_CASE(
    "two bodies within their reach are in each other's lists, whatever "
    "the way of each within its ball")
{
    for (const Vec3& centre : {Vec3(0, 0, 0), Vec3(1e9, -1e9, 3e8)}) {
        Random random(1);
        const Frame frame{1, 0.5};
        std::vector<Place> places;
        std::vector<double> reaches;
        for (int i = 0; i < 300; ++i) {
            places.push_back(place_at(frame, centre + random.in_cube(3)));
            reaches.push_back(random.uniform(0.2, 0.4));
        }
        Place origin;
        std::copy_n(places.front().cell, 3, origin.cell);
        NeighbourLists lists(frame, origin, places, reaches, 0.3);
        int close = 0, filed = 0;
        for (int round = 0; round < 30; ++round) {
            for (BodyId i = 0; i < 300; ++i) {
                Place& place = places[static_cast<std::size_t>(i)];
                place = moved(frame, place, random.in_cube(0.1));
                const Vec3 position = separation(frame, place, origin);
                if ((position - lists.centre(i)).norm() <= lists.escape_radius()) continue;
                lists.file(i, position);
                ++filed;
                CHECK((lists.centre(i) - position).norm() == 0);
            }
            for (BodyId i = 0; i < 300; ++i) {
                CHECK_FALSE(has(lists, i, i));
                for (BodyId j = 0; j < 300; ++j) {
                    if (i == j) continue;
                    CHECK(has(lists, i, j) == has(lists, j, i));
                    const double distance =
                        separation(frame, places[static_cast<std::size_t>(i)], places[static_cast<std::size_t>(j)])
                            .norm();
                    if (distance > reaches[static_cast<std::size_t>(i)] + reaches[static_cast<std::size_t>(j)])
                        continue;
                    ++close;
                    CHECK(has(lists, i, j));
                }
            }
        }
        CHECK(close > 5'000);
        CHECK(filed > 1'000);
    }
}

TEST_CASE("a list grows beyond the room that it had")
{
    const Frame frame{1, 0.5};
    const std::vector<Place> places(100, place_at(frame, {0.1, 0.2, 0.3}));
    NeighbourLists lists(frame, {}, places, std::vector<double>(100, 0.5), 0.1);
    for (BodyId i = 0; i < 100; ++i) CHECK(lists.of(i).size() == 99);
    lists.file(7, {5, 5, 5});
    CHECK(lists.of(7).empty());
    CHECK_FALSE(has(lists, 8, 7));
    CHECK(lists.of(8).size() == 98);
}
