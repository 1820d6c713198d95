#include "tunnel/study.hpp"
#include "unit/tunnel/dummies.hpp"

#include <catch2/catch.hpp>

#include <cmath>

using namespace carom;
using namespace carom::test;
using namespace carom::tunnel;

TEST_CASE("critical speeds are (r + thickness/2)/dt and sqrt((r1+r2)^2 - b^2)/dt within 2 %", "[tunnel]")
{
    for (const double radius : {0.01, 0.3})
        for (const double dt : {1.0 / 60, 1e-4})
            for (const auto& [method, chords] : {std::pair("velocity", 1), {"pbd", 1}, {"bisection", 2}}) {
                CAPTURE(radius, dt, method);
                const Cell plate{Target::plate, 0.02, radius, dt, 1}, ball{Target::sphere, 0.02, radius, dt, 1};
                CHECK(find_critical(contestant(method), plate, 0).speed ==
                      Approx(chords * (radius + 0.01) / dt).epsilon(0.02));
                const double b = 0.8 * (radius + 0.01);
                CHECK(find_critical(contestant(method), ball, 0.8).speed ==
                      Approx(chords * std::sqrt((radius + 0.01) * (radius + 0.01) - b * b) / dt).epsilon(0.02));
            }
}

TEST_CASE("a search ends where nothing tunnels, and says so", "[tunnel]")
{
    const Cell plate{Target::plate, 0.02, 0.1, 1.0 / 60, 1};
    for (const char* method : {"event", "toi"}) {
        const CriticalSpeed found = find_critical(contestant(method), plate, 0);
        CHECK(found.end == CriticalSpeed::End::never);
        CHECK(found.speed > 1e5 * 0.11 * 60);
    }
}

TEST_CASE("a search that begins where throws tunnel goes down until they do not", "[tunnel]")
{
    const auto above = [](double critical) {
        return search_critical(1, [=](double speed) -> std::optional<bool> { return speed >= critical; });
    };
    for (const double critical : {4e-6, 0.004, 0.0499, 0.0501, 7.0, 4e5}) {
        CHECK(above(critical).end == CriticalSpeed::End::found);
        CHECK(above(critical).speed == Approx(critical).epsilon(0.01));
    }
    CHECK(above(1e-9).end == CriticalSpeed::End::below);
    CHECK(above(1e-9).speed < 1e-5);
    CHECK(find_critical(blind(), {Target::plate, 0.02, 0.1, 1.0 / 60, 1}, 0).end == CriticalSpeed::End::below);
}

TEST_CASE("a search ends where no throw can be judged, and claims nothing beyond", "[tunnel]")
{
    const CriticalSpeed found = search_critical(1, [](double speed) -> std::optional<bool> {
        if (speed > 10) return {};
        return false;
    });
    CHECK(found.end == CriticalSpeed::End::never);
    CHECK(found.speed <= 10);
    CHECK(found.speed > 2);
}

TEST_CASE("criticals are listed for plates and, at each offset, for spheres, with the law beside them", "[tunnel]")
{
    Matrix matrix;
    matrix.thickness = {0.02};
    matrix.radius = {0.1};
    matrix.dt = {0.01};
    matrix.offsets = {0, 0.6};
    Report report;
    find_criticals(matrix, {contestant("velocity"), contestant("event")}, report, {});
    REQUIRE(report.criticals.size() == 2 * (1 + 2));
    CHECK(report.criticals[0].law.value() == Approx(11));
    CHECK(report.criticals[2].law.value() == Approx(0.8 * 11));
    CHECK(std::isinf(report.criticals[3].law.value()));
    CHECK(report.criticals[3].speed.end == CriticalSpeed::End::never);
    Report stopped;
    find_criticals(matrix, {contestant("event")}, stopped, [](const Progress&) { return false; });
    CHECK(stopped.interrupted);
    CHECK(stopped.criticals.empty());
}
