#include "contact/contact_forces.hpp"

#include "support/clusters.hpp"
#include "support/random.hpp"

#include <catch2/catch.hpp>

using namespace carom;
using namespace carom::test;

namespace {
constexpr double rounding = 1e-12;
constexpr double g = 9.81;

ContactForces solve(const ContactProblem& cluster)
{
    return solve_contact_forces(cluster, std::vector<double>(cluster.contacts.size(), 0.0));
}

ContactProblem tower(int n)
{
    ContactProblem out = hit_tower(n - 1);
    for (ContactBody& body : out.bodies) body.velocity = Vec3(0, 0, -g);
    return out;
}

}  // namespace

TEST_CASE("Contact k of a tower from the top carries k weights, and nothing accelerates")
{
    for (const int n : {1, 2, 5, 40}) {
        const ContactForces forces = solve(tower(n));
        for (int i = 0; i < n; ++i) {
            CHECK(std::abs(forces.forces[static_cast<std::size_t>(i)] - (n - i) * g) < rounding * n * g);
            CHECK(forces.accelerations[static_cast<std::size_t>(i)].norm() < rounding * g);
            CHECK(forces.gap_rates[static_cast<std::size_t>(i)] == 0);
        }
    }
}

TEST_CASE("A ball on three fixed touching ones presses each with 0.408 weights")
{
    ContactProblem cluster;
    cluster.bodies = {{Vec3(0, 0, -g), 0.5}};
    const double root_3 = std::sqrt(3.0);
    for (const Vec3& place : {Vec3(0, 2 / root_3, 0), Vec3(1, -1 / root_3, 0), Vec3(-1, -1 / root_3, 0)})
        cluster.contacts.push_back({0, immovable, (Vec3(0, 0, std::sqrt(8.0 / 3)) - place).normalized(), 1, 1});
    for (const double force : solve(cluster).forces) CHECK(std::abs(force / (2 * g) - 1 / std::sqrt(6.0)) < rounding);
}

TEST_CASE("A ball in a V groove presses each side with 0.707 weights")
{
    ContactProblem cluster = wedge(std::sqrt(0.5), std::sqrt(0.5), Vec3(0, -g, 0));
    for (const double force : solve(cluster).forces) CHECK(std::abs(force / g - std::sqrt(0.5)) < rounding);
}

TEST_CASE("A contact that opens carries nothing and says how fast it opens")
{
    ContactProblem cluster = wedge(std::sqrt(0.5), std::sqrt(0.5), Vec3(3, -1, 0));
    const ContactForces forces = solve(cluster);
    CHECK(forces.forces[0] == 0);
    CHECK(forces.gap_rates[0] == Approx(std::sqrt(2.0)));  // (3 - 1) / sqrt 2
    CHECK(forces.forces[1] == Approx(2 * std::sqrt(2.0)));
    CHECK(forces.gap_rates[1] == 0);
}

TEST_CASE("On top of a sphere a body that moves fast enough leaves, one that is slower is carried")
{
    ContactProblem cluster;
    cluster.bodies = {{Vec3(0, 0, -g), 1}};
    cluster.contacts = {{0, immovable, Vec3(0, 0, 1), 1, 1}};
    const double slow = 0.75 * g, fast = 1.25 * g;
    const ContactForces carried = solve_contact_forces(cluster, std::vector<double>{slow});
    CHECK(carried.forces[0] == Approx(g - slow));
    CHECK(carried.accelerations[0].z() == Approx(-slow));
    const ContactForces leaves = solve_contact_forces(cluster, std::vector<double>{fast});
    CHECK(leaves.forces[0] == 0);
    CHECK(leaves.gap_rates[0] == Approx(fast - g));
}

TEST_CASE("Redundant contacts share in some way, accelerations and sums are what they must be")
{
    // A block of 3 x 3 discs between walls on a floor, in a square lattice: floor and walls are more than needed.
    std::vector<Vec3> places;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) places.emplace_back(i, j, 0);
    ContactProblem cluster = discs(places);
    for (std::size_t k = 0; k < places.size(); ++k) {
        cluster.bodies[k].velocity = Vec3(0, -g, 0);
        const auto body = static_cast<int>(k);
        if (places[k].y() == 0) cluster.contacts.push_back({body, immovable, Vec3(0, 1, 0), 1, 1});
        if (places[k].x() == 0) cluster.contacts.push_back({body, immovable, Vec3(1, 0, 0), 1, 1});
        if (places[k].x() == 2) cluster.contacts.push_back({body, immovable, Vec3(-1, 0, 0), 1, 1});
    }
    const ContactForces forces = solve(cluster);
    double carried = 0;
    for (std::size_t i = 0; i < cluster.contacts.size(); ++i)
        if (cluster.contacts[i].b == immovable) carried += forces.forces[i] * cluster.contacts[i].normal.y();
    CHECK(std::abs(carried - 9 * g) < 9 * g * rounding);
    for (const Vec3& acceleration : forces.accelerations) CHECK(acceleration.norm() < g * rounding);
}

TEST_CASE("Two balls side by side, jammed to within any angle, are never thrown")
{
    // In a groove between walls that leave both just room, one on the wedge that the other and its neighbours make, a
    // third one's weight upon it. Exactly, no acceleration exceeds what gravity and curvature ask for.
    carom::test::Random random(5);
    for (int n = 0; n < 2000; ++n) {
        const double angle = random.log_uniform(1e-13, 1e-3);
        const Vec3 down(0, 0, -10), in = Vec3(-random.uniform(0, 1), -random.uniform(0, 1), -1).normalized() * 6;
        const Vec3 left = Vec3(1, 0, 1).normalized(), right = Vec3(-1, 0, 1).normalized();
        ContactProblem cluster;
        cluster.bodies = {{down, 1}, {down, 1}, {down, 1}};
        cluster.contacts = {{0, 1, Vec3(-angle, -1, -angle).normalized(), 1, 1},
                            {0, 2, in.normalized(), 1, 1},
                            {0, immovable, left, 1, 1},
                            {0, immovable, right, 1, 1},
                            {0, immovable, Vec3(0, 1, 0), 1, 1},
                            {1, immovable, -left, 1, 1},
                            {1, immovable, right, 1, 1},
                            {1, immovable, Vec3(0, -1, 0), 1, 1}};
        std::vector<double> curvature(8, 0.0);
        curvature[1] = random.uniform(0, 8);
        CAPTURE(angle);
        const ContactForces forces = solve_contact_forces(cluster, curvature);
        for (const Vec3& acceleration : forces.accelerations) CHECK(acceleration.norm() < 40);
        for (std::size_t i = 0; i < 8; ++i) {
            const Contact& c = cluster.contacts[i];
            const Vec3 relative = forces.accelerations[static_cast<std::size_t>(c.a)] -
                                  (c.b ? forces.accelerations[static_cast<std::size_t>(*c.b)] : Vec3(0, 0, 0));
            CHECK(c.normal.dot(relative) + curvature[i] > -2e-7 * 10);
        }
    }
}
