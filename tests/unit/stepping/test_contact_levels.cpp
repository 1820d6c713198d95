#include "stepping/contact_levels.hpp"

#include "small_scenes.hpp"

#include <catch2/catch.hpp>

#include <map>

using namespace carom;
using namespace carom::test;
using stepping::Bodies;
using stepping::Contact;
using stepping::ContactLevels;

namespace {

Contact touch(BodyId a, BodyId b)
{
    return {0, a, b, Vec3::UnitZ()};
}

Bodies spheres(std::size_t n, std::vector<std::size_t> fixed = {})
{
    Scene scene = scene_of(std::vector<Sphere>(n, ball(1, Vec3::Zero())));
    for (const std::size_t i : fixed) scene.spheres[i].fixed = true;
    return stepping::make_bodies(scene);
}

std::vector<std::pair<BodyId, BodyId>> pairs(const std::vector<Contact>& contacts)
{
    std::vector<std::pair<BodyId, BodyId>> all;
    for (const Contact& c : contacts) all.emplace_back(c.a, c.b);
    return all;
}

}  // namespace

TEST_CASE("Contacts are arranged from the ground up, those of one level as they were, the unsupported last",
          "[stepping]")
{
    // A pyramid 3-2-1 on wall 8: 0 is the top, 1 and 2 below it, 3, 4, 5 the base; 6 and 7 touch in the air.
    std::vector<Contact> contacts{touch(6, 7), touch(0, 1), touch(0, 2), touch(1, 3), touch(1, 4), touch(2, 4),
                                  touch(2, 5), touch(1, 2), touch(3, 8), touch(4, 8), touch(5, 8)};
    ContactLevels levels;
    levels.arrange(spheres(8), contacts);
    using Pairs = std::vector<std::pair<BodyId, BodyId>>;
    CHECK(pairs(contacts) ==
          Pairs{{3, 8}, {4, 8}, {5, 8}, {1, 3}, {1, 4}, {2, 4}, {2, 5}, {1, 2}, {0, 1}, {0, 2}, {6, 7}});
}

TEST_CASE("While a level is treated those below it are infinitely heavy, and only then", "[stepping]")
{
    // A chain upwards: fixed sphere 2, then 0, 3, 1; 4 and 5 hang on nothing.
    std::vector<Contact> contacts{touch(0, 2), touch(0, 3), touch(1, 3), touch(4, 5)};
    Bodies bodies = spheres(6, {2});
    const std::vector<double> before = bodies.inverse_mass;
    ContactLevels levels;
    levels.arrange(bodies, contacts);
    std::vector<std::vector<double>> seen;
    std::vector<std::pair<std::size_t, std::size_t>> ranges;
    levels.propagate(bodies, [&](std::size_t begin, std::size_t end) {
        ranges.emplace_back(begin, end);
        seen.push_back(bodies.inverse_mass);
    });
    CHECK(ranges == std::vector<std::pair<std::size_t, std::size_t>>{{0, 1}, {1, 2}, {2, 3}});
    REQUIRE(seen.size() == 3);
    CHECK(seen[0] == std::vector<double>{1, 1, 0, 1, 1, 1});
    CHECK(seen[1] == std::vector<double>{0, 1, 0, 1, 1, 1});
    CHECK(seen[2] == std::vector<double>{0, 1, 0, 0, 1, 1});
    CHECK(bodies.inverse_mass == before);
}

TEST_CASE("Without ground there is no level and nothing is propagated", "[stepping]")
{
    std::vector<Contact> contacts{touch(1, 2), touch(0, 1)};
    Bodies bodies = spheres(3);
    ContactLevels levels;
    levels.arrange(bodies, contacts);
    CHECK(pairs(contacts) == std::vector<std::pair<BodyId, BodyId>>{{1, 2}, {0, 1}});
    int calls = 0;
    levels.propagate(bodies, [&](std::size_t, std::size_t) { ++calls; });
    CHECK(calls == 0);
    std::vector<Contact> nothing;
    levels.arrange(bodies, nothing);
    CHECK(nothing.empty());
}
