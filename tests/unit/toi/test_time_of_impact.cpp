#include "oracle.hpp"
#include "support/random.hpp"

#include <carom/time_of_impact.hpp>
#include <catch2/catch.hpp>

#include <cmath>
#include <limits>

using namespace carom;
using carom::test::Random;

namespace {

MovingSphere sphere_at(const Vec3& position, const Vec3& velocity, double radius = 1)
{
    return {.position = position, .velocity = velocity, .radius = radius};
}

Plane floor_at(double offset)
{
    Plane plane;
    plane.offset = offset;
    return plane;
}

Vec3 place(const MovingSphere& s, double t)
{
    return s.position + t * s.velocity + (0.5 * t * t) * s.acceleration;
}

/// Made backwards: a contact at a time and a normal of our choice, approached at a speed of our choice.
struct Made {
    MovingSphere a, b;
    Vec3 normal, point;
    double t, speed;
};
Made make_impact(Random& random, bool same_acceleration)
{
    Made made;
    made.t = random.uniform(0.1, 2);
    made.normal = random.direction();
    made.speed = random.uniform(1, 5);
    made.a.radius = random.uniform(0.1, 1);
    made.b.radius = random.uniform(0.1, 1);
    made.a.acceleration = random.in_cube(1);
    made.b.acceleration = same_acceleration ? made.a.acceleration : random.in_cube(1);
    const Vec3 centre_b = random.in_cube(3);
    const Vec3 centre_a = centre_b + (made.a.radius + made.b.radius) * made.normal;
    const Vec3 velocity_b = random.in_cube(2);
    const Vec3 velocity_a = velocity_b - made.speed * made.normal;  // head on: nothing closes before
    made.point = centre_b + made.b.radius * made.normal;
    const auto back = [&](MovingSphere& s, const Vec3& centre, const Vec3& velocity) {
        s.velocity = velocity - made.t * s.acceleration;
        s.position = centre - made.t * velocity + (0.5 * made.t * made.t) * s.acceleration;
    };
    back(made.a, centre_a, velocity_a);
    back(made.b, centre_b, velocity_b);
    return made;
}

}  // namespace

TEST_CASE("Two spheres that approach head on meet when their gap is used up", "[toi][public]")
{
    const TimeOfImpact hit = time_of_impact(sphere_at({0, 0, 0}, {1, 0, 0}), sphere_at({10, 0, 0}, {-1, 0, 0}, 2));
    REQUIRE(hit.status == ImpactStatus::impact);
    CHECK(hit);
    CHECK(hit.t == 3.5);
    CHECK(hit.normal == Vec3(-1, 0, 0));
    CHECK(hit.point == Vec3(4.5, 0, 0));
    CHECK(hit.approach_speed == 2);
    CHECK(hit.level == 0);
}

TEST_CASE("Impacts that were made backwards are found with their normal, point and speed", "[toi][public]")
{
    Random random(5);
    for (int i = 0; i < 2000; ++i) {
        const Made made = make_impact(random, i % 2 == 0);
        const TimeOfImpact hit = time_of_impact(made.a, made.b);
        CAPTURE(i, made.t, made.normal.transpose());
        REQUIRE(hit.status == ImpactStatus::impact);
        // Under different accelerations there may be an earlier contact; then the gap there must be closed.
        if (i % 2 == 0 || std::abs(hit.t - made.t) < 1e-9) {
            CHECK(hit.t == Approx(made.t).epsilon(1e-12));
            CHECK((hit.normal - made.normal).norm() < 1e-11);
            CHECK((hit.point - made.point).norm() < 1e-11);
            CHECK(hit.approach_speed == Approx(made.speed).epsilon(1e-11));
        }
        CHECK(hit.t <= made.t * (1 + 1e-12));
        CHECK((place(made.a, hit.t) - place(made.b, hit.t)).norm() ==
              Approx(made.a.radius + made.b.radius).epsilon(1e-12));
        CHECK(std::abs(hit.normal.norm() - 1) < 1e-15);
    }
}

TEST_CASE("Times of generated pairs agree with 200 digits, hits and misses alike", "[toi][public]")
{
    Random random(6);
    int hits = 0, misses = 0;
    for (int i = 0; i < 5000; ++i) {
        const MovingSphere a = sphere_at(random.in_cube(4), random.in_cube(1), random.uniform(0.1, 1));
        MovingSphere b = sphere_at(random.in_cube(4), random.in_cube(1), random.uniform(0.1, 1));
        if (random.coin()) b.velocity += a.position - b.position;  // aimed, more or less
        const test::Truth truth =
            test::exact_sphere_sphere(a.position - b.position, a.velocity - b.velocity, a.radius + b.radius);
        if (truth.open) continue;
        const TimeOfImpact hit = time_of_impact(a, b);
        REQUIRE(static_cast<bool>(hit) == truth.impact);
        (truth.impact ? hits : misses)++;
        // A gap of a thousandth of the radii costs ten bits: r.r - S^2 cancels, and double-double waits for less.
        if (truth.impact && truth.t > 0) CHECK(test::ulps(hit.t, truth.t) < 0x1p10);
    }
    CHECK(hits > 300);
    CHECK(misses > 300);
}

TEST_CASE("Exchanging the spheres turns the normal and keeps the time, bit for bit", "[toi][public]")
{
    Random random(7);
    for (int i = 0; i < 500; ++i) {
        const Made made = make_impact(random, i % 2 == 0);
        const TimeOfImpact one = time_of_impact(made.a, made.b), other = time_of_impact(made.b, made.a);
        CHECK(one.t == other.t);
        CHECK(one.normal == -other.normal);
        CHECK((one.point - other.point).norm() < 1e-11);
        CHECK(one.approach_speed == other.approach_speed);
    }
}

TEST_CASE("Spheres that touch and approach are touching; when they separate or slide past there is nothing",
          "[toi][public]")
{
    const MovingSphere b = sphere_at({0, 0, 0}, {0, 0, 0});
    const TimeOfImpact closing = time_of_impact(sphere_at({2, 0, 0}, {-1, 1, 0}), b);
    CHECK(closing.status == ImpactStatus::touching);
    CHECK(closing.t == 0);
    CHECK(closing.approach_speed == 1);
    CHECK(closing.point == Vec3(1, 0, 0));
    CHECK(time_of_impact(sphere_at({1.5, 0, 0}, {-1, 0, 0}), b).status == ImpactStatus::touching);
    CHECK_FALSE(time_of_impact(sphere_at({2, 0, 0}, {1, 1, 0}), b));
    CHECK_FALSE(time_of_impact(sphere_at({2, 0, 0}, {0, 1, 0}), b));
    CHECK_FALSE(time_of_impact(sphere_at({2, 0, 0}, {0, 0, 0}), b));
    CHECK_FALSE(time_of_impact(sphere_at({1.5, 0, 0}, {1, 0, 0}), b));
}

TEST_CASE("A sphere at rest on another, pressed by its weight, is touching at speed 0", "[toi][public]")
{
    const MovingSphere below = sphere_at({0, 0, 0}, {0, 0, 0});
    MovingSphere above = sphere_at({0, 0, 2}, {0, 0, 0});
    CHECK_FALSE(time_of_impact(above, below));
    above.acceleration = {0, 0, -9.81};
    CHECK(time_of_impact(above, below).status == ImpactStatus::touching);
    CHECK(time_of_impact(above, below).approach_speed == 0);
    above.acceleration = {0, 0, 9.81};
    CHECK_FALSE(time_of_impact(above, below));
}

TEST_CASE("Concentric spheres at one velocity can only part", "[toi][public]")
{
    MovingSphere a = sphere_at({1, 2, 3}, {1, 0, 0});
    const MovingSphere b = a;
    a.acceleration = {0, 0, -1};
    CHECK_FALSE(time_of_impact(a, b));
}

TEST_CASE("Equal accelerations cancel, however large", "[toi][public]")
{
    MovingSphere a = sphere_at({0, 0, 0}, {1, 0, 0}), b = sphere_at({10, 0, 0}, {0, 0, 0});
    a.acceleration = b.acceleration = {3, 4, -9.81e6};
    const TimeOfImpact hit = time_of_impact(a, b);
    CHECK(hit.t == 8);
    CHECK(hit.approach_speed == 1);
}

TEST_CASE("A sphere dropped on a floor lands at sqrt(2h/g) and not again where it bounces", "[toi][public]")
{
    MovingSphere ball = sphere_at({0.5, 0, 1.5}, {2, 0, 0}, 0.5);
    ball.acceleration = {0, 0, -9.81};
    const TimeOfImpact hit = time_of_impact(ball, floor_at(0));
    REQUIRE(hit.status == ImpactStatus::impact);
    CHECK(hit.t == Approx(std::sqrt(2 / 9.81)).epsilon(4e-16));
    CHECK(hit.normal == Vec3(0, 0, 1));
    CHECK(hit.approach_speed == Approx(std::sqrt(2 * 9.81)).epsilon(1e-15));
    CHECK((hit.point - Vec3(0.5 + 2 * hit.t, 0, 0)).norm() < 1e-15);

    MovingSphere bounced = sphere_at({0, 0, 0.5}, {0, 0, 3}, 0.5);
    bounced.acceleration = ball.acceleration;
    CHECK(time_of_impact(bounced, floor_at(0)).t == Approx(6 / 9.81).epsilon(4e-16));
    bounced.velocity = {1, 0, 0};
    CHECK(time_of_impact(bounced, floor_at(0)).status == ImpactStatus::touching);
    bounced.acceleration = {0, 0, 0};
    CHECK_FALSE(time_of_impact(bounced, floor_at(0)));
    bounced.velocity = {0, 0, -1};
    CHECK(time_of_impact(bounced, floor_at(0)).status == ImpactStatus::touching);
}

TEST_CASE("A sphere that leaves a floor from inside comes back to it at its apex", "[toi][public]")
{
    MovingSphere ball = sphere_at({0, 0, 0.25}, {0, 0, 0.5}, 1);
    ball.acceleration = {0, 0, -1};
    const TimeOfImpact hit = time_of_impact(ball, floor_at(0));
    REQUIRE(hit.status == ImpactStatus::impact);
    CHECK(hit.t == 0.5);
    CHECK(hit.approach_speed == 0);
    CHECK(hit.point.z() == 0);
}

TEST_CASE("A plate is hit on the side on which the sphere is", "[toi][public]")
{
    Plane plate = floor_at(1);
    plate.thickness = 0.5;
    const TimeOfImpact above = time_of_impact(sphere_at({0, 0, 5}, {0, 0, -1}), plate);
    CHECK(above.t == 2.75);
    CHECK(above.normal == Vec3(0, 0, 1));
    CHECK(above.point == Vec3(0, 0, 1.25));
    const TimeOfImpact below = time_of_impact(sphere_at({0, 0, -5}, {0, 0, 1}), plate);
    CHECK(below.t == 4.75);
    CHECK(below.normal == Vec3(0, 0, -1));
    CHECK(below.point == Vec3(0, 0, 0.75));
    CHECK_FALSE(time_of_impact(sphere_at({0, 0, -5}, {0, 0, -1}), plate));
}

TEST_CASE("A far origin costs a height only the rounding of its place", "[toi][public]")
{
    // x and d of 2^40 cancel exactly under n = (3, 0, 4)/5 as stored only in more than double precision.
    Plane ramp;
    ramp.normal = {0.6, 0, 0.8};
    const double far = 0x1p40;
    const MovingSphere ball = sphere_at({far, 0, 0}, {-1, 0, 0}, 0.25);
    ramp.offset = 0.6 * far - 1;
    const TimeOfImpact hit = time_of_impact(ball, ramp);
    using test::Float200;
    const Float200 height = Float200(0.6) * Float200(far) - Float200(ramp.offset) - Float200(0.25);
    CHECK(test::ulps(hit.t, Float200(height / Float200(0.6))) < 2);
}

TEST_CASE("What is out of range has no impact and is no number that spreads", "[toi][public]")
{
    const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
    const MovingSphere b = sphere_at({0, 0, 0}, {0, 0, 0});
    for (const double x : {nan, inf}) {
        CHECK_FALSE(time_of_impact(sphere_at({x, 0, 0}, {-1, 0, 0}), b));
        CHECK_FALSE(time_of_impact(sphere_at({5, 0, 0}, {-x, 0, 0}), b));
        CHECK_FALSE(time_of_impact(sphere_at({0, 0, 5}, {0, 0, -1}, x), b));
        CHECK_FALSE(time_of_impact(sphere_at({0, 0, 5}, {0, 0, -1}, x), floor_at(0)));
        CHECK_FALSE(time_of_impact(sphere_at({0, 0, 5}, {0, 0, -1}), floor_at(-x)));
    }
    CHECK_FALSE(time_of_impact(sphere_at({5, 0, 0}, {-1, 0, 0}, 0), sphere_at({0, 0, 0}, {0, 0, 0}, 0)));
    CHECK_FALSE(time_of_impact(sphere_at({1e300, 0, 0}, {-1e-300, 0, 0}), b));  // later than any double
    CHECK(time_of_impact(sphere_at({1e300, 0, 0}, {-1e290, 0, 0}, 1e291), b).t == Approx(1e10 - 10).epsilon(1e-15));
}

TEST_CASE("Under different accelerations a graze by exactly nothing is no impact, one by the last digit is one",
          "[toi][public]")
{
    // The gap along the line of centres is 1 - 2 t + t^2: it closes at t = 1 and opens again.
    const MovingSphere b = sphere_at({0, 0, 0}, {0, 0, 0}, 2);
    MovingSphere a = sphere_at({0, 0, 4}, {0, 0, -2}, 1);
    a.acceleration = {0, 0, 2};
    CHECK_FALSE(time_of_impact(a, b));
    a.velocity.z() = std::nextafter(-2.0, -3.0);
    const TimeOfImpact hit = time_of_impact(a, b);
    CHECK(hit.status == ImpactStatus::impact);
    CHECK(hit.t == Approx(1).epsilon(1e-7));
    CHECK(hit.t < 1);
    a.velocity.z() = std::nextafter(-2.0, 0.0);
    CHECK_FALSE(time_of_impact(a, b));

    // From inside: -1 + 2 t - t^2 turns at t = 1, exactly at contact or before it; only then it closes.
    MovingSphere inside = sphere_at({0, 0, 2}, {0, 0, 2}, 1);
    inside.acceleration = {0, 0, -2};
    for (const double speed : {2.0, std::nextafter(2.0, 0.0)}) {
        inside.velocity.z() = speed;
        const TimeOfImpact turn = time_of_impact(inside, b);
        CHECK(turn.status == ImpactStatus::impact);
        CHECK(turn.t == speed / 2);
        CHECK(turn.approach_speed < 1e-15);
    }
    inside.velocity.z() = std::nextafter(2.0, 3.0);  // gets out, and comes back
    CHECK(time_of_impact(inside, b).t > 1);
}
