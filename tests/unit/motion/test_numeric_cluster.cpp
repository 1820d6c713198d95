/// A ball that slides off a fixed one, without friction: height and speed are those of energy, and it leaves where
/// cos = 2/3. Its angle obeys theta'' = (g / R) sin theta, here integrated on its own with very small steps.
#include "motion/numeric_cluster.hpp"

#include <catch2/catch.hpp>

#include <array>
#include <cmath>

using namespace carom;

namespace {

constexpr double gravity = 9.81, reach = 0.5;

NumericCluster ball_on_ball(double angle, double rate)
{
    NumericCluster cluster;
    const Vec3 out(std::sin(angle), 0, std::cos(angle)), along(std::cos(angle), 0, -std::sin(angle));
    cluster.bodies.push_back({reach * out, reach * rate * along, 2});
    cluster.contacts.push_back({0, FixedSphere{}, reach, 0});
    cluster.gravity = {0, 0, -gravity};
    cluster.opening = 1e-9 * gravity;
    return cluster;
}

std::array<double, 2> angle_after(double angle, double rate, double time)
{
    constexpr int steps = 20000;
    const double h = time / steps;
    const auto pull = [](double x) { return gravity / reach * std::sin(x); };
    for (int i = 0; i < steps; ++i) {
        const double k1 = rate, l1 = pull(angle), k2 = rate + h / 2 * l1, l2 = pull(angle + h / 2 * k1);
        const double k3 = rate + h / 2 * l2, l3 = pull(angle + h / 2 * k2), k4 = rate + h * l3,
                     l4 = pull(angle + h * k3);
        angle += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
        rate += h / 6 * (l1 + 2 * l2 + 2 * l3 + l4);
    }
    return {angle, rate};
}

double angle_of(const NumericBody& body)
{
    return std::atan2(body.position.x(), body.position.z());
}

}  // namespace

TEST_CASE("numeric steps converge with order 4, and their contacts stay closed")
{
    const double angle = 0.3, rate = 0.5, end = 0.16;
    const double exact = angle_after(angle, rate, end)[0];
    std::array<double, 3> error{};
    for (std::size_t k = 0; k < error.size(); ++k) {
        const int steps = 8 << k;
        NumericCluster cluster = ball_on_ball(angle, rate);
        for (int i = 0; i < steps; ++i) {
            const NumericStep step = numeric_step(cluster, end / steps);
            REQUIRE(step.duration == end / steps);
            cluster.bodies = step.bodies;
            CHECK(std::abs(cluster.bodies[0].position.norm() - reach) < 1e-14);
        }
        error[k] = std::abs(angle_of(cluster.bodies[0]) - exact);
    }
    CAPTURE(error[0], error[1], error[2]);
    CHECK(error[0] < 1e-6);
    CHECK(std::log2(error[0] / error[1]) > 3.7);
    CHECK(std::log2(error[1] / error[2]) > 3.7);
}

TEST_CASE("within a step the motion is as exact as at its end, whatever was put back there")
{
    const double angle = 0.3, rate = 0.5, h = 0.01;
    const NumericCluster cluster = ball_on_ball(angle, rate);
    const NumericStep step = numeric_step(cluster, h);
    for (const double part : {0.0, 0.2, 0.5, 0.9, 1.0}) {
        const NumericBody at = within_step(cluster, step, part * h)[0];
        const auto [theta, omega] = angle_after(angle, rate, part * h);
        CAPTURE(part);
        CHECK(std::abs(at.position.norm() - reach) < 1e-14);
        CHECK(std::abs(angle_of(at) - theta) < 1e-10);
        CHECK(std::abs(at.velocity.norm() - reach * omega) < 1e-8);
    }
    // Off its place by 1e-7, and a step so short that what is put back would be an enormous speed.
    NumericCluster off = ball_on_ball(angle, rate);
    off.bodies[0].position *= 1 + 1e-7;
    const NumericStep brief = numeric_step(off, 1e-13);
    for (const double part : {0.1, 0.5, 0.9})
        CHECK(std::abs(within_step(off, brief, part * 1e-13)[0].velocity.norm() - reach * rate) < 1e-6);
}

TEST_CASE("a step ends where its contact opens: a ball leaves another one at cos = 2/3")
{
    NumericCluster cluster = ball_on_ball(0.01, 0);
    for (int i = 0; i < 10000; ++i) {
        const NumericStep step = numeric_step(cluster, 2e-3);
        cluster.bodies = step.bodies;
        if (step.duration < 2e-3) break;
    }
    // From rest at 0.01: 3 cos = 2 cos 0.01.
    CHECK(std::abs(std::cos(angle_of(cluster.bodies[0])) - 2 * std::cos(0.01) / 3) < 1e-8);
}
