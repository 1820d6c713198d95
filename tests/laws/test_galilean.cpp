#include "laws/methods.hpp"
#include "support/scenes.hpp"

#include <catch2/catch.hpp>

using namespace carom;
using namespace carom::test;

namespace {

Scene cloud(double attenuation)
{
    Scene scene = empty_scene(0.7, earth);
    scene.contacts = {{0, 0, {}, {}, attenuation}};
    Random random(1);
    fill_box(scene, random, 60, 6, 0.3, 0.5, 3);
    return scene;
}

/// Largest difference of the final positions, seen from a frame that moves with `velocity`.
double difference(const Scene& scene, const Method& method, const Vec3& velocity)
{
    Scene moving = scene;
    for (auto& s : moving.spheres) s.velocity += velocity;
    const Recorded a = record(scene, method), b = record(moving, method);
    CHECK(a.events.size() > 20);
    double worst = 0;
    for (std::size_t i = 0; i < scene.spheres.size(); ++i)
        worst = std::max(
            worst, (b.outcome.final[i].position - a.outcome.time * velocity - a.outcome.final[i].position).norm());
    return worst;
}

}  // namespace

TEST_CASE("law: a run looks the same from a moving frame, unless impacts attenuate velocities")
{
    for (const Claims& claims : methods()) {
        INFO(claims.label);
        CHECK(difference(cloud(1), claims.method, {5, -3, 2}) <= 1e-10);
        CHECK(difference(cloud(0.9), claims.method, {5, -3, 2}) > 1e-3);
    }
}
