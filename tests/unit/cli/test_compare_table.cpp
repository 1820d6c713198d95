#include "cli/tables.hpp"

#include <catch2/catch.hpp>

using namespace carom;
using namespace carom::cli;
using Catch::Matchers::Contains;

namespace {

Scene one_ball()
{
    Scene scene;
    scene.name = "Ball";
    scene.units = {"m", "s", "kg"};
    scene.spheres.emplace_back().radius = 0.1;
    return scene;
}

CompareRow row(const char* method, std::optional<double> dt, double error)
{
    CompareRow result;
    result.method = method;
    result.dt = dt;
    result.position_max = error;
    result.cpu_seconds = 2e-6;
    result.reference_impacts = 16;
    result.time = 2;
    return result;
}

Comparison comparison()
{
    Comparison result;
    result.until = result.reference.until = 2;
    result.tolerance = 1e-3;
    result.reference.kind = "multiprecision";
    CompareRow late = row("velocity", 1e-4, 0.00104), never = row("pbd", 1.0 / 60, 0.058);
    late.missed_impacts = 6;
    late.mistimed_impacts = 5;
    late.invented_impacts = 4;
    never.reference_impacts = 0;
    never.divergence_time = 0.01;
    result.rows = {row("event", std::nullopt, 4.6e-16), late, never};
    return result;
}

/// The line of the table that begins with `method`.
std::string line_of(const std::string& table, const std::string& method)
{
    const std::size_t begin = table.find("\n" + method + " ") + 1;
    return table.substr(begin, table.find('\n', begin) - begin);
}

}  // namespace

TEST_CASE("the table tells missed impacts without late ones, and does not call what was never counted perfect",
          "[table]")
{
    const std::string table = compare_table(one_ball(), comparison());
    CHECK_THAT(line_of(table, "velocity"), Contains(" 1/16 ") && Contains(" 4 "));
    CHECK_THAT(line_of(table, "pbd"), Contains("-") && !Contains("0/0"));
    CHECK_THAT(line_of(table, "event"), Contains(" 0/16 "));
}

TEST_CASE("the table gives the audit as shares, with an interval, and what was not asked about", "[table]")
{
    Comparison c = comparison();
    CHECK_THAT(compare_table(one_ball(), c), !Contains("Audit:") && !Contains("crowded  "));
    c.audit = {2, 31, 31, 33, 7, 5};
    c.rows[1].audit = Audit{};
    CHECK_THAT(compare_table(one_ball(), c), Contains("Audit: 31 impacts up to t = 2, each at 33 phases of the step"));
    c.audit = {2, 3000, 2000, 1, 7, 5};
    c.rows[1].audit = Audit{263, 81, 0, 182, 0, 1737, 400, 1, 0.5};
    const std::string table = compare_table(one_ball(), c);
    CHECK_THAT(line_of(table, "velocity"),
               Contains(" 30.8 % (25.5-36.6) ") && Contains(" 69.2 % ") && Contains(" 0.25 % ") && Contains(" 1737 "));
    CHECK_THAT(table, Contains("Audit: 2000 of 3000 impacts up to t = 2, drawn at random") &&
                          Contains("7 closing slower than v_c, 5 contacts that last"));
}

TEST_CASE("the table says which rows are within the tolerance, and what that is", "[table]")
{
    const std::string table = compare_table(one_ball(), comparison());
    CHECK_THAT(table, Contains("Tolerance: position error 1 mm (0.01 of the smallest radius; --tolerance changes it)"));
    CHECK_THAT(line_of(table, "velocity"), Contains(" 0.00104 ") && Contains(" no "));  // two digits would hide it
    CHECK_THAT(line_of(table, "event"), Contains(" yes "));
    CHECK_THAT(table, Contains(compare_legend));
}

TEST_CASE("columns without a figure are left out, and a run that stopped is no measure of cost", "[table]")
{
    Comparison c = comparison();
    CHECK_THAT(compare_table(one_ball(), c), !Contains("jitter [") && !Contains("at end ["));
    CHECK_THAT(line_of(compare_table(one_ball(), c), "method"), Contains("x event"));
    c.rows[0].status = Status::unresolved;
    c.rows[0].time = 1.48126;
    c.reference.until = 1.04679635511;
    c.reference.reason = "with several spheres the reference ends at the first rest";
    const std::string table = compare_table(one_ball(), c);
    CHECK_THAT(line_of(table, "method"), !Contains("x event"));
    CHECK_THAT(line_of(table, "event"), Contains("unresolved at 1.4813"));
    CHECK_THAT(table, Contains("it ends at t = 1.0468 s, errors and impacts are counted up to there"));
}

TEST_CASE("advice after an unresolved run is a time just before it", "[table]")
{
    Outcome outcome;
    CHECK(unresolved_advice(outcome).empty());
    outcome.status = Status::unresolved;
    CHECK(unresolved_advice(outcome).empty());  // nothing was computed
    outcome.time = 1.481265;
    CHECK_THAT(unresolved_advice(outcome), Contains("--until 1.48 "));
    outcome.time = 0.25;
    CHECK_THAT(unresolved_advice(outcome), Contains("--until 0.249 "));
}
