#include "projection/dual_active_set.hpp"

#include "support/random.hpp"

#include <catch2/catch.hpp>

using namespace carom;

TEST_CASE("Half-spaces without a common inside are named as conflict, with those that matter only")
{
    // x >= 1, -x >= 1, y >= 1
    const ProjectionProblem problem{
        {Vec3::Zero()},
        {1},
        {{0, {}, Vec3(0, 1, 0), -1}, {0, {}, Vec3(1, 0, 0), -1}, {0, {}, Vec3(-1, 0, 0), -1}},
        1e-9};
    std::vector<int> conflict = dual_active_set(problem).conflict;
    std::sort(conflict.begin(), conflict.end());
    CHECK(conflict == std::vector<int>{1, 2});
}

TEST_CASE("A wedge that is so narrow that its tip lies too far away counts as conflict")
{
    const double slope = 1e-4;  // the tip of |x| <= slope y - 1 is at y = 1/slope
    ProjectionProblem problem{
        {Vec3::Zero()},
        {1},
        {{0, {}, Vec3(1, slope, 0).normalized(), -1}, {0, {}, Vec3(-1, slope, 0).normalized(), -1}},
        1e-9};
    CHECK(dual_active_set(problem, {2 / slope, 0}).conflict.empty());
    CHECK(dual_active_set(problem, {0.5 / slope, 0}).conflict.size() == 2);
    CHECK(dual_active_set(problem).projection.point.front().y() == Approx(1 / slope));
}

TEST_CASE("A wedge that is narrower than rounding tells is none, and hinders nothing else")
{
    for (const double slope : {1e-3, 1e-6, 1e-7, 1e-9, 1e-10, 0.0}) {
        const ProjectionProblem problem{{Vec3(0, -1, -1)},
                                        {1},
                                        {{0, {}, Vec3(1, slope, 0).normalized(), 0},
                                         {0, {}, Vec3(-1, slope, 0).normalized(), 0},
                                         {0, {}, Vec3(0.6, 0, 0.8), 0}},
                                        1e-13};
        const DualActiveSetResult solved = dual_active_set(problem);
        CAPTURE(slope);
        CHECK(solved.conflict.empty());
        CHECK(solved.projection.complete);
        const Vec3& point = solved.projection.point.front();
        CHECK(point.x() == Approx(0).margin(1e-7));
        CHECK(point.y() == Approx(slope > 1e-8 ? 0 : -1).margin(1e-7));
        CHECK(point.z() == Approx(0).margin(2e-7));
    }
}
