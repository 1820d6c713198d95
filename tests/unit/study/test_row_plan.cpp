#include "study/row_plan.hpp"

#include "make_sphere.hpp"

#include <catch2/catch.hpp>

#include <algorithm>

using namespace carom;
using namespace carom::study;

namespace {

Scene ball(double gravity)
{
    Scene scene;
    scene.gravity = Vec3(0, 0, -gravity);
    scene.spheres.push_back(make_sphere("ball", 0.1));
    return scene;
}

std::size_t rows_of(const std::vector<RowPlan>& rows, const std::string& method)
{
    return static_cast<std::size_t>(
        std::count_if(rows.begin(), rows.end(), [&](const RowPlan& row) { return name(row.method) == method; }));
}

}  // namespace

TEST_CASE("a method is run once for values of options that it does not read", "[compare]")
{
    CompareOptions options;
    options.methods = {"event", "pbd", "velocity", "bisection", "naive", "moreau"};
    options.dt = {0.1, 0.01};
    options.passes = {1, 4, 16};
    options.orders = {ContactOrder::index, ContactOrder::jacobi};
    options.integrators = {Integrator::euler, Integrator::parabola};
    const auto falling = rows_to_run(ball(9.81), options), floating = rows_to_run(ball(0), options);
    CHECK(rows_of(falling, "event") == 1);
    CHECK(rows_of(falling, "pbd") == 2 * 3 * 2 * 2);
    CHECK(rows_of(falling, "velocity") == 2 * 3 * 2);  // jacobi is pbd's alone
    for (const char* method : {"bisection", "naive", "moreau"}) {
        CHECK(rows_of(falling, method) == 2 * 2);
        CHECK(rows_of(floating, method) == 2);  // both integrators fly straight
    }
}

TEST_CASE("springs are those asked for, in the method and in what its row says of it", "[compare]")
{
    CompareOptions options;
    options.methods = {"penalty", "soft", "pbd"};
    options.dt = {0.01};
    options.hertz = 60;
    options.damping_ratio = 0.5;
    const auto springs_of = [&](const RowPlan& plan) {
        CompareRow row;
        describe(plan, row);
        return row;
    };
    CHECK_FALSE(springs_of(rows_to_run(ball(9.81), options)[0]).stiffness);
    options.stiffness = 2e3;
    const auto rows = rows_to_run(ball(9.81), options);
    CHECK(std::get<Penalty>(rows[0].method).stiffness == 2e3);
    CHECK(springs_of(rows[0]).stiffness == 2e3);
    CHECK(std::get<Soft>(rows[1].method).hertz == 60);
    CHECK(springs_of(rows[1]).hertz == 60);
    CHECK(springs_of(rows[1]).damping_ratio == 0.5);
    CHECK_FALSE(springs_of(rows[2]).stiffness);
    CHECK_FALSE(springs_of(rows[2]).hertz);
}

TEST_CASE("operators are rows of the event method alone", "[compare]")
{
    CompareOptions options;
    options.methods = {"event", "pbd", "event"};
    options.dt = {0.1};
    options.impacts = {ImpactOperator::reflections, ImpactOperator::lcp};
    const auto rows = rows_to_run(ball(0), options);
    REQUIRE(rows.size() == 3);
    CHECK(rows[0].impact == ImpactOperator::reflections);
    CHECK(rows[1].impact == ImpactOperator::lcp);
    CHECK_FALSE(rows[2].impact);
    CompareRow row;
    describe(rows[2], row);
    CHECK(row.passes == 1);
    CHECK(row.order == ContactOrder::index);
    CHECK_FALSE(row.impact);
}
