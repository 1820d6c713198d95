#include "unit/projection/half_space_oracle.hpp"

#include "random_heap.hpp"
#include "window/interior_point.hpp"
#include "window/relaxation.hpp"

#include <catch2/catch.hpp>

using namespace carom;

namespace {

ProjectionProblem random_problem(test::Random& random, int vectors, int half_spaces)
{
    ProjectionProblem out;
    for (int k = 0; k < vectors; ++k) {
        out.start.push_back(random.in_cube(1));
        out.w.push_back(random.log_uniform(0.1, 10));
    }
    for (int i = 0; i < half_spaces; ++i) {
        HalfSpace h{random.integer(0, vectors - 1), {}, random.direction(), random.uniform(0, 0.3)};
        const int b = random.integer(0, vectors - 1);
        if (b != h.a) h.b = b;
        out.half_spaces.push_back(h);
    }
    return out;
}

}  // namespace

TEST_CASE("interior points find the nearest point, as trying all active sets does", "[window]")
{
    test::Random random(30);
    for (int k = 0; k < 60; ++k) {
        const ProjectionProblem problem = random_problem(random, random.integer(1, 4), random.integer(1, 8));
        const Projection solved = interior_point(problem, 1);
        const std::vector<Vec3> expected = test::project_by_trying(problem);
        INFO("problem " << k);
        REQUIRE(solved.complete);
        for (std::size_t i = 0; i < expected.size(); ++i) CHECK((solved.point[i] - expected[i]).norm() < 1e-6);
    }
}

TEST_CASE("interior points of many half-spaces satisfy the conditions of the nearest point", "[window]")
{
    test::Random random(31);
    for (int k = 0; k < 10; ++k) {
        const ProjectionProblem problem = random_problem(random, 60, 150);
        const Projection solved = interior_point(problem, 1);
        INFO("problem " << k);
        REQUIRE(solved.complete);
        std::vector<Vec3> pushed = problem.start;
        for (std::size_t i = 0; i < problem.half_spaces.size(); ++i) {
            const double left = slack(problem.half_spaces[i], solved.point);
            CHECK(solved.multipliers[i] >= 0);
            CHECK(left > -1e-10);
            // Slacks that a multiplier bears are promised to 1e-11 of the normals' lengths, up to 4.5 here.
            CHECK(solved.multipliers[i] * left < 4.5e-11 * std::max(1.0, solved.multipliers[i]));
            push(problem.half_spaces[i], problem.w, solved.multipliers[i], pushed);
        }
        for (std::size_t i = 0; i < pushed.size(); ++i) CHECK((pushed[i] - solved.point[i]).norm() == 0);
    }
}

TEST_CASE("relaxation approaches the same point", "[window]")
{
    test::Random random(32);
    for (int k = 0; k < 20; ++k) {
        const ProjectionProblem problem = random_problem(random, 8, 12);
        const Projection solved = interior_point(problem, 1);
        std::vector<RelaxationRow> rows;
        for (const HalfSpace& h : problem.half_spaces) {
            RelaxationRow row;
            row.a = h.a;
            row.b = h.b.value_or(8);
            row.normal = h.normal;
            row.weight_a = problem.w[static_cast<std::size_t>(h.a)];
            row.weight_b = h.b ? problem.w[static_cast<std::size_t>(*h.b)] : 0;
            row.wanted = row.least = -h.offset;
            rows.push_back(row);
        }
        std::vector<Vec3> u = problem.start;
        u.emplace_back(Vec3::Zero());
        relax(rows, u, {1e-10, 20000});
        INFO("problem " << k);
        for (std::size_t i = 0; i < problem.start.size(); ++i) CHECK((u[i] - solved.point[i]).norm() < 1e-5);
    }
}
