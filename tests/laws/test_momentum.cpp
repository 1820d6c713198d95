#include "laws/methods.hpp"
#include "support/scenes.hpp"

#include <catch2/catch.hpp>

using namespace carom;
using namespace carom::test;

namespace {

Vec3 momentum(const Scene& scene, const std::vector<BodyState>& states)
{
    Vec3 p = Vec3::Zero();
    for (std::size_t i = 0; i < states.size(); ++i) p += scene.spheres[i].mass * states[i].velocity;
    return p;
}

double size(const Scene& scene)
{
    double sum = 0;
    for (const auto& s : scene.spheres) sum += s.mass * s.velocity.norm();
    return sum;
}

}  // namespace

TEST_CASE("law: without walls and forces momentum is kept, at any restitution")
{
    for (const Claims& claims : methods())
        for (const double e : {1.0, 0.7}) {
            Scene scene = empty_scene(3, Vec3::Zero(), e);
            Random random(1);
            fill_box(scene, random, 80, 7, 0.3, 0.5, 3);
            const Outcome outcome = simulate(scene, claims.method);
            INFO(claims.label << ", e " << e);
            CHECK(outcome.counts.impacts > 30);
            CHECK((momentum(scene, outcome.final) - momentum(scene, initial_states(scene))).norm() <=
                  1e-13 * size(scene));
        }
}

TEST_CASE("law: what the walls take is the momentum that the spheres and gravity bring")
{
    for (const Claims& claims : methods()) {
        const Scene scene = gas(3, 50, 3, earth);
        const Outcome outcome = simulate(scene, claims.method);
        Vec3 expected = momentum(scene, outcome.final) - momentum(scene, initial_states(scene));
        double mass = 0;
        for (const auto& s : scene.spheres) mass += s.mass;
        expected -= mass * outcome.time * scene.gravity;
        Vec3 walls = Vec3::Zero();
        for (std::size_t p = 0; p < scene.planes.size(); ++p)
            walls += outcome.plane_impulses[p] * scene.planes[p].normal;
        INFO(claims.label);
        CHECK((walls - expected).norm() <= 1e-11 * size(scene));
    }
}
