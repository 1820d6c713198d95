#include "laws/methods.hpp"
#include "support/scenes.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

using namespace carom;
using namespace carom::test;

TEST_CASE("law: an elastic run, reversed, comes back to its start; steps under gravity do not")
{
    for (const Claims& claims : methods()) {
        for (const Vec3& gravity : {Vec3(0, 0, 0), earth}) {
            const Scene scene = gas(1, 100, 1, gravity);
            REQUIRE(scene.spheres.size() == 100);
            const Outcome there = simulate(scene, claims.method);
            Scene mirrored = scene;
            for (std::size_t i = 0; i < scene.spheres.size(); ++i) {
                mirrored.spheres[i].position = there.final[i].position;
                mirrored.spheres[i].velocity = -there.final[i].velocity;
            }
            const Outcome back = simulate(mirrored, claims.method);
            INFO(claims.label << ", gravity " << gravity.norm() << ", impacts " << there.counts.impacts);
            CHECK(there.counts.impacts > 50);
            if (claims.exact) CHECK(back.counts.impacts == there.counts.impacts);
            double worst = 0;
            for (std::size_t i = 0; i < scene.spheres.size(); ++i) {
                worst = std::max(worst, (back.final[i].position - scene.spheres[i].position).norm());
                worst = std::max(worst, (back.final[i].velocity + scene.spheres[i].velocity).norm());
            }
            if (claims.exact)
                CHECK(worst <= 1e-9);
            else if (!gravity.isZero(0))
                CHECK(worst > 1e-6);
        }
    }
}
