#include "impact/exact_steps.hpp"
#include "impact/operators.hpp"

#include "contact/contact_problem.hpp"
#include "support/clusters.hpp"
#include "support/pair_by_pair.hpp"

#include <catch2/catch.hpp>

#include <cmath>

using namespace carom;
using namespace carom::test;

namespace {

constexpr double within = 1e-9;

/// A light ball between two heavy ones: the left one comes in.
struct Between {
    double heavy = 1, right = 1;

    ContactProblem cluster(double e) const { return row({heavy, 1, right * heavy}, {1, 0, 0}, e); }
    /// Masses as the engine has them, by their inverses.
    std::vector<Float60> masses() const
    {
        std::vector<Float60> out;
        for (const ContactBody& body : cluster(1).bodies) out.push_back(1 / Float60(body.inverse_mass));
        return out;
    }
};

double off(const ClusterImpact& impact, std::size_t body, const Float60& expected)
{
    return std::abs(static_cast<double>(Float60(impact.velocities[body].x()) - expected));
}

ClusterImpact resolve(const ContactProblem& cluster, ImpactOperator which)
{
    ImpactOptions options;
    options.impact_operator = which;
    return resolve_cluster(cluster, options);
}

void check_reflections(double heavy)
{
    for (const double right : {1.0, 0.3, 7.0}) {
        const Between between{heavy, right};
        const std::vector<Float60> masses = between.masses(), before{1, 0, 0};
        const PairByPair apart = pair_by_pair(masses, before, 1);
        for (const double e : {1.0, 0.9, 0.5, 0.0}) {
            const ClusterImpact impact = resolve(between.cluster(e), ImpactOperator::reflections);
            CAPTURE(heavy, right, e, impact.rounds);
            CHECK_FALSE(impact.capped);
            for (std::size_t i = 0; i < 3; ++i)
                CHECK(off(impact, i, Float60(e) * apart.velocities[i] + (1 - Float60(e)) * together(masses, before)) <
                      within);
        }
    }
}

}  // namespace

TEST_CASE("A light ball between heavy ones: reflections give e times what elastic pairs give, the rest what sticks")
{
    for (const double heavy : {1e2, 1e4, 1e6, 1e8}) check_reflections(heavy);
}

TEST_CASE("The same at a ratio of masses of 1e12, seconds of 60 digits", "[.]")
{
    check_reflections(1e12);
}

TEST_CASE("A light ball between heavy ones: sequential gives the limit of pairs, of e = 0 where they collapse")
{
    for (const double heavy : {1e2, 1e3, 1e4, 1e6, 1e9, 1e12})
        for (const double e : {1.0, 0.9, 0.5, 0.0}) {
            if (e == 1 && heavy > 1e8) continue;
            const Between between{heavy};
            const std::vector<Float60> masses = between.masses(), before{1, 0, 0};
            // Two contacts at an angle pi - psi in the metric of kinetic energy turn real: (1 + e) sin psi < 1 - e.
            const bool collapses = (1 + e) * std::sqrt(2 / heavy) < 1 - e;
            PairByPair limit;
            if (heavy <= 1e3 || e == 1)
                limit = pair_by_pair(masses, before, e);
            else if (collapses)
                limit.velocities.assign(3, together(masses, before));
            else
                continue;
            const ClusterImpact impact = resolve(between.cluster(e), ImpactOperator::sequential);
            CAPTURE(heavy, e, impact.rounds, collapses);
            CHECK_FALSE(impact.capped);
            for (std::size_t i = 0; i < 3; ++i) CHECK(off(impact, i, limit.velocities[i]) < within);
            if (collapses)
                for (std::size_t i = 0; i < 3; ++i) CHECK(off(impact, i, together(masses, before)) < within);
        }
}

TEST_CASE("Sequential at a ratio of masses of 1e12 and e = 1, seconds of 60 digits", "[.]")
{
    const Between between{1e12};
    const PairByPair limit = pair_by_pair(between.masses(), {1, 0, 0}, 1);
    const ClusterImpact impact = resolve(between.cluster(1), ImpactOperator::sequential);
    CHECK_FALSE(impact.capped);
    for (std::size_t i = 0; i < 3; ++i) CHECK(off(impact, i, limit.velocities[i]) < within);
}

TEST_CASE("A heavy ball on a light one that rests on the ground rebounds by the law of reflections")
{
    for (const double e : {1.0, 0.9, 0.5, 0.0}) {
        ContactProblem cluster;
        cluster.bodies = {{Vec3(-1, 0, 0), 1e-6}, {Vec3::Zero(), 1}};
        cluster.contacts = {{0, 1, Vec3(1, 0, 0), e, 1}, {1, immovable, Vec3(1, 0, 0), e, 1}};
        // The ground is a mirror: the row of these two and their images, which has no middle to collide in.
        const PairByPair apart =
            pair_by_pair({1 / Float60(1e-6), 1, Float60("1e60")}, {Float60(1), Float60(0), Float60(0)}, 1);
        const ClusterImpact impact = resolve(cluster, ImpactOperator::reflections);
        CAPTURE(e);
        CHECK(off(impact, 0, -Float60(e) * apart.velocities[0]) < within);
        CHECK(off(impact, 1, -Float60(e) * apart.velocities[1]) < within);
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

TEST_CASE("Rows of light and heavy balls: reflections give what elastic pairs give, where one contact closes at a time")
{
    // Two light balls between three heavy ones, and what comes in at one end goes through both.
    for (const std::vector<double>& masses :
         {std::vector<double>{1e5, 1, 1e5, 1e5}, {1e6, 1, 1e6, 3}, {1e4, 1, 1e7, 1}, {1, 1e6, 1, 1e6}}) {
        std::vector<Float60> exact;
        std::vector<Float60> before;
        const ContactProblem cluster = row(masses, {1, 0, 0, 0});
        for (const ContactBody& body : cluster.bodies) {
            exact.push_back(1 / Float60(body.inverse_mass));
            before.emplace_back(body.velocity.x());
        }
        const ClusterImpact impact = resolve_cluster(cluster, {});
        const ClusterImpact one_by_one = resolve(cluster, ImpactOperator::sequential);
        const PairByPair pairs = pair_by_pair(exact, before, 1);
        CAPTURE(masses[0], masses[1], masses[2], masses[3], impact.rounds, pairs.impacts);
        CHECK_FALSE(impact.capped);
        CHECK(debts(cluster, impact).closing < within);
        CHECK(std::abs(debts(cluster, impact).energy) < within);
        for (std::size_t i = 0; i < 4; ++i) CHECK(off(one_by_one, i, pairs.velocities[i]) < within);
    }
}

TEST_CASE("Inelastic operators mean themselves: in a sharp corner one contact after the other, or both at once")
{
    // Two walls whose normals make 60 degrees, and a ball that closes on both, but slides off the first one on the
    // second: the nearest velocities touch the second wall alone.
    const double half = 0.5235987755982988;
    const ContactProblem corner = [&] {
        ContactProblem out;
        out.bodies = {{Vec3(0, -1, 0), 1}};
        out.contacts = {{0, immovable, Vec3(std::sin(half), std::cos(half), 0), 0, 1},
                        {0, immovable, Vec3(0, 1, 0), 0, 1}};
        return out;
    }();
    const Vec3 first = corner.contacts[0].normal;
    const Vec3 slid = Vec3(0, -1, 0) + first.y() * first;  // off the first wall
    CHECK((resolve(corner, ImpactOperator::reflections).velocities[0] - Vec3::Zero()).norm() < within);
    CHECK((resolve(corner, ImpactOperator::lcp).velocities[0] - Vec3::Zero()).norm() < within);
    CHECK((resolve(corner, ImpactOperator::sequential).velocities[0] - Vec3(slid.x(), 0, 0)).norm() < within);
    CHECK((resolve(corner, ImpactOperator::shock).velocities[0] - Vec3(slid.x(), 0, 0)).norm() < within);
    CHECK((resolve(corner, ImpactOperator::jacobi).velocities[0] - first.y() * first).norm() < within);
}

TEST_CASE("Inelastic rows come together under every operator that keeps momentum")
{
    const ContactProblem three = row({1, 2, 3}, {1, 0, -1}, 0), many = row(
                                                                    std::vector<double>(30, 1.0),
                                                                    [] {
                                                                        std::vector<double> speeds(30, 0.0);
                                                                        speeds[0] = 1;
                                                                        return speeds;
                                                                    }(),
                                                                    0);
    for (const ImpactOperator which :
         {ImpactOperator::reflections, ImpactOperator::sequential, ImpactOperator::jacobi}) {
        CAPTURE(static_cast<int>(which));
        const ClusterImpact few = resolve(three, which), row_of_30 = resolve(many, which);
        CHECK_FALSE(few.capped);
        CHECK_FALSE(row_of_30.capped);
        for (const Vec3& v : few.velocities) CHECK(std::abs(v.x() + 1.0 / 3) < within);
        for (const Vec3& v : row_of_30.velocities) CHECK(std::abs(v.x() - 1.0 / 30) < within);
    }
}

TEST_CASE("Periods of steps taken at once are what they are one by one")
{
    struct Swept {
        std::vector<Vec3> velocities;
        int steps = 0;
    };
    // Reflects contact after contact until nothing closes.
    const auto sweep = [](const ProjectionProblem& problem, Pace pace) {
        constexpr int most = 4'000;
        ExactSteps steps(problem, 1e-12 * largest_speed(problem.start), pace);
        Swept out;
        std::vector<int> open;
        const int all = static_cast<int>(steps.contacts());
        for (int i = 0, quiet = 0; quiet < all && out.steps < most; i = (i + 1) % all, ++quiet) {
            if (!steps.closes(i)) {
                open.push_back(i);
                continue;
            }
            if (!steps.take_and_repeat({{i}, open, 2})) break;
            open.clear();
            quiet = -1;
            ++out.steps;
        }
        out.velocities = steps.vectors();
        return out;
    };
    carom::Random random(17);
    int compared = 0, fewer = 0;
    for (int trial = 0; trial < 2000; ++trial) {
        RandomClusters options;
        options.most_contacts = 8;
        options.mass_ratio = 1e6;
        options.share_jammed = 0;
        const ContactProblem cluster = random_cluster(random, options);
        const ProjectionProblem problem = projection_problem(cluster);
        const Swept slow = sweep(problem, Pace::one_by_one);
        if (slow.steps == 4'000 || slow.steps < 40) continue;
        const Swept quick = sweep(problem, Pace::at_once);
        CAPTURE(trial, slow.steps, quick.steps);
        ++compared;
        fewer += 2 * quick.steps < slow.steps ? 1 : 0;
        for (std::size_t i = 0; i < cluster.bodies.size(); ++i)
            CHECK((quick.velocities[i] - slow.velocities[i]).norm() < within);
    }
    CHECK(compared > 20);
    CHECK(fewer > 5);
}
