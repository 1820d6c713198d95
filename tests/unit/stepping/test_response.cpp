#include "small_scenes.hpp"
#include "stepping/response.hpp"

#include <catch2/catch.hpp>

using namespace carom;
using namespace carom::test;
using stepping::Contact;

namespace {

const Contact between{0, 0, 1, -Vec3::UnitX()};  // sphere 0 is left of sphere 1
const Contact at_floor{0, 0, 2, Vec3::UnitZ()};

Scene two_and_floor()
{
    return scene_of({ball(1, Vec3(0, 0, 1), Vec3(3, 1, -2), 2), ball(1, Vec3(2, 0, 1), Vec3(-1, 0, 0), 6)},
                    {wall(Vec3::UnitZ(), 0)});
}

struct After {
    Vec3 v0, v1;
    stepping::Impulse impulse;
};

After respond(const Scene& scene, const Contact& contact)
{
    auto bodies = stepping::make_bodies(scene);
    const auto impulse = stepping::respond(bodies, stepping::LawTable(scene), contact);
    return {bodies.velocity[0], bodies.velocity[1], impulse};
}

}  // namespace

TEST_CASE("Two spheres exchange j = (1+e) m_red (v2-v1).u along the normal", "[stepping]")
{
    Scene scene = two_and_floor();
    scene.materials[0].restitution = 0.5;
    const After after = respond(scene, between);
    // m_red = 1.5, closing speed 4: J = 1.5 * 1.5 * 4 = 9.
    CHECK((after.v0 - Vec3(3 - 4.5, 1, -2)).norm() < 1e-15);
    CHECK((after.v1 - Vec3(-1 + 1.5, 0, 0)).norm() < 1e-15);
    CHECK((after.impulse.on_a - Vec3(-9, 0, 0)).norm() < 1e-14);
    CHECK(after.impulse.normal == Approx(9));
}

TEST_CASE("A tangential factor between spheres scales the relative tangential velocity and keeps momentum",
          "[stepping]")
{
    Scene scene = two_and_floor();
    scene.contacts.push_back({0, 0, {}, 0.25, {}});
    const After after = respond(scene, between);
    const Vec3 relative = after.v0 - after.v1;
    CHECK(relative.x() == Approx(-4));
    CHECK(relative.y() == Approx(0.25 * 1));
    CHECK(relative.z() == Approx(0.25 * -2));
    CHECK((2 * after.v0 + 6 * after.v1 - Vec3(6 - 6, 2, -4)).norm() < 1e-14);
}

TEST_CASE("Attenuation multiplies both velocities after the exchange and is not part of the impulse", "[stepping]")
{
    Scene scene = two_and_floor();
    const After elastic = respond(scene, between);
    scene.contacts.push_back({0, 0, {}, {}, 0.75});
    const After damped = respond(scene, between);
    CHECK((damped.v0 - 0.75 * elastic.v0).norm() < 1e-15);
    CHECK((damped.v1 - 0.75 * elastic.v1).norm() < 1e-15);
    CHECK((damped.impulse.on_a - elastic.impulse.on_a).norm() == 0);
}

TEST_CASE("At a plane v becomes alpha v_t - e v_n, with the coefficients of the two materials", "[stepping]")
{
    Scene scene = two_and_floor();
    scene.materials.push_back({"floor", 0.5, 0.25, ""});
    scene.planes[0].material = 1;
    const After after = respond(scene, at_floor);
    CHECK((after.v0 - Vec3(0.75, 0.25, 1)).norm() < 1e-15);
    CHECK((after.impulse.on_a - 2 * Vec3(-2.25, -0.75, 3)).norm() < 1e-14);
    CHECK(after.impulse.normal == Approx(6));
    CHECK(after.v1 == Vec3(-1, 0, 0));
}

TEST_CASE("The response does not ask whether the contact approaches", "[stepping]")
{
    Scene scene = two_and_floor();
    scene.spheres[0].velocity.z() = 2;
    CHECK(respond(scene, at_floor).v0.z() == -2);
}

TEST_CASE("Cancelling takes the normal component and keeps momentum", "[stepping]")
{
    auto bodies = stepping::make_bodies(two_and_floor());
    const auto impulse = stepping::cancel_normal(bodies, between);
    CHECK(stepping::normal_velocity(bodies, between) == Approx(0).margin(1e-15));
    CHECK((bodies.velocity[0] - Vec3(0, 1, -2)).norm() < 1e-15);
    CHECK((bodies.velocity[1] - Vec3(0, 0, 0)).norm() < 1e-15);
    CHECK(impulse.normal == Approx(6));
    stepping::cancel_normal(bodies, at_floor);
    CHECK((bodies.velocity[0] - Vec3(0, 1, 0)).norm() < 1e-15);
}
