#include "impact/turns.hpp"

#include "contact/contact_problem.hpp"
#include "support/clusters.hpp"

#include <catch2/catch.hpp>

#include <array>
#include <cmath>

using namespace carom;
using namespace carom::test;

namespace {

using Real = long double;

/// Velocities of three balls in a row that touch, after elastic impacts of neighbours, one after the other until
/// nothing closes.
std::array<Real, 3> impact_by_impact(const std::array<Real, 3>& mass, std::array<Real, 3> v)
{
    const auto impact = [&](std::size_t a, std::size_t b) {
        const Real impulse = 2 * mass[a] * mass[b] / (mass[a] + mass[b]) * (v[a] - v[b]);
        v[a] -= impulse / mass[a];
        v[b] += impulse / mass[b];
    };
    while (v[0] > v[1] || v[1] > v[2]) {
        if (v[0] > v[1]) impact(0, 1);
        if (v[1] > v[2]) impact(1, 2);
    }
    return v;
}

Real common(const std::array<Real, 3>& mass, const std::array<Real, 3>& v)
{
    return (mass[0] * v[0] + mass[1] * v[1] + mass[2] * v[2]) / (mass[0] + mass[1] + mass[2]);
}

}  // namespace

TEST_CASE("A light ball between heavy ones: what impacts one by one give, blended with what sticks together")
{
    for (const double ratio : {1e2, 1e4, 1e6, 1e9, 1e12})
        for (const double right : {1.0, 0.3, 7.0})
            for (const double e : {1.0, 0.9, 0.5, 0.0}) {
                const std::array<Real, 3> mass{ratio, 1, right * ratio}, v{1, 0, 0};
                const ClusterImpact impact = resolve_cluster(row({ratio, 1, right * ratio}, {1, 0, 0}, e), {});
                CAPTURE(ratio, right, e);
                CHECK_FALSE(impact.capped);
                CHECK(impact.rounds < 100);
                const std::array<Real, 3> apart = impact_by_impact(mass, v);
                const Real together = common(mass, v);
                Real energy = 0, expected = 0;
                for (std::size_t i = 0; i < 3; ++i) {
                    const Real blend = e * apart[i] + (1 - e) * together;
                    // All that one heavy ball gives the other, its mass times some 2, goes through the light one:
                    // rounding of that is the error of the light one's speed.
                    const double tolerance = i == 1 ? 4 * 1.2e-16 * ratio * std::max(1.0, right) + 1e-12 : 1e-12;
                    CAPTURE(i, static_cast<double>(impact.velocities[i].x() - blend) / tolerance);
                    CHECK(std::abs(static_cast<double>(impact.velocities[i].x() - blend)) < tolerance);
                    energy += mass[i] * impact.velocities[i].x() * impact.velocities[i].x();
                    expected += mass[i] * blend * blend;
                }
                CHECK(static_cast<double>(energy / expected) == Approx(1).epsilon(1e-9));
            }
}

TEST_CASE("A ball in a narrow wedge leaves as the unfolded path says")
{
    for (const double angle : {1e-2, 1e-3, 1e-4, 1e-5, 1e-6}) {
        // Walls of the wedge make half the angle with x; the ball runs towards the edge.
        for (const double direction : {0.0, 0.3 * angle, -0.45 * angle, 0.1, -0.5, 1.2}) {
            const double half = angle / 2;
            const ClusterImpact impact = resolve_cluster(
                wedge(std::cos(half), std::sin(half), Vec3(-std::sin(direction), -std::cos(direction), 0)), {});
            CAPTURE(angle, direction, impact.rounds);
            CHECK_FALSE(impact.capped);
            CHECK_FALSE(impact.jammed);
            CHECK(impact.velocities[0].norm() == Approx(1).epsilon(1e-14));
            // It is out when it closes on neither wall: within half the angle of the middle.
            CHECK(std::abs(impact.velocities[0].x()) < half + 1e-9);
            CHECK(impact.velocities[0].y() > 0);
        }
    }
}

TEST_CASE("Turns stop where a third contact could close on the way, and where few are to come")
{
    const ProjectionProblem stiff = projection_problem(row({1e6, 1, 1e6}, {1, 0, 0}));
    const std::optional<Turns> many = turns(stiff, 0, 1, 1e-12);
    REQUIRE(many);
    CHECK(many->first > 0);
    CHECK(many->second > 0);
    CHECK_FALSE(turns(projection_problem(row({2, 1, 2}, {1, 0, 0})), 0, 1, 1e-12));
    // A fourth ball behind the right one, which takes speed from it on the way.
    CHECK_FALSE(turns(projection_problem(row({1e6, 1, 1e6, 1e6}, {1, 0, 0, 0})), 0, 1, 1e-12));
    // The same ball, on its way out faster than the right one can become.
    CHECK(turns(projection_problem(row({1e6, 1, 1e6, 1e6}, {1, 0, 0, 3})), 0, 1, 1e-12));
}
