#include "impact/operators.hpp"

#include "support/clusters.hpp"

#include <catch2/catch.hpp>
#include <iterator>

using namespace carom;
using namespace carom::test;

namespace {

constexpr double rounding = 1e-12;

ClusterImpact resolve(const ContactProblem& cluster)
{
    return resolve_cluster(cluster, {});
}

void check_row(const ContactProblem& cluster, const std::vector<double>& speeds)
{
    const ClusterImpact impact = resolve(cluster);
    for (std::size_t i = 0; i < speeds.size(); ++i) {
        CAPTURE(i);
        CHECK((impact.velocities[i] - Vec3(speeds[i], 0, 0)).norm() < rounding);
    }
}

}  // namespace

TEST_CASE("Of a cradle as many leave as come in")
{
    check_row(cradle(1), {0, 0, 0, 0, 1});
    check_row(cradle(2), {0, 0, 0, 1, 1});
    check_row(cradle(3), {0, 0, 1, 1, 1});
    CHECK(resolve(cradle(1)).rounds == 4);
}

TEST_CASE("Rows of the literature")
{
    check_row(row({1, 2, 1}, {1, 0, 0}), {-1.0 / 3, 2.0 / 9, 8.0 / 9});
    check_row(row({1, 1, 1}, {1, 0, -1}), {-1, 0, 1});
    check_row(row({1, 1, 1}, {1, 0, -1}, 0.3), {-0.3, 0, 0.3});
    check_row(row(std::vector<double>(7, 1), {1, 0, 0, 0, 0, 0, 0}, 0), std::vector<double>(7, 1.0 / 7));
    check_row(row({3, 1}, {1, -1}), {0, 2});  // two-ball drop, just after the lower one has turned
}

TEST_CASE("A light ball between two heavy ones hands on what one brings, however heavy they are")
{
    for (const double mass : {1e3, 1e4, 1e6, 1e9}) {
        const ContactProblem cluster = row({mass, 1, mass}, {1, 0, 0});
        const ClusterImpact impact = resolve(cluster);
        CAPTURE(mass, impact.rounds);
        CHECK_FALSE(impact.capped);
        const Debts owed = debts(cluster, impact);
        CHECK(owed.momentum < rounding);
        CHECK(std::abs(owed.energy) < 1e-9);
        CHECK(impact.velocities[2].x() > 0.9);
    }
}

TEST_CASE("Bernoulli's problem")
{
    ClusterImpact impact = resolve(bernoulli(1));
    CHECK((impact.velocities[0] - Vec3(-0.2, 0, 0)).norm() < rounding);
    CHECK((impact.velocities[1] - Vec3(0.6, 0.2 * std::sqrt(3.0), 0)).norm() < rounding);
    CHECK((impact.velocities[2] - Vec3(0.6, -0.2 * std::sqrt(3.0), 0)).norm() < rounding);
    impact = resolve(bernoulli(0));
    CHECK((impact.velocities[0] - Vec3(0.4, 0, 0)).norm() < rounding);
    CHECK((impact.velocities[1] - Vec3(0.3, 0.1 * std::sqrt(3.0), 0)).norm() < rounding);
    CHECK((impact.velocities[2] - Vec3(0.3, -0.1 * std::sqrt(3.0), 0)).norm() < rounding);
}

TEST_CASE("A rack of 15 breaks symmetrically and keeps momentum and energy")
{
    const ContactProblem cluster = rack_of_15();
    const ClusterImpact impact = resolve(cluster);
    CHECK(impact.rounds == 6);
    const Debts owed = debts(cluster, impact);
    CHECK(owed.momentum < rounding);
    CHECK(std::abs(owed.energy) < rounding);
    for (int r = 0; r < 5; ++r)
        for (int k = 0; k <= r; ++k) {
            const auto ball = static_cast<std::size_t>(1 + r * (r + 1) / 2 + k);
            const auto mirrored = static_cast<std::size_t>(1 + r * (r + 1) / 2 + r - k);
            Vec3 v = impact.velocities[mirrored];
            v.y() = -v.y();
            CHECK((impact.velocities[ball] - v).norm() < rounding);
        }
}

TEST_CASE("Corners turn a sphere round")
{
    const double diagonal = std::sqrt(0.5);
    CHECK((resolve(wedge(diagonal, diagonal, Vec3(0.3, -1, 0))).velocities[0] - Vec3(-0.3, 1, 0)).norm() < rounding);
    ContactProblem corner;
    corner.bodies = {{Vec3(-1, -2, -3), 0.5}};
    for (int k = 0; k < 3; ++k) corner.contacts.push_back({0, immovable, Vec3::Unit(k), 1, 1});
    CHECK((resolve(corner).velocities[0] - Vec3(1, 2, 3)).norm() < rounding);
}

TEST_CASE("Hits on what rests on the floor")
{
    const ClusterImpact two = resolve(onto_resting());
    CHECK(std::abs(two.velocities[0].z() - 7.0 / 9) < rounding);
    CHECK(std::abs(two.velocities[1].z() - 4.0 / 9) < rounding);
    const ClusterImpact tower = resolve(hit_tower(5));
    CHECK(tower.rounds == 11);
    for (std::size_t i = 0; i < 5; ++i) CHECK(tower.velocities[i].norm() < rounding);
    CHECK(std::abs(tower.velocities[5].z() - 1) < rounding);
}

TEST_CASE("A pinched sphere loses what presses it between its planes and keeps the rest")
{
    const ClusterImpact impact = resolve(pinched());
    CHECK(impact.jammed);
    CHECK_FALSE(impact.capped);
    CHECK((impact.velocities[0] - Vec3(0, 0.5, 0)).norm() < rounding);
    const NormalImpact endless = reflections(pinched(), {false});
    CHECK(endless.capped);
}

TEST_CASE("A jammed sphere passes on what it cannot take")
{
    // Held between two planes, it is a wall for the one that hits it along them.
    ContactProblem cluster = pinched();
    cluster.bodies = {{Vec3::Zero(), 1}, {Vec3(1, 1, 0), 1}};
    cluster.contacts.push_back({0, 1, Vec3(1, 0, 0), 1, 1});
    const ClusterImpact impact = resolve(cluster);
    CHECK(impact.velocities[0].norm() < rounding);
    CHECK((impact.velocities[1] - Vec3(-1, 1, 0)).norm() < rounding);
}

TEST_CASE("Two spheres between walls do not pass each other where their wedge is wide, and pass where it is none")
{
    // The upper one falls with speed 1 on the other, so their contact closes at theta. Once nothing closes faster than
    // c, its relative speed w is at least -3 c / theta.
    for (const double theta : {1e-12, 1e-10, 1e-9, 1e-8, 1.9e-8, 1e-6, 1e-5, 1e-3, 0.1}) {
        for (const double e : {0.0, 0.5, 1.0}) {
            ContactProblem cluster;
            cluster.bodies = {{{0, 0, -1}, 1}, {Vec3::Zero(), 1}};
            cluster.contacts = {{0, 1, Vec3(-1, 0, theta).normalized(), e, 1},
                                {0, immovable, {1, 0, 0}, e, 1},
                                {1, immovable, {-1, 0, 0}, e, 1}};
            const ClusterImpact impact = resolve(cluster);
            const double w = impact.velocities[0].z() - impact.velocities[1].z();
            CAPTURE(theta, e, w);
            CHECK(std::abs(impact.velocities[0].z() + impact.velocities[1].z() + 1) < rounding);
            double closing = 0;
            for (const Contact& c : cluster.contacts) closing = std::max(closing, -closing_rate(c, impact.velocities));
            if (theta < 2e-8) {
                CHECK(closing < 4e-8);
                CHECK(closing <= theta * (1 + rounding));
            } else {
                CHECK(closing < 1e-9);
                CHECK(w > -3e-9 / theta);
            }
        }
    }
}

TEST_CASE("Restitution of a mixture lies between those of its contacts, weighted by their work")
{
    // Two impacts with planes at right angles, of the same closing speed and different restitution.
    ContactProblem cluster = wedge(std::sqrt(0.5), std::sqrt(0.5), Vec3(0, -1, 0));
    cluster.contacts[0].restitution = 0.25;
    cluster.contacts[1].restitution = 0.75;
    CHECK((resolve(cluster).velocities[0] - Vec3(0, 0.5, 0)).norm() < rounding);
}

TEST_CASE("A contact that the impact of another opens has no part in its restitution")
{
    // The second closes slowly on the third; the first, by then, throws it back.
    ContactProblem cluster;
    cluster.bodies = {{Vec3(-1, 0, 0), 1}, {Vec3(0.01, 0, 0), 1}, {Vec3::Zero(), 1}};
    cluster.contacts = {{1, 0, Vec3(-1, 0, 0), 0.5, 1}, {2, 1, Vec3(1, 0, 0), 0, 1}};
    const ClusterImpact impact = resolve(cluster);
    CHECK(impact.velocities[0].x() - impact.velocities[1].x() == Approx(0.5 * 1.01).epsilon(1e-12));
    CHECK(impact.velocities[2].isZero(0));
}

TEST_CASE("Neither the order of contacts nor that of bodies matters, nor which is a and which b")
{
    Random random(5);
    for (int trial = 0; trial < 300; ++trial) {
        RandomClusters options;
        options.most_contacts = 20;
        options.mass_ratio = 16;
        const ContactProblem cluster = random_cluster(random, options);
        const auto bodies = cluster.bodies.size();
        ContactProblem turned;
        for (std::size_t i = 0; i < bodies; ++i) turned.bodies.push_back(cluster.bodies[bodies - 1 - i]);
        std::vector<Contact> reversed(cluster.contacts.rbegin(), cluster.contacts.rend());
        for (Contact& contact : reversed) {
            contact.a = static_cast<int>(bodies) - 1 - contact.a;
            if (contact.b) {
                const int b = static_cast<int>(bodies) - 1 - *contact.b;
                contact.b = contact.a;
                contact.a = b;
                contact.normal = -contact.normal;
            }
        }
        turned.contacts = reversed;
        const ClusterImpact first = resolve(cluster);
        const ClusterImpact second = resolve(turned);
        if (first.rounds > 30) continue;  // rounding grows with the rounds
        CAPTURE(trial, first.rounds, first.jammed);
        CHECK(first.rounds == second.rounds);
        for (std::size_t i = 0; i < bodies; ++i)
            CHECK((first.velocities[i] - second.velocities[bodies - 1 - i]).norm() < 1e-9);
    }
}

TEST_CASE("Random clusters: nothing closes, nothing pulls, momentum is kept, energy is not gained")
{
    Random random(1);
    for (const double ratio : {2.0, 1e6, 1e9}) {
        RandomClusters options;
        options.mass_ratio = ratio;
        int jammed = 0, bad = 0;
        for (int trial = 0; trial < 1500; ++trial) {
            const ContactProblem cluster = random_cluster(random, options);
            const ClusterImpact impact = resolve(cluster);
            const Debts owed = debts(cluster, impact);
            jammed += impact.jammed ? 1 : 0;
            if (owed.closing > 1e-9 || owed.momentum > 1e-12 || owed.energy > 1e-12 || owed.pull > 1e-12) ++bad;
        }
        CHECK(bad == 0);
        CHECK(jammed > 200);
    }
}

TEST_CASE("Scale does not matter: masses and speeds times powers of two give the same bits")
{
    Random random(8);
    for (int trial = 0; trial < 200; ++trial) {
        RandomClusters options;
        options.most_contacts = 12;
        const ContactProblem cluster = random_cluster(random, options);
        ContactProblem large = cluster;
        for (ContactBody& body : large.bodies) {
            body.velocity *= 0x1p40;
            body.inverse_mass *= 0x1p-60;
        }
        const ClusterImpact a = resolve(cluster), b = resolve(large);
        for (std::size_t i = 0; i < cluster.bodies.size(); ++i) CHECK(a.velocities[i] * 0x1p40 == b.velocities[i]);
    }
}
