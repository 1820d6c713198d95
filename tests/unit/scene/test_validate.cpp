#include "scene/validate.hpp"

#include <catch2/catch.hpp>
#include <limits>

using namespace carom;
using Catch::StartsWith;

namespace {

Scene one_ball()
{
    Scene s;
    s.end_time = 1;
    Sphere ball;
    ball.id = "ball";
    ball.radius = 0.5;
    ball.position = Vec3(0, 0, 1);
    s.spheres.push_back(ball);
    Plane floor;
    floor.id = "floor";
    s.planes.push_back(floor);
    return s;
}

/// The one broken rule after a change to a valid scene.
template <class Change>
std::string broken_by(Change&& change)
{
    Scene s = one_ball();
    change(s);
    const auto lines = validate(s);
    return lines.size() == 1 ? lines.front() : "(" + std::to_string(lines.size()) + " lines)";
}

}  // namespace

TEST_CASE("a good scene breaks no rule", "[scene]")
{
    CHECK(validate(one_ball()).empty());
}

TEST_CASE("each rule on responses is checked", "[scene]")
{
    CHECK_THAT(broken_by([](Scene& s) { s.impact.tie = -1e-12; }), StartsWith("/impact/tie: must be finite and >= 0"));
    CHECK_THAT(broken_by([](Scene& s) { s.impact.tie = 0.011; }),
               StartsWith("/impact/tie: must be at most 0.01 of a radius"));
    CHECK_THAT(broken_by([](Scene& s) { s.rest.gap_tolerance = 0.011 * s.spheres[0].radius; }),
               StartsWith("/rest/gap_tolerance: must be at most "));
    CHECK_THAT(broken_by([](Scene& s) {
                   s.gravity = {0, 0, -8};
                   s.rest.closing_speed = 4.1 * std::sqrt(s.spheres[0].radius);
               }),
               StartsWith("/rest/closing_speed: must be at most "));
    CHECK_THAT(broken_by([](Scene& s) { s.impact.lcp.sweeps = 0; }), StartsWith("/impact/sweeps: must be at least 1"));
    CHECK_THAT(broken_by([](Scene& s) { s.guard.impacts = -3; }),
               StartsWith("/guard/impacts: must be at least 1, is -3"));
    CHECK_THAT(broken_by([](Scene& s) { s.guard.window = 0; }), StartsWith("/guard/window: must be finite and > 0"));
}

TEST_CASE("planes are parallel or make an angle", "[scene]")
{
    const auto with = [](double angle, double sign) {
        return [=](Scene& s) {
            s.planes = {{"floor", Vec3::UnitZ(), -10, {}, 0},
                        {"other", sign * Vec3(std::sin(angle), 0, std::cos(angle)), -10, {}, 0}};
        };
    };
    for (const double sign : {1.0, -1.0}) {
        for (const double angle : {0.0, 1e-16, 1e-6, 1.0}) {
            Scene s = one_ball();
            with(angle, sign)(s);
            CHECK(validate(s).empty());
        }
        for (const double angle : {1e-14, 1e-7})
            CHECK_THAT(broken_by(with(angle, sign)),
                       StartsWith("/planes/1/normal: is parallel to plane \"floor\" to within "));
    }
}

TEST_CASE("each rule on values is checked", "[scene]")
{
    constexpr double inf = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();
    CHECK_THAT(broken_by([](Scene& s) { s.end_time = 0; }), StartsWith("/end_time: "));
    CHECK_THAT(broken_by([&](Scene& s) { s.gravity.y() = nan; }), StartsWith("/gravity: "));
    CHECK_THAT(broken_by([](Scene& s) { s.spheres[0].radius = 0; }), StartsWith("/spheres/0/radius: "));
    CHECK_THAT(broken_by([&](Scene& s) { s.spheres[0].mass = inf; }), StartsWith("/spheres/0/mass: "));
    CHECK_THAT(broken_by([&](Scene& s) { s.spheres[0].position.x() = inf; }), StartsWith("/spheres/0/position: "));
    CHECK_THAT(broken_by([&](Scene& s) { s.spheres[0].velocity.z() = -inf; }), StartsWith("/spheres/0/velocity: "));
    CHECK_THAT(broken_by([](Scene& s) { s.spheres[0].material = 1; }), StartsWith("/spheres/0/material: "));
    CHECK_THAT(broken_by([](Scene& s) { s.planes[0].normal *= 1.001; }), StartsWith("/planes/0/normal: "));
    CHECK_THAT(broken_by([](Scene& s) { s.planes[0].thickness = -1; }), StartsWith("/planes/0/thickness: "));
    CHECK_THAT(broken_by([&](Scene& s) { s.planes[0].offset = nan; }), StartsWith("/planes/0/offset: "));
    CHECK_THAT(broken_by([](Scene& s) { s.planes[0].material = -1; }), StartsWith("/planes/0/material: "));
    CHECK_THAT(broken_by([](Scene& s) { s.materials[0].restitution = 1.5; }),
               StartsWith("/materials/default/restitution: "));
    CHECK_THAT(broken_by([&](Scene& s) { s.materials[0].tangential = nan; }),
               StartsWith("/materials/default/tangential: "));
    CHECK_THAT(broken_by([](Scene& s) {
                   s.contacts.push_back({0, 2, {}, {}, {}});
               }),
               StartsWith("/contacts/0/between/1: "));
    CHECK_THAT(broken_by([](Scene& s) {
                   s.contacts.push_back({0, 0, {}, {}, -0.5});
               }),
               StartsWith("/contacts/0/attenuation: "));
    CHECK_THAT(broken_by([](Scene& s) { s.rest.numeric_step = 0; }), StartsWith("/rest/numeric_step: "));
    CHECK_THAT(broken_by([](Scene& s) { s.rest.series_below = -1; }), StartsWith("/rest/series_below: "));
    CHECK_THAT(broken_by([](Scene& s) {
                   Check c;
                   c.type = static_cast<CheckType>(check_type_names.size());
                   s.checks.push_back(c);
               }),
               StartsWith("/checks/0/type: "));
    CHECK_THAT(broken_by([](Scene& s) {
                   Check c;
                   c.type = CheckType::rest_time;
                   c.body = 1;
                   s.checks.push_back(c);
               }),
               StartsWith("/checks/0/body: "));
    CHECK_THAT(broken_by([](Scene& s) {
                   Check c;
                   c.type = CheckType::energy;
                   c.rel = -1;
                   s.checks.push_back(c);
               }),
               StartsWith("/checks/0/rel: "));
    CHECK_THAT(broken_by([](Scene& s) {
                   Check c;
                   c.type = CheckType::energy;
                   c.rel = 1;
                   c.abs = 1;
                   s.checks.push_back(c);
               }),
               StartsWith("/checks/0: has both abs and rel"));
    CHECK_THAT(broken_by([](Scene& s) {
                   Check c;
                   c.type = CheckType::event_time;
                   c.between = {0, 7};
                   s.checks.push_back(c);
               }),
               StartsWith("/checks/0/between: "));
    const auto with_stress = [](auto&& change) {
        return [change](Scene& s) {
            s.stress.emplace().case_name = "any";
            s.stress->dt = 1;
            change(*s.stress);
        };
    };
    CHECK_THAT(broken_by(with_stress([](StressPart& part) { part.case_name.clear(); })), StartsWith("/stress/case: "));
    CHECK_THAT(broken_by(with_stress([](StressPart& part) { part.dt = 0; })), StartsWith("/stress/dt: "));
    CHECK_THAT(broken_by(with_stress([](StressPart& part) { part.exact = -1; })), StartsWith("/stress/exact: "));
    CHECK_THAT(broken_by(with_stress([](StressPart& part) { part.limit = -1; })), StartsWith("/stress/limit: "));
    CHECK_THAT(broken_by([](Scene& s) { s.planes[0].id = "ball"; }),
               StartsWith("/planes/0: id \"ball\" is already that of /spheres/0"));
}

TEST_CASE("places, where given, replace the indices in messages", "[scene]")
{
    Scene s = one_ball();
    s.spheres[0].mass = 0;
    s.planes[0].offset = std::numeric_limits<double>::infinity();
    Patience endless;
    const auto lines = validate(s, false, {{"/fill/3"}, {"/box"}}, endless);
    REQUIRE(lines.size() == 2);
    CHECK_THAT(lines[0], StartsWith("/fill/3/mass: "));
    CHECK_THAT(lines[1], StartsWith("/box/offset: "));
}
