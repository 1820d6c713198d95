#include "exactly.hpp"

#include <cmath>

using namespace carom;
using namespace carom::test;

namespace {

constexpr double tiny = 1e-22;

/// Tanh-sinh quadrature (Takahasi and Mori 1974) of what is smooth between the ends.
template <class F>
Real integral(F f, const Real& low, const Real& high)
{
    constexpr int steps = 256;  // of 1/66 to both sides
    const Real half_pi = acos(Real(0)), half = (high - low) / 2;
    Real sum = 0;
    for (int k = -steps; k <= steps; ++k) {
        const Real u = Real(k) / 66, y = half_pi * sinh(u), c = cosh(y);
        sum += f(low + half * (1 + tanh(y))) * half * half_pi * cosh(u) / (c * c) / 66;
    }
    return sum;
}

/// A ball on a fixed ball of radius 1 at the origin, g = 9.81.
Scene on_a_globe(const Vec3& x, const Vec3& v)
{
    Scene scene;
    scene.gravity = {0, 0, -9.81};
    scene.spheres = {ball("globe", {0, 0, 0}, {0, 0, 0}, 1, 1), ball("ball", x, v, 1, 0.1)};
    scene.spheres[0].fixed = true;
    return scene;
}

Real energy(const Scene& scene, const Exact& run, double t)
{
    Real sum = 0;
    for (BodyId i = 0; i < static_cast<BodyId>(scene.spheres.size()); ++i) {
        const ExactVector v = run.flight(i).velocity(t), x = run.flight(i).position(t);
        sum += scene.spheres[i].mass * (dot(v, v) / 2 - dot(ExactVector(scene.gravity), x));
    }
    return sum;
}

}  // namespace

TEST_CASE("A ball that slides off a sphere leaves it at cos = 2/3 cos(theta0), after the time of an elliptic integral",
          "[reference]")
{
    const double angle = 0.17453292519943295;
    const Scene scene = on_a_globe({1.1 * std::sin(angle), 0, 1.1 * std::cos(angle)}, {0, 0, 0});
    const ExactVector x0(scene.spheres[1].position);
    const Real g(9.81), R = sqrt(dot(x0, x0)), theta0 = atan2(x0.x, x0.z), theta1 = acos(2 * cos(theta0) / 3);
    // theta'^2 = 2 g/R (cos(theta0) - cos(theta)), with theta = theta0 + s^2
    const auto slowness = [&](const Real& s) {
        return Real(s / sqrt(g / R * sin(theta0 + s * s / 2) * sin(s * s / 2)));
    };
    const Real time = integral(slowness, 0, sqrt(theta1 - theta0));

    const Exact run = exactly(scene, 1);
    REQUIRE(run.reason() == "");
    const reference::Flight<Real>& free = run.flight(1);
    CHECK(run.mode(1, 1) == Mode::flying);
    CHECK(abs(free.t - time) < tiny);
    CHECK(abs(free.x.z - R * cos(theta1)) < tiny);
    CHECK(abs(dot(free.v, free.v) - 2 * g * (x0.z - free.x.z)) < tiny);
    CHECK(abs(dot(free.v, free.x)) < tiny);
    REQUIRE(run.record.contacts.size() == 1);
    CHECK(run.record.contacts[0].begin == 0);
    CHECK(run.record.contacts[0].end == static_cast<double>(time));
    CHECK(run.record.impacts.empty());
    CHECK(exactly(scene, static_cast<double>(time) - 1e-9).mode(1, time - 1e-9) == Mode::sliding);
}

TEST_CASE("A push on top of a sphere: where it leaves and when, in all samples of both precisions", "[reference]")
{
    const Scene scene = on_a_globe({0, 0, 1.1}, {0.1, 0, 0});
    const Real g(9.81), R(1.1), v0(0.1), leaves = Real(2) / 3 + v0 * v0 / (3 * g * R);
    const auto slowness = [&](const Real& theta) {
        const Real sine = sin(theta / 2);
        return Real(1 / sqrt(v0 * v0 / (R * R) + 4 * g / R * sine * sine));
    };
    const double time = static_cast<double>(integral(slowness, 0, acos(leaves)));
    const std::vector<double> times{0.5, time};
    const Reference reference = make_reference(scene, 1.5, times);
    CHECK(reference.reason.empty());
    CHECK(reference.until == 1.5);
    CHECK(reference.bound < 1e-15);
    REQUIRE(reference.contacts.size() == 1);
    CHECK(reference.contacts[0].end == Approx(time).epsilon(1e-15));
    CHECK(reference.samples[0][1].mode == Mode::sliding);
    CHECK(reference.samples[1][1].position.z() == Approx(static_cast<double>(R * leaves)).epsilon(1e-14));
}

TEST_CASE("A ball on two others pushes them apart and leaves both at once at h^3 + 3 R^2 h = 2 R^2 h0", "[reference]")
{
    Scene scene;
    scene.gravity = {0, 0, -9.81};
    scene.planes = {plane("floor", {0, 0, 1}, 0)};
    scene.spheres = {ball("left", {-0.6, 0, 0.5}, {0, 0, 0}, 1, 0.5), ball("right", {0.6, 0, 0.5}, {0, 0, 0}, 1, 0.5),
                     ball("top", {0, 0, 1.3}, {0, 0, 0}, 1, 0.5)};
    const Real g(9.81), h0 = Real(1.3) - Real(0.5), x0(0.6), R2 = x0 * x0 + h0 * h0;
    Real h = h0;
    for (int k = 0; k < 100; ++k) h -= (h * h * h + 3 * R2 * h - 2 * R2 * h0) / (3 * h * h + 3 * R2);
    // h'^2 = 2 g (h0 - h) (R^2 - h^2)/(R^2 + h^2), with h = h0 - s^2
    const auto slowness = [&](const Real& s) {
        const Real now = h0 - s * s;
        return Real(2 * sqrt((R2 + now * now) / (2 * g * (R2 - now * now))));
    };
    const Real time = integral(slowness, 0, sqrt(h0 - h));

    const double end = static_cast<double>(time) + 0.05;
    const Exact run = exactly(scene, end);
    REQUIRE(run.reason() == "");
    const reference::Flight<Real>& top = run.flight(2);
    CHECK(abs(top.t - time) < tiny);
    CHECK(abs(top.x.z - Real(0.5) - h) < tiny);
    CHECK(run.mode(2, end) == Mode::flying);
    CHECK(run.mode(0, end) == Mode::sliding);
    CHECK(off(run.flight(0).velocity(end), run.flight(1).velocity(end) * Real(-1)) < tiny);
    CHECK(abs(energy(scene, run, end) - energy(scene, exactly(scene, 0), 0)) < tiny);
}

TEST_CASE("A stack a millimetre off its axis falls as the pendulum that it is", "[reference]")
{
    Scene scene;
    scene.gravity = {0, 0, -9.81};
    scene.planes = {plane("floor", {0, 0, 1}, 0)};
    const double dx = 1e-3, dz = std::sqrt(0.2 * 0.2 - dx * dx);
    scene.spheres = {ball("low", {0, 0, 0.1}, {0, 0, 0}), ball("high", {dx, 0, 0.1 + dz}, {0, 0, 0})};
    const double t = 0.45;
    const Exact run = exactly(scene, t);
    REQUIRE(run.reason() == "");
    REQUIRE(run.mode(1, t) == Mode::sliding);  // still on the lower one
    // The centre of mass goes down a vertical; R theta' is 2 g (cos0 - cos)/(cos^2/2 + sin^2).
    const ExactVector r0 = ExactVector(scene.spheres[1].position) - ExactVector(scene.spheres[0].position);
    const ExactVector r = run.flight(1).position(t) - run.flight(0).position(t);
    const Real g(9.81), R = sqrt(dot(r0, r0)), theta0 = atan2(r0.x, r0.z), theta1 = atan2(r.x, r.z);
    CHECK(theta1 > 0.1);
    CHECK(abs(sqrt(dot(r, r)) - R) < tiny);
    CHECK(abs(run.flight(0).position(t).x + run.flight(1).position(t).x - r0.x) < tiny);
    const auto slowness = [&](const Real& s) {
        const Real theta = theta0 + s * s, c = cos(theta), sine = sin(theta);
        return Real(2 * s * sqrt(R * (c * c / 2 + sine * sine) / (4 * g * sin(theta0 + s * s / 2) * sin(s * s / 2))));
    };
    CHECK(abs(integral(slowness, 0, sqrt(theta1 - theta0)) - Real(t)) < 1e-18);
    CHECK(abs(energy(scene, run, t) - energy(scene, exactly(scene, 0), 0)) < tiny);
}

TEST_CASE("Constrained motion keeps energy and momentum where bodies meet, part and meet again", "[reference]")
{
    Scene scene;  // elastic; a pyramid that falls apart between walls
    scene.gravity = {0, 0, -9.81};
    scene.planes = {plane("floor", {0, 0, 1}, 0), plane("left", {1, 0, 0}, -1.3), plane("right", {-1, 0, 0}, -1.4)};
    scene.spheres = {ball("left", {-0.6, 0, 0.5}, {0, 0, 0}, 1, 0.5), ball("right", {0.6, 0, 0.5}, {0, 0, 0}, 3, 0.5),
                     ball("top", {0, 0, 1.3}, {0, 0.25, 0}, 2, 0.5)};
    const Exact run = exactly(scene, 1.5);
    REQUIRE(run.reason() == "");
    CHECK(run.record.impacts.size() > 5);
    CHECK(abs(energy(scene, run, 1.5) - energy(scene, exactly(scene, 0), 0)) < tiny);
    Real along_y = 0;
    for (BodyId i = 0; i < 3; ++i) along_y += scene.spheres[i].mass * run.flight(i).velocity(1.5).y;
    CHECK(abs(along_y - Real(0.5)) < tiny);
}
