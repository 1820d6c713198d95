/// Units are a convention: another unit that is a power of two away changes exponents and no other bit.
#include "laws/methods.hpp"
#include "support/scenes.hpp"

#include <catch2/catch.hpp>

using namespace carom;
using namespace carom::test;

namespace {

Scene scaled(Scene scene, int mass, int length, int time)
{
    const double m = std::ldexp(1, mass), l = std::ldexp(1, length), v = std::ldexp(1, length - time);
    for (auto& s : scene.spheres) {
        s.mass *= m;
        s.radius *= l;
        s.position *= l;
        s.velocity *= v;
    }
    for (auto& p : scene.planes) p.offset *= l;
    scene.gravity *= std::ldexp(1, length - 2 * time);
    scene.end_time = std::ldexp(scene.end_time, time);
    return scene;
}

void require_same_bits(const Scene& scene, const Claims& claims, int mass, int length, int time)
{
    INFO(claims.label << ", mass 2^" << mass << ", length 2^" << length << ", time 2^" << time);
    const Recorded a = record(scene, claims.method),
                   b = record(scaled(scene, mass, length, time), with_step_scaled(claims.method, time));
    INFO(a.outcome.message << " / " << b.outcome.message);
    CHECK(a.outcome.status == b.outcome.status);
    CHECK(a.events.size() > 10);
    REQUIRE(a.events.size() == b.events.size());
    for (std::size_t i = 0; i < a.events.size(); ++i) {
        CHECK(a.events[i].kind == b.events[i].kind);
        CHECK(a.events[i].a == b.events[i].a);
        CHECK(a.events[i].b == b.events[i].b);
        CHECK(b.events[i].time == std::ldexp(a.events[i].time, time));
        CHECK(b.events[i].impulse == Vec3(a.events[i].impulse * std::ldexp(1, mass + length - time)));
    }
    for (std::size_t i = 0; i < scene.spheres.size(); ++i) {
        CHECK(b.outcome.final[i].position == Vec3(a.outcome.final[i].position * std::ldexp(1, length)));
        CHECK(b.outcome.final[i].velocity == Vec3(a.outcome.final[i].velocity * std::ldexp(1, length - time)));
    }
}

}  // namespace

TEST_CASE("law: scaling masses, lengths and times by powers of two changes no bit")
{
    for (const Claims& claims : methods()) {
        for (const Vec3& gravity : {Vec3(0, 0, 0), earth})
            for (const double e : {1.0, 0.8}) {
                Scene scene = gas(4, 40, 2, gravity, e);
                require_same_bits(scene, claims, 7, 0, 0);
                require_same_bits(scene, claims, -300, 0, 0);
                require_same_bits(scene, claims, 0, 5, 0);
                require_same_bits(scene, claims, 0, 0, -9);
                require_same_bits(scene, claims, 3, -40, 17);
            }
    }
}

TEST_CASE("law: scaling changes no bit of series and rest")
{
    for (const Claims& claims : methods()) {
        if (!claims.exact) continue;  // nobody else has them
        Scene scene = empty_scene(10, earth, 0.7);
        add_floor(scene);
        for (int i = 0; i < 9; ++i) add_sphere(scene, 0.1, {1.0 * i, 0, 0.3 + 0.1 * i}, {0.01 * i, 0.2, 0});
        require_same_bits(scene, claims, 2, 3, 5);
        require_same_bits(scene, claims, -2, -30, 20);
    }
}
