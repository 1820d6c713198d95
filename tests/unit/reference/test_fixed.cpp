#include "reference_scenes.hpp"

#include "reference/damped_contact.hpp"

#include <catch2/catch.hpp>

#include <cmath>

using namespace carom;
using namespace carom::test;

namespace {

using Real = reference::Decimal<50>;
using Vector = reference::Vector<Real>;

Sphere fixed_ball(const std::string& id, const Vec3& x, double radius)
{
    Sphere s = ball(id, x, Vec3::Zero(), 1, radius);
    s.fixed = true;
    return s;
}

/// Contact at t = 1/2 where the centres are (3, 0, 4) apart, run back under g = 8; every number is exact.
Scene oblique()
{
    Scene scene;
    scene.gravity = {0, 0, -8};
    scene.spheres = {fixed_ball("rock", {0, 0, 0}, 3), ball("ball", {4, 0, 4.5}, {-2, 0, 1}, 1, 2)};
    return scene;
}

}  // namespace

TEST_CASE("a ball that falls on a fixed sphere meets it when and where it was aimed, and is reflected", "[reference]")
{
    for (const bool fixed_first : {true, false}) {
        Scene scene = oblique();
        if (!fixed_first) std::swap(scene.spheres[0], scene.spheres[1]);
        const Reference result = run_to(scene, 0.75);
        REQUIRE(result.impacts.size() == 1);
        CHECK(result.impacts[0].time == 0.5);
        CHECK(result.impacts[0].a == 0);
        CHECK(result.impacts[0].b == 1);
        REQUIRE(result.samples.size() == 1);
        const BodyState& moving = result.samples[0][fixed_first ? 1 : 0];
        const BodyState& fixed = result.samples[0][fixed_first ? 0 : 1];
        // v = (-2, 0, -3) before, v - 2 (v.n) n = (2.32, 0, 2.76) after, then a quarter second under g.
        CHECK((moving.position - Vec3(3.58, 0, 4.44)).norm() < 1e-15);
        CHECK((moving.velocity - Vec3(2.32, 0, 0.76)).norm() < 1e-15);
        CHECK(moving.mode == Mode::flying);
        CHECK(fixed.position == Vec3::Zero());
        CHECK(fixed.velocity == Vec3::Zero());
        CHECK(fixed.mode == Mode::fixed);
        CHECK(result.reason.empty());
    }
}

TEST_CASE("without gravity a fixed sphere is a mirror", "[reference]")
{
    Scene scene = oblique();
    scene.gravity = Vec3::Zero();
    scene.spheres[1] = ball("ball", {8, 0, 0}, {-2, 0, 0}, 1e-3, 2);
    const Reference result = run_to(scene, 4);
    REQUIRE(result.impacts.size() == 1);
    CHECK(result.impacts[0].time == 1.5);
    CHECK(result.samples[0][1].position == Vec3(10, 0, 0));
}

TEST_CASE("a ball bounces on top of a fixed sphere as on a floor", "[reference]")
{
    Scene scene;
    scene.gravity = {0, 0, -8};
    scene.materials[0].restitution = 0.5;
    scene.spheres = {fixed_ball("rock", {0, 0, 0}, 3), ball("ball", {0, 0, 6}, Vec3::Zero(), 1, 2)};
    const Reference result = run_to(scene, 1.3);  // 1 m: t = 1/2, then 1/2, 1/4, .. of it, over at 1.5
    REQUIRE(result.impacts.size() == 3);
    CHECK(result.impacts[0].time == 0.5);
    CHECK(result.impacts[1].time == 1.0);
    CHECK(result.impacts[2].time == 1.25);
    const Reference over = run_to(scene, 3);
    CHECK(over.reason.empty());  // bounces slower than v_c are the last
    CHECK(over.samples[0][1].mode == Mode::resting);
    CHECK(over.samples[0][1].position == Vec3(0, 0, 5));
}

TEST_CASE("fixed spheres keep energy where e = 1, and pass nothing on", "[reference]")
{
    Scene scene;
    scene.gravity = {0, 0, -8};
    scene.spheres = {fixed_ball("a", {0, 0, 0}, 1), fixed_ball("b", {1.5, 0, 0}, 1),
                     fixed_ball("c", {0.2, 0.8, -0.5}, 1), ball("ball", {0.3, 0.2, 3}, {0.25, 0, 0}, 1, 0.5),
                     ball("other", {4, 0, 3}, {-1.5, 0, 1}, 2, 0.5)};
    scene.planes = {plane("floor", {0, 0, 1}, -2)};
    const Reference result = run_to(scene, 2);
    REQUIRE(result.samples.size() == 1);
    CHECK(result.impacts.size() >= 3);
    CHECK(energy(scene, result.samples[0]) ==
          Approx(energy(scene, {{Vec3::Zero(), Vec3::Zero(), Mode::fixed},
                                {Vec3::Zero(), Vec3::Zero(), Mode::fixed},
                                {Vec3(0, 0, -0.5), Vec3::Zero(), Mode::fixed},
                                {scene.spheres[3].position, scene.spheres[3].velocity, Mode::flying},
                                {scene.spheres[4].position, scene.spheres[4].velocity, Mode::flying}}))
              .epsilon(1e-13));
}

TEST_CASE("the first contact under relative acceleration is the one that sampling finds", "[reference]")
{
    std::uint64_t state = 7;
    const auto draw = [&state] {
        state = state * 6364136223846793005ULL + 1442695040888963407ULL;
        return static_cast<double>(state >> 11) * 0x1p-52 - 1;
    };
    const auto vector = [&](double size) {
        const double x = draw(), y = draw(), z = draw();
        return Vec3(size * x, size * y, size * z);
    };
    int met = 0;
    for (int k = 0; k < 1000; ++k) {
        const Vec3 r = vector(3), v = vector(3), a = vector(4);
        constexpr double sum = 1, end = 4;
        if (r.norm() < 1.01) continue;
        std::int64_t roots = 0;
        const auto t = reference::DistanceGap<Real>(Vector(r), Vector(v), Vector(a), 0, sum).first_fall(end, roots);
        constexpr int n = 20000;
        double sampled = -1, least = 1;
        for (int i = 0; i <= n && sampled < 0; ++i) {
            const double at = end * i / n, gap = (r + (v + a * (at / 2)) * at).norm() - sum;
            least = std::min(least, gap);
            if (gap <= 0) sampled = at;
        }
        CAPTURE(k, least);
        if (!t) {
            CHECK(sampled < 0);
            continue;
        }
        ++met;
        const double at = static_cast<double>(*t);
        CHECK(std::abs((r + (v + a * (at / 2)) * at).norm() - sum) < 1e-12);
        if (sampled < 0)
            CHECK(least < 1e-4);  // a touch between two samples
        else
            CHECK((at <= sampled && at > sampled - 1.01 * end / n));
    }
    CHECK(met > 50);
}

TEST_CASE("a contact that just opened is not met again at once, one that is pressed is", "[reference]")
{
    std::int64_t roots = 0;
    const auto contact = [&](const Vector& v, const Vector& a) {
        return reference::DistanceGap<Real>(Vector(0, 0, 2), v, a, 0, 2).first_fall(10, roots);
    };
    const Vector down(0, 0, -8);
    CHECK(*contact(Vector(0, 0, 4), down) == 1);
    CHECK(*contact(Vector(0, 0, -1), down) == 0);
    CHECK(*contact(Vector(0, 0, 0), down) == 0);
    CHECK_FALSE(contact(Vector(0, 0, 0), Vector(0, 0, 8)));
    CHECK_FALSE(contact(Vector(10, 0, 0), down));  // flies off tangentially, faster than gravity bends it back
}
