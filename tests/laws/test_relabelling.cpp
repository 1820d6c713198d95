#include "laws/methods.hpp"
#include "support/scenes.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

using namespace carom;
using namespace carom::test;

namespace {

/// Couples that meet alone, far from the others, and a floor on which no two spheres of a couple land in one step.
Scene couples()
{
    Scene scene = empty_scene(1, earth);
    Random random(8);
    add_floor(scene);
    for (int i = 0; i < 20; ++i) {
        const Vec3 place(10.0 * i, 0, random.uniform(2, 4));
        const Vec3 way = random.direction(), across = random.across(way);
        const double r = random.uniform(0.2, 0.5), speed = random.uniform(2, 4);
        add_sphere(scene, r, place - 0.8 * way + 0.1 * across, speed * way, random.uniform(1, 5));
        add_sphere(scene, 0.2, place + 0.8 * way, -speed * way, random.uniform(1, 5));
    }
    return scene;
}

Scene reversed(Scene scene)
{
    std::reverse(scene.spheres.begin(), scene.spheres.end());
    std::reverse(scene.planes.begin(), scene.planes.end());
    return scene;
}

void require_same(const Scene& scene, const Claims& claims)
{
    const Recorded a = record(scene, claims.method), b = record(reversed(scene), claims.method);
    INFO(claims.label << ", gravity " << scene.gravity.norm());
    CHECK(a.events.size() > 30);
    REQUIRE(a.events.size() == b.events.size());
    // Impacts of one step carry one time: sorted by it, not one by one.
    std::vector<double> times_a, times_b;
    for (const Event& e : a.events) times_a.push_back(e.time);
    for (const Event& e : b.events) times_b.push_back(e.time);
    std::sort(times_a.begin(), times_a.end());
    std::sort(times_b.begin(), times_b.end());
    for (std::size_t i = 0; i < times_a.size(); ++i) CHECK(times_b[i] == Approx(times_a[i]).epsilon(1e-12));
    const std::size_t n = scene.spheres.size();
    for (std::size_t i = 0; i < n; ++i)
        CHECK((a.outcome.final[i].position - b.outcome.final[n - 1 - i].position).norm() <= 1e-11);
}

}  // namespace

TEST_CASE("law: where contacts do not share a sphere their order does not matter to anybody")
{
    for (const Claims& claims : methods()) require_same(couples(), claims);
}

TEST_CASE("law: the order in which spheres and planes are listed does not matter")
{
    for (const Claims& claims : methods())
        for (const Vec3& gravity : {Vec3(0, 0, 0), earth})
            if (claims.any_order) require_same(gas(5, 60, 1, gravity), claims);
}
