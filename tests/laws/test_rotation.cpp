#include "laws/methods.hpp"
#include "support/scenes.hpp"

#include <catch2/catch.hpp>

using namespace carom;
using namespace carom::test;

namespace {

/// By 90 degrees about z and then 120 degrees about the diagonal: axes are permuted and signs change, nothing rounds.
Vec3 turned(const Vec3& x)
{
    return {x.z(), -x.y(), x.x()};
}

}  // namespace

TEST_CASE("law: a turned scene is the same run, turned")
{
    for (const Claims& claims : methods())
        for (const Vec3& gravity : {Vec3(0, 0, 0), earth}) {
            Scene scene = empty_scene(1, gravity);
            Random random(2);
            add_plane(scene, "floor", {0.1, 0.2, 1});
            fill_box(scene, random, 60, 6, 0.3, 0.5, 3);
            for (auto& s : scene.spheres) s.position.z() += 3;
            Scene other = scene;
            other.gravity = turned(scene.gravity);
            for (auto& s : other.spheres) {
                s.position = turned(s.position);
                s.velocity = turned(s.velocity);
            }
            for (auto& p : other.planes) p.normal = turned(p.normal);
            const Recorded a = record(scene, claims.method), b = record(other, claims.method);
            INFO(claims.label);
            REQUIRE(a.events.size() == b.events.size());
            if (claims.exact) CHECK(a.events.size() > 10);
            for (std::size_t i = 0; i < a.events.size(); ++i) {
                CHECK(a.events[i].a == b.events[i].a);
                CHECK(a.events[i].b == b.events[i].b);
                CHECK(b.events[i].time == Approx(a.events[i].time).epsilon(1e-11));
                CHECK((b.events[i].impulse - turned(a.events[i].impulse)).norm() <= 1e-10);
            }
            for (std::size_t i = 0; i < scene.spheres.size(); ++i)
                CHECK((b.outcome.final[i].position - turned(a.outcome.final[i].position)).norm() <= 1e-10);
        }
}
