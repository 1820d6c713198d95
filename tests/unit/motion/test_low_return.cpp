/// The return of a low bounce against the quartic solved in 100 digits.
#include "motion/low_return.hpp"

#include "support/multiprecision.hpp"
#include "support/scenes.hpp"

#include <catch2/catch.hpp>

using namespace carom;
using namespace carom::test;
using Real = Float<100>;

namespace {

/// A ball that leaves the fixed one that it touches.
Scene leaving(const Vec3& place, const Vec3& velocity, double restitution = 0.5)
{
    Scene scene = empty_scene(1, earth, restitution);
    add_sphere(scene, 0.5, Vec3::Zero());
    scene.spheres[0].fixed = true;
    add_sphere(scene, 0.5, place.normalized(), velocity);
    return scene;
}

std::optional<double> answer(const Scene& scene)
{
    const State state(scene, Precision::plain);
    return low_return(state, 0, 1, pair_motion(state, moving(state, 0), moving(state, 1)));
}

/// The first time > 0 at which |r + v t + g t^2/2| = |r|: Newton's method on that, divided by t, from a time near it.
Real root_near(const Vec3& place, const Vec3& velocity, double near)
{
    const Real3<Real> r = lift<Real>(place), v = lift<Real>(velocity), g = lift<Real>(earth);
    const Real c0 = 2 * dot(r, v), c1 = dot(v, v) + dot(r, g), c2 = dot(v, g), c3 = dot(g, g) / 4;
    Real t = near;
    for (int i = 0; i < 12; ++i) t -= (c0 + t * (c1 + t * (c2 + t * c3))) / (c1 + t * (2 * c2 + 3 * t * c3));
    return t;
}

}  // namespace

TEST_CASE("the return of a low bounce is known to its own rounding, however low")
{
    Random random(7);
    for (int k = 0; k < 2000; ++k) {
        const Vec3 up = (Vec3::UnitZ() + 0.3 * random.in_cube(1)).normalized();
        const double w = std::pow(10.0, random.uniform(-14, -1));
        const Vec3 across = random.in_cube(1);
        const Vec3 velocity = w * (up + random.uniform(0, 1) * (across - across.dot(up) * up));
        const Scene scene = leaving(up, velocity);
        const std::optional<double> t = answer(scene);
        if (!t) continue;
        const Vec3& place = scene.spheres[1].position;
        CAPTURE(k, w, *t);
        // Products of a place and a speed round by some 5 u of the speed, which is at most twice its normal part.
        CHECK(std::abs(static_cast<double>((Real(*t) - root_near(place, velocity, *t)) / Real(*t))) < 4e-15);
        CHECK(*t == Approx(2 * w / 9.81).epsilon(0.6));
    }
    CHECK(answer(leaving(Vec3::UnitZ(), {0, 0, 1e-12})).value() == Approx(2e-12 / 9.81).epsilon(1e-14));
}

TEST_CASE("only what touches a fixed sphere, leaves it and is pressed on it returns from a low bounce")
{
    const Vec3 up = Vec3::UnitZ(), slow(0, 0, 1e-3);
    CHECK(answer(leaving(up, slow)));
    CHECK_FALSE(answer(leaving(up, -slow)));
    CHECK_FALSE(answer(leaving(-up, -slow)));
    CHECK_FALSE(answer(leaving(up, {4, 0, 1e-3})));  // it flies off: v^2/S above g
    CHECK_FALSE(answer(leaving(up, {0, 0, 1})));     // high
    CHECK_FALSE(answer(leaving(up, slow, 1)));       // nothing ends these bounces
    Scene apart = leaving(up, slow);
    apart.spheres[1].position.z() += 1e-12;
    CHECK_FALSE(answer(apart));
    Scene both = leaving(up, slow);
    both.spheres[0].fixed = false;
    CHECK_FALSE(answer(both));
}

TEST_CASE("under drag the return of a low bounce is known to its own rounding, too")
{
    Random random(8);
    int returns = 0;
    for (int k = 0; k < 2000; ++k) {
        const Vec3 up = (Vec3::UnitZ() + 0.3 * random.in_cube(1)).normalized();
        const double w = std::pow(10.0, random.uniform(-14, -1));
        const Vec3 across = random.in_cube(1);
        const Vec3 velocity = w * (up + random.uniform(0, 1) * (across - across.dot(up) * up));
        Scene scene = leaving(up, velocity);
        scene.drag = std::pow(10.0, random.uniform(-12, 6));
        const State state(scene, Precision::plain);
        const std::optional<double> t = low_return(state, 0, 1, damped_pair_motion(state, 0, 1));
        if (!t) continue;
        ++returns;
        // |r + v s + g q|^2 = |r|^2 divided by s, whose sign changes within roundings of the time.
        const Vec3& place = scene.spheres[1].position;
        const Real3<Real> r = lift<Real>(place), v = lift<Real>(velocity), g = lift<Real>(earth);
        const auto value = [&](const Real& time) {
            const Real s = -expm1(-scene.drag * time) / scene.drag, p = (time - s) / scene.drag / s;
            const Real mean = dot(v, v) + 2 * p * dot(v, g) + p * p * dot(g, g);
            return Real(2 * dot(r, v) + 2 * p * dot(r, g) + s * mean);
        };
        CAPTURE(k, w, scene.drag, *t);
        CHECK(value(*t * (1 - Real(8e-15))) > 0);
        CHECK(value(*t * (1 + Real(8e-15))) < 0);
    }
    CHECK(returns > 1000);
}
