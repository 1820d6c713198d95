#include <catch2/catch.hpp>

#include "reference_scenes.hpp"

#include <algorithm>
#include <cmath>

using namespace carom;
using namespace carom::test;

TEST_CASE("Equal masses that meet head-on swap their velocities", "[reference]")
{
    Scene scene;
    scene.spheres = {ball("a", {0, 0, 0}, {2, 0, 0}, 3, 0.5), ball("b", {3, 0, 0}, {-1, 0, 0}, 3, 0.5)};
    const Reference ref = run_to(scene, 2);
    REQUIRE(ref.impacts.size() == 1);
    CHECK(ref.impacts[0].time == Approx(2.0 / 3).epsilon(1e-16));
    CHECK(ref.impacts[0].a == 0);
    CHECK(ref.impacts[0].b == 1);
    CHECK(ref.samples[0][0].velocity == Vec3(-1, 0, 0));
    CHECK(ref.samples[0][1].velocity == Vec3(2, 0, 0));
    CHECK(ref.kind == Reference::Kind::multiprecision);
    CHECK(ref.reason.empty());
    CHECK(ref.root_solves == 1);
}

TEST_CASE("An oblique impact follows the pair law with restitution, tangential factor and attenuation", "[reference]")
{
    // Contact along x with an offset: 3-4-5 triangle, r1 + r2 = 5, at t = 1.
    Scene scene;
    scene.materials = {Material{"steel", 1, 0.25, ""}};
    scene.spheres = {ball("a", {-6, 4, 0}, {3, 0, 0}, 1, 2), ball("b", {0, 0, 0}, {0, 0, 0}, 3, 3)};
    const Vec3 u(-0.6, 0.8, 0), v(3, 0, 0), v_n = u * u.dot(v), v_t = v - v_n;
    const auto check = [&](double e, double alpha, double attenuation) {
        const Reference ref = run_to(scene, 2);
        REQUIRE(ref.impacts.size() == 1);
        CHECK(ref.impacts[0].time == 1);
        const Vec3 change = (1 + e) * v_n + (1 - alpha) * v_t;  // of the relative velocity; 3/4 of it for a, 1/4 for b
        CHECK((ref.samples[0][0].velocity - attenuation * (v - 0.75 * change)).norm() < 1e-15);
        CHECK((ref.samples[0][1].velocity - attenuation * 0.25 * change).norm() < 1e-15);
    };
    check(1, 1, 1);  // a material's tangential factor does not act between spheres
    ContactRule rule;
    rule.restitution = 0.5;
    rule.tangential = 0.25;
    scene.contacts = {rule};
    check(0.5, 0.25, 1);
    scene.contacts[0].attenuation = 0.75;
    check(0.5, 0.25, 0.75);
}

TEST_CASE("A pass at exactly the sum of the radii is no impact, one ulp less is", "[reference]")
{
    Scene scene;
    scene.spheres = {ball("a", {-4, 1, 0}, {1, 0, 0}, 1, 0.5), ball("b", {0, 0, 0}, {0, 0, 0}, 1, 0.5)};
    CHECK(run_to(scene, 8).impacts.empty());
    scene.spheres[0].position.y() = std::nextafter(1.0, 0.0);
    const Reference ref = run_to(scene, 8);
    REQUIRE(ref.impacts.size() == 1);
    CHECK(ref.impacts[0].time == Approx(4 - std::sqrt(0x1p-52)).epsilon(1e-15).margin(0));
}

TEST_CASE("Two balls, a wall and masses 1 : 100^k collide floor(10^k pi) times", "[reference]")
{
    const std::size_t expected[] = {3, 31, 314, 3141};
    for (int k = 0; k < 4; ++k) {
        const Reference ref = run_to(counting_pi(k), 1000);
        CHECK(ref.impacts.size() == expected[k]);
        CHECK(ref.reason.empty());
    }
}

TEST_CASE("Two spheres under gravity meet as without it, and bounce on the floor", "[reference]")
{
    Scene scene;
    scene.gravity = {0, 0, -2};
    scene.spheres = {ball("low", {0, 0, 2}, {0, 0, 0}, 3, 0.5), ball("high", {0, 0, 4}, {0, 0, 0}, 1, 0.5)};
    scene.planes = {plane("floor", {0, 0, 1}, 0)};
    // The lower one is at the floor at sqrt(1.5), goes up, and meets the other, 1 above it, at relative speed 2
    // sqrt(6).
    const double t1 = std::sqrt(1.5), t2 = t1 + 1 / (2 * std::sqrt(6.0));
    const Reference ref = run_to(scene, t2 + 0.01);
    REQUIRE(ref.impacts.size() == 2);
    CHECK(ref.impacts[0].time == Approx(t1).epsilon(1e-15));
    CHECK(ref.impacts[1].time == Approx(t2).epsilon(1e-15));
    CHECK(energy(scene, ref.samples[0]) == Approx(2 * (3 * 2 + 4)).epsilon(1e-15));
}

TEST_CASE("A gas run back from its end returns to its start", "[reference]")
{
    Scene scene = gas(3, 0.3, {0, 0, -1});
    const Scene start = scene;
    const double t = 0.5;
    const Reference forth = run_to(scene, t);
    REQUIRE(forth.samples.size() == 1);
    CHECK(forth.impacts.size() > 40);
    CHECK(energy(scene, forth.samples[0]) == Approx([&] {
                                                 std::vector<BodyState> states;
                                                 for (const auto& s : scene.spheres)
                                                     states.push_back({s.position, s.velocity, Mode::flying});
                                                 return energy(scene, states);
                                             }())
                                                 .epsilon(1e-14));
    for (std::size_t i = 0; i < scene.spheres.size(); ++i) {
        scene.spheres[i].position = forth.samples[0][i].position;
        scene.spheres[i].velocity = -forth.samples[0][i].velocity;
    }
    const Reference back = run_to(scene, t);
    REQUIRE(back.samples.size() == 1);
    CHECK(back.impacts.size() == forth.impacts.size());
    double error = 0;
    for (std::size_t i = 0; i < scene.spheres.size(); ++i)
        error = std::max(error, (back.samples[0][i].position - start.spheres[i].position).norm());
    CHECK(error < 1e-12);
    CHECK(error > 0);  // the turning point was rounded to double, and chaos shows it
}

TEST_CASE("Spheres of very different sizes never overlap and never leave their box", "[reference]")
{
    Scene scene = gas(4, 0.3, {0, 0, -9.81});
    for (std::size_t i = 0; i < scene.spheres.size(); ++i)
        if (i % 3 != 0) scene.spheres[i].radius = i % 3 == 1 ? 0.01 : 1e-6;
    std::vector<double> times;
    for (int k = 0; k <= 300; ++k) times.push_back(k * 0.003);
    const Reference ref = make_reference(scene, 0.9, times);
    REQUIRE(ref.reason.empty());
    CHECK(ref.impacts.size() > 200);
    double least = 1;
    for (const auto& states : ref.samples) {
        for (std::size_t i = 0; i < states.size(); ++i) {
            for (const Plane& p : scene.planes)
                least = std::min(least, plane_gap(p, scene.spheres[i], states[i].position));
            for (std::size_t j = 0; j < i; ++j)
                least = std::min(least, (states[i].position - states[j].position).norm() - scene.spheres[i].radius -
                                            scene.spheres[j].radius);
        }
    }
    CHECK(least > -1e-15);
    CHECK(least < 1e-3);  // the samples do come close to contacts
}

TEST_CASE("Spheres that stick at e = 0 are not hit again by rounding", "[reference]")
{
    // They meet obliquely, go on together, and later bounce on the floor side by side: their contact only ever slides.
    Scene scene;
    ContactRule rule;
    rule.restitution = 0;
    scene.contacts = {rule};
    scene.materials.push_back(Material{"floor", 1, 1, ""});
    scene.spheres = {ball("a", {-1, 0.31, 2}, {1, 0, -1}, 1, 0.5), ball("b", {0.7, 0, 2}, {0, 0, -1}, 3, 0.5)};
    scene.planes = {plane("floor", {0, 0, 1}, 0)};
    scene.planes[0].material = 1;
    const Reference ref = run_to(scene, 3);
    CHECK(ref.reason.empty());
    CHECK(ref.impacts.size() == 3);
    CHECK(ref.samples[0][0].velocity.z() == 1);
    CHECK(ref.samples[0][1].velocity.z() == 1);
}

TEST_CASE("Lengths scaled by a power of two scale the run, however small or large", "[reference]")
{
    const Scene scene = gas(3, 0.3);
    const Reference ref = run_to(scene, 0.5);
    for (const double scale : {0x1p-520, 0x1p500}) {
        Scene scaled = scene;
        for (Sphere& s : scaled.spheres) {
            s.radius *= scale;
            s.position *= scale;
            s.velocity *= scale;
        }
        for (Plane& p : scaled.planes) p.offset *= scale;
        const Reference other = run_to(scaled, 0.5);
        REQUIRE(other.samples.size() == 1);
        CHECK(other.impacts.size() == ref.impacts.size());
        for (std::size_t i = 0; i < scene.spheres.size(); ++i)
            CHECK(other.samples[0][i].position == ref.samples[0][i].position * scale);
    }
}

TEST_CASE("The bound is rounding while the two precisions agree, and ends a chaotic run", "[reference]")
{
    Scene scene = gas(3, 0.25);
    std::vector<double> times;
    for (int k = 0; k <= 400; ++k) times.push_back(k * 0.1);
    const Reference ref = make_reference(scene, 40, times);
    REQUIRE(ref.samples.size() > 10);
    CHECK(ref.bounds.front() < 2e-16);
    CHECK(ref.bounds[10] < 2e-16);
    CHECK(ref.until < 40);
    CHECK(ref.until == ref.sample_times.back());
    CHECK(ref.reason.find("bound") != std::string::npos);
    CHECK(ref.bound <= 1e-7);
    CHECK(ref.bound == *std::max_element(ref.bounds.begin(), ref.bounds.end()));
    CHECK(ref.impacts.back().time <= ref.until);
}

TEST_CASE("A smaller end changes nothing of what comes before it", "[reference]")
{
    const Scene scene = gas(3, 0.3);
    const std::vector<double> times{0, 0.25, 0.5};
    const Reference small = make_reference(scene, 0.3, times), large = make_reference(scene, 0.5, times);
    CHECK(small.sample_times == std::vector<double>{0, 0.25});
    CHECK(large.samples.size() == 3);
    REQUIRE(large.impacts.size() > small.impacts.size());
    for (std::size_t k = 0; k < small.impacts.size(); ++k) {
        CHECK(small.impacts[k].time == large.impacts[k].time);
        CHECK(small.impacts[k].a == large.impacts[k].a);
        CHECK(small.impacts[k].b == large.impacts[k].b);
    }
    for (std::size_t i = 0; i < scene.spheres.size(); ++i)
        CHECK(small.samples[1][i].position == large.samples[1][i].position);
}

TEST_CASE("Contacts within the tie are one instant, those farther apart a sequence", "[reference]")
{
    Scene scene;
    scene.spheres = {ball("ball-1", {-2, 0, 0}, {1, 0, 0}, 1, 0.5), ball("ball-2", {0, 0, 0}, {0, 0, 0}, 2, 0.5),
                     ball("ball-3", {1 + 1e-10, 0, 0}, {0, 0, 0}, 1, 0.5)};
    const Reference declared = run_to(scene, 3);  // at the start 1e-9 radii are a contact
    CHECK(declared.reason.empty());
    REQUIRE(declared.impacts.size() == 2);
    CHECK(declared.impacts[1].time == 1);
    CHECK(declared.samples[0][2].velocity.x() == Approx(8.0 / 9).epsilon(1e-15));
    scene.spheres[2].position.x() = 1 + 1e-8;
    const Reference sequence = run_to(scene, 3);
    REQUIRE(sequence.impacts.size() == 2);
    CHECK(sequence.impacts[1].time > 1);
    // Symmetric, and closed at once by its own motion.
    scene.spheres = {ball("cue", {-3, 0, 0}, {1, 0, 0}, 1, 0.5), ball("up", {0, 0.75, 0}, {0, 0, 0}, 1, 0.5),
                     ball("down", {0, -0.75, 0}, {0, 0, 0}, 1, 0.5)};
    const auto instants = [&] {
        const Reference ref = run_to(scene, 5);
        return ref.impacts.size() == 2 && ref.impacts[0].time == ref.impacts[1].time ? 1 : 2;
    };
    CHECK(instants() == 1);
    scene.spheres[2].position.y() = -0.75 - 1e-13;
    CHECK(instants() == 1);
    scene.impact.tie = 1e-14;
    CHECK(instants() == 2);
}

TEST_CASE("Declared contacts that nothing presses leave flights alone", "[reference]")
{
    Scene scene;
    scene.gravity = {0, 0, -1};
    scene.spheres = {ball("a", {0, 0, 9}, {0, 0, 0}, 1, 0.5), ball("b", {1, 0, 9}, {0, 0, 0}, 1, 0.5)};
    const Reference ref = run_to(scene, 1);
    CHECK(ref.reason.empty());
    CHECK(ref.impacts.empty());
    CHECK(ref.samples[0][1].position == Vec3(1, 0, 8.5));
}
