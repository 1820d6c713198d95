#include "laws/methods.hpp"
#include "support/scenes.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

using namespace carom;
using namespace carom::test;

TEST_CASE("law: the order in which spheres and planes are listed does not matter")
{
    for (const Claims& claims : methods())
        for (const Vec3& gravity : {Vec3(0, 0, 0), earth}) {
            if (!claims.exact) continue;
            const Scene scene = gas(5, 60, 1, gravity);
            Scene other = scene;
            std::reverse(other.spheres.begin(), other.spheres.end());
            std::reverse(other.planes.begin(), other.planes.end());
            const Recorded a = record(scene, claims.method), b = record(other, claims.method);
            INFO(claims.label);
            CHECK(a.events.size() > 30);
            REQUIRE(a.events.size() == b.events.size());
            for (std::size_t i = 0; i < a.events.size(); ++i)
                CHECK(b.events[i].time == Approx(a.events[i].time).epsilon(1e-12));
            const std::size_t n = scene.spheres.size();
            for (std::size_t i = 0; i < n; ++i)
                CHECK((a.outcome.final[i].position - b.outcome.final[n - 1 - i].position).norm() <= 1e-11);
        }
}
