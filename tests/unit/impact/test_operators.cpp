#include "impact/operators.hpp"

#include "contact/contact_problem.hpp"

#include "support/clusters.hpp"

#include <catch2/catch.hpp>

using namespace carom;
using namespace carom::test;

namespace {

constexpr double rounding = 1e-12;

ClusterImpact resolve(const ContactProblem& cluster, ImpactOperator which, const LcpOptions& lcp_options = {})
{
    ImpactOptions options;
    options.impact_operator = which;
    options.lcp = lcp_options;
    return resolve_cluster(cluster, options);
}

void check_row(const ClusterImpact& impact, const std::vector<double>& speeds, double within = rounding)
{
    for (std::size_t i = 0; i < speeds.size(); ++i) {
        CAPTURE(i);
        CHECK((impact.velocities[i] - Vec3(speeds[i], 0, 0)).norm() < within);
    }
}

}  // namespace

TEST_CASE("The pair law in a wedge takes the known number of reflections")
{
    const double pi = 3.14159265358979323846;
    const std::vector<std::pair<double, int>> known{{90, 2}, {60, 3},  {50, 4},  {45, 4},
                                                    {30, 5}, {10, 16}, {1, 163}, {0.1, 1633}};
    for (const auto& [degrees, count] : known) {
        const double half = degrees / 2 * pi / 180;
        CAPTURE(degrees);
        const NormalImpact impact = sequential(wedge(std::cos(half), std::sin(half), Vec3(0.3, -1, 0)));
        CHECK(impact.rounds == count);
        CHECK_FALSE(impact.capped);
    }
}

TEST_CASE("Three balls collapse below e = 7 - 4 sqrt 3, and above it take the known number of impulses")
{
    const std::vector<std::pair<double, int>> known{{0.0719, 89}, {0.072, 64}, {0.078, 12},
                                                    {0.08, 11},   {0.09, 8},   {0.1, 6}};
    for (const auto& [e, count] : known) {
        CAPTURE(e);
        const NormalImpact impact = sequential(row({1, 1, 1}, {1, 0, -1}, e));
        CHECK(impact.rounds == count);
        CHECK_FALSE(impact.capped);
    }
    for (const double e : {0.0717, 0.05, 0.01}) {
        CAPTURE(e);
        CHECK_FALSE(sequential(row({1, 1, 1}, {1, 0, -1}, e)).capped);
        check_row(resolve(row({1, 1, 1}, {1, 0, -1}, e), ImpactOperator::sequential), {0, 0, 0});
    }
}

TEST_CASE("One after the other a cradle and a tower answer as they should, but the order decides for three in a row")
{
    for (int k = 1; k <= 3; ++k) {
        std::vector<double> speeds(5, 0.0);
        for (int i = 0; i < k; ++i) speeds[static_cast<std::size_t>(4 - i)] = 1;
        check_row(resolve(cradle(k), ImpactOperator::sequential), speeds);
    }
    CHECK(sequential(cradle(1)).rounds == 4);
    CHECK(sequential(hit_tower(5)).rounds == 11);
    ContactProblem three = row({1, 2, 1}, {1, 0.1, -1});
    const ClusterImpact forward = resolve(three, ImpactOperator::sequential);
    std::swap(three.contacts[0], three.contacts[1]);
    const ClusterImpact backward = resolve(three, ImpactOperator::sequential);
    CHECK((forward.velocities[0] - backward.velocities[0]).norm() > 0.01);
}

TEST_CASE("A pinched sphere is an endless impact, and answered as if inelastic")
{
    for (const ImpactOperator which : {ImpactOperator::sequential, ImpactOperator::jacobi, ImpactOperator::shock}) {
        const ClusterImpact impact = resolve(pinched(), which);
        CHECK(impact.capped);
        CHECK((impact.velocities[0] - Vec3(0, 0.5, 0)).norm() < rounding);
    }
}

TEST_CASE("A complementarity problem lets all balls of a cradle leave, exactly or by sweeps, Newton's or Poisson's")
{
    for (const LcpLaw law : {LcpLaw::newton, LcpLaw::poisson})
        for (const LcpSolver solver : {LcpSolver::exact, LcpSolver::gauss_seidel}) {
            const LcpOptions options{law, solver, 1000};
            const double within = solver == LcpSolver::exact ? rounding : 1e-10;
            check_row(resolve(cradle(1), ImpactOperator::lcp, options), {-0.6, 0.4, 0.4, 0.4, 0.4}, within);
            check_row(resolve(row({1, 2, 1}, {1, 0, 0}), ImpactOperator::lcp, options), {-0.5, 0.5, 0.5}, within);
        }
}

TEST_CASE("Few sweeps leave an error, but nothing that closes")
{
    const LcpOptions options{LcpLaw::newton, LcpSolver::gauss_seidel, 2};
    const ClusterImpact impact = resolve(cradle(1), ImpactOperator::lcp, options);
    CHECK(debts(cradle(1), impact).closing < 1e-9);
    CHECK((impact.velocities[4] - Vec3(0.4, 0, 0)).norm() > 1e-3);
}

TEST_CASE("With one restitution Newton's and Poisson's laws gain no energy")
{
    carom::Random random(21);
    for (int trial = 0; trial < 300; ++trial) {
        RandomClusters options;
        options.most_contacts = 20;
        options.mass_ratio = 1e3;
        ContactProblem cluster = random_cluster(random, options);
        const double e = random.uniform();
        for (Contact& contact : cluster.contacts) contact.restitution = e;
        for (const LcpLaw law : {LcpLaw::newton, LcpLaw::poisson}) {
            const ClusterImpact impact = resolve(cluster, ImpactOperator::lcp, {law, LcpSolver::exact, 100});
            const Debts owed = debts(cluster, impact);
            CAPTURE(trial, e);
            CHECK(owed.energy < 1e-9);
            CHECK(owed.closing < 1e-9);
            CHECK(owed.momentum < 1e-12);
            CHECK(owed.pull < 1e-12);
        }
    }
}

TEST_CASE("Newton's law with mixed restitution gains energy: why the blend is of velocities")
{
    double most = 0;
    carom::Random random(22);
    for (int trial = 0; trial < 300; ++trial) {
        RandomClusters options;
        options.most_contacts = 10;
        options.share_jammed = 0;
        const ContactProblem cluster = random_cluster(random, options);
        most = std::max(most, debts(cluster, resolve(cluster, ImpactOperator::lcp)).energy);
    }
    CHECK(most > 1);
}

TEST_CASE("All at once gains energy in a corner that is sharper than a right angle")
{
    const double half = 0.3;
    const ContactProblem corner = wedge(std::cos(half), std::sin(half), Vec3(0, -1, 0));
    check_row(resolve(row({1, 1}, {1, 0}), ImpactOperator::jacobi), {0, 1});
    double most = 0;
    for (const ContactProblem& cluster : {corner, bernoulli(1), rack_of_15()})
        most = std::max(most, debts(cluster, resolve(cluster, ImpactOperator::jacobi)).energy);
    CHECK(most > 0.01);
}

TEST_CASE("Levels count from what cannot move; the ground takes what lower bodies are given")
{
    CHECK(shock_levels(hit_tower(3)) == std::vector<int>{1, 2, 3, 4});
    CHECK(shock_levels(cradle(1)) == std::vector<int>(5, 1));
    const ClusterImpact tower = resolve(hit_tower(5), ImpactOperator::shock);
    CHECK(tower.rounds == 1);
    for (std::size_t i = 0; i < 5; ++i) CHECK(tower.velocities[i].norm() == 0);
    CHECK((tower.velocities[5] - Vec3(0, 0, 1)).norm() < rounding);
    // Ball of mass 1 onto a resting one of mass 2: the lower one does not feel it.
    CHECK((resolve(onto_resting(), ImpactOperator::shock).velocities[0] - Vec3(0, 0, 1)).norm() < rounding);
}

TEST_CASE("Whatever the operator nothing closes after it")
{
    carom::Random random(31);
    for (const ImpactOperator which :
         {ImpactOperator::sequential, ImpactOperator::lcp, ImpactOperator::shock, ImpactOperator::jacobi}) {
        for (int trial = 0; trial < 200; ++trial) {
            RandomClusters options;
            options.most_contacts = 15;
            options.mass_ratio = 64;
            const ContactProblem cluster = random_cluster(random, options);
            const ClusterImpact impact = resolve(cluster, which);
            CAPTURE(trial, static_cast<int>(which));
            CHECK(nothing_closes(cluster, impact.velocities, 1e-9 * std::max(2.0, largest_speed(impact.velocities))));
            if (which != ImpactOperator::sequential) continue;
            CHECK(debts(cluster, impact).energy < 1e-9);
            CHECK(debts(cluster, impact).momentum < 1e-12);
        }
    }
}

TEST_CASE("The tangential factor is the pair law's with one contact, and takes energy with many")
{
    ContactProblem one;
    one.bodies = {{Vec3(1, 2, -3), 0.5}};
    one.contacts = {{0, immovable, Vec3(0, 0, 1), 0.5, 0.25}};
    const ClusterImpact single = resolve(one, ImpactOperator::reflections);
    CHECK((single.velocities[0] - Vec3(0.25, 0.5, 1.5)).norm() < rounding);
    // The same contact beside another one far away in the cluster, which gets no impulse.
    one.contacts.push_back({0, immovable, Vec3(1, 0, 0), 1, 0.25});
    CHECK((resolve(one, ImpactOperator::reflections).velocities[0] - Vec3(0.25, 0.5, 1.5)).norm() < rounding);

    // Along a groove without any slip the motion stops; two contacts do not throw it back.
    ContactProblem groove = wedge(std::sqrt(0.5), std::sqrt(0.5), Vec3(0, -1, 1));
    for (Contact& contact : groove.contacts) contact.tangential = 0;
    CHECK((resolve(groove, ImpactOperator::reflections).velocities[0] - Vec3(0, 0.5, 0)).norm() < rounding);

    carom::Random random(41);
    for (int trial = 0; trial < 500; ++trial) {
        RandomClusters options;
        options.mass_ratio = 1e3;
        options.most_contacts = 20;
        ContactProblem cluster = random_cluster(random, options);
        for (Contact& contact : cluster.contacts) contact.tangential = random.uniform();
        const ClusterImpact rough = resolve(cluster, ImpactOperator::reflections);
        for (Contact& contact : cluster.contacts) contact.tangential = 1;
        const ClusterImpact smooth = resolve(cluster, ImpactOperator::reflections);
        const Debts owed = debts(cluster, rough);
        CHECK(owed.energy <= debts(cluster, smooth).energy + rounding);
        CHECK(owed.closing < 1e-9);
        CHECK(owed.momentum < rounding);
    }
}
