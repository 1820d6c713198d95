#include "impact/pair_law.hpp"

#include "contact/contact_laws.hpp"
#include "support/random.hpp"

#include <catch2/catch.hpp>

using namespace carom;
using carom::test::Random;

namespace {

struct Case {
    ImpactSide a, b;
    Vec3 normal;
};

Case any(Random& random)
{
    Case c;
    c.normal = random.direction();
    c.a = {random.in_cube(3), 1 / random.log_uniform(1e-3, 1e3)};
    c.b = {random.in_cube(3), 1 / random.log_uniform(1e-3, 1e3)};
    if ((c.a.velocity - c.b.velocity).dot(c.normal) > 0) std::swap(c.a.velocity, c.b.velocity);
    return c;
}

double energy(const ImpactSide& a, const Vec3& v)
{
    return a.inverse_mass > 0 ? 0.5 * v.squaredNorm() / a.inverse_mass : 0;
}
Vec3 momentum(const ImpactSide& a, const Vec3& v)
{
    return v / a.inverse_mass;
}

}  // namespace

TEST_CASE("restitution reverses the normal speed, momentum is kept, the energy lost is that of the formula")
{
    Random random(1);
    for (const double e : {1.0, 0.7, 0.0})
        for (int i = 0; i < 1000; ++i) {
            const Case c = any(random);
            const PairImpact after = resolve_pair(c.a, c.b, c.normal, {e, 1, 1});
            const double before = (c.a.velocity - c.b.velocity).dot(c.normal);
            CHECK((after.velocity_a - after.velocity_b).dot(c.normal) == Approx(-e * before).margin(1e-13));
            const Vec3 p = momentum(c.a, c.a.velocity) + momentum(c.b, c.b.velocity);
            const double size = momentum(c.a, c.a.velocity).norm() + momentum(c.b, c.b.velocity).norm();
            CHECK((momentum(c.a, after.velocity_a) + momentum(c.b, after.velocity_b) - p).norm() <= 1e-14 * size);
            const double reduced = 1 / (c.a.inverse_mass + c.b.inverse_mass);
            const double lost = energy(c.a, c.a.velocity) + energy(c.b, c.b.velocity) - energy(c.a, after.velocity_a) -
                                energy(c.b, after.velocity_b);
            const double total = energy(c.a, c.a.velocity) + energy(c.b, c.b.velocity);
            CHECK(std::abs(lost - 0.5 * reduced * (1 - e * e) * before * before) <= 1e-13 * total);
            // Impulse: along the normal, -(1+e) m v_n, and it is what changed a.
            CHECK((after.impulse - (-(1 + e) * reduced * before) * c.normal).norm() <= 1e-14 * size);
            CHECK((momentum(c.a, after.velocity_a - c.a.velocity) - after.impulse).norm() <= 1e-13 * size);
            // Tangentially nothing happens.
            const Vec3 change = after.velocity_a - c.a.velocity;
            CHECK((change - change.dot(c.normal) * c.normal).norm() <= 1e-14 * (1 + change.norm()));
        }
}

TEST_CASE("the tangential factor scales the relative tangential velocity and keeps momentum")
{
    Random random(2);
    for (const double alpha : {0.0, 0.6}) {
        for (int i = 0; i < 500; ++i) {
            const Case c = any(random);
            const PairImpact after = resolve_pair(c.a, c.b, c.normal, {0.5, alpha, 1});
            const auto tangential = [&](const Vec3& v) { return Vec3(v - v.dot(c.normal) * c.normal); };
            const Vec3 before = tangential(c.a.velocity - c.b.velocity);
            CHECK((tangential(after.velocity_a - after.velocity_b) - alpha * before).norm() <= 1e-13);
            const Vec3 gained =
                momentum(c.a, after.velocity_a - c.a.velocity) + momentum(c.b, after.velocity_b - c.b.velocity);
            CHECK(gained.norm() <= 1e-13 * (momentum(c.a, c.a.velocity).norm() + momentum(c.b, c.b.velocity).norm()));
        }
    }
}

TEST_CASE("equal masses swap their normal velocities, and keep the others")
{
    const PairImpact after = resolve_pair({{1, 2, 0}, 1}, {{-3, 5, 1}, 1}, {-1, 0, 0}, {});
    CHECK(after.velocity_a == Vec3(-3, 2, 0));
    CHECK(after.velocity_b == Vec3(1, 5, 1));
    CHECK(after.impulse == Vec3(-4, 0, 0));
}

TEST_CASE("a plane is infinitely heavy: v+ = alpha v_t - e v_n, whatever the mass")
{
    Random random(3);
    for (int i = 0; i < 500; ++i) {
        const Vec3 n = random.direction();
        Vec3 v = random.in_cube(3);
        if (v.dot(n) > 0) v = -v;
        const Vec3 vn = v.dot(n) * n, vt = v - vn;
        const double e = random.uniform(0, 1), alpha = random.uniform(0, 1), mass = random.log_uniform(1e-9, 1e9);
        const PairImpact after = resolve_pair({v, 1 / mass}, {}, n, {e, alpha, 1});
        CHECK((after.velocity_a - (alpha * vt - e * vn)).norm() <= 1e-14);
        CHECK(after.velocity_b == Vec3::Zero());
        CHECK((after.impulse - mass * (after.velocity_a - v)).norm() <= 1e-13 * mass);
        CHECK(resolve_pair({v, 1}, {}, n, {e, alpha, 1}).velocity_a == after.velocity_a);
    }
    CHECK(resolve_pair({{3, 0, -7}, 1 / 3.0}, {}, Vec3::UnitZ(), {}).velocity_a == Vec3(3, 0, 7));
}

TEST_CASE("the length of the normal does not matter")
{
    Random random(4);
    for (int i = 0; i < 200; ++i) {
        const Case c = any(random);
        const PairImpact unit = resolve_pair(c.a, c.b, c.normal, {0.5, 0.5, 1});
        const PairImpact longer = resolve_pair(c.a, c.b, 1e-3 * c.normal, {0.5, 0.5, 1});
        CHECK((unit.velocity_a - longer.velocity_a).norm() <= 1e-14 * (1 + unit.velocity_a.norm()));
        CHECK((unit.velocity_b - longer.velocity_b).norm() <= 1e-14 * (1 + unit.velocity_b.norm()));
    }
}

TEST_CASE("attenuation multiplies both velocities after the exchange, and is not part of the impulse")
{
    const PairImpact plain = resolve_pair({{1, 2, 0}, 1}, {{-3, 5, 1}, 0.5}, {-1, 0, 0}, {1, 1, 1});
    const PairImpact weak = resolve_pair({{1, 2, 0}, 1}, {{-3, 5, 1}, 0.5}, {-1, 0, 0}, {1, 1, 0.9});
    CHECK(weak.velocity_a == Vec3(0.9 * plain.velocity_a));
    CHECK(weak.velocity_b == Vec3(0.9 * plain.velocity_b));
    CHECK(weak.impulse == plain.impulse);
}

TEST_CASE("the laws of two materials are looked up as the scene defines them")
{
    Scene scene;
    scene.materials = {{"steel", 0.9, 0.8, ""}, {"wood", 0.5, 0.95, ""}, {"glue", 0.2, 0.1, ""}};
    scene.contacts = {{0, 1, 0.7, {}, {}}, {2, 2, {}, 0.3, 0.4}};
    const ContactLaws laws(scene);
    CHECK(laws.spheres(0, 0).restitution == 0.9);
    CHECK(laws.spheres(0, 0).tangential == 1);
    CHECK(laws.spheres(0, 1).restitution == 0.7);
    CHECK(laws.spheres(1, 0).restitution == 0.7);
    CHECK(laws.spheres(0, 2).restitution == 0.2);
    CHECK(laws.spheres(2, 2).tangential == 0.3);
    CHECK(laws.spheres(2, 2).attenuation == 0.4);
    CHECK(laws.plane(0, 0).tangential == 0.8);
    CHECK(laws.plane(0, 1).restitution == 0.7);
    CHECK(laws.plane(1, 2).restitution == 0.2);
    CHECK(laws.plane(1, 2).tangential == 0.1);
    CHECK(laws.plane(2, 2).attenuation == 1);
}
