#include "study/search/step_scan.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <functional>

using namespace carom;
using study::StepScan;

namespace {

constexpr double tolerance = 1e-3;
using ErrorOf = std::function<double(double dt)>;

void try_next(StepScan& scan, double dt, const ErrorOf& error)
{
    scan.add({dt, error(dt), error(dt) <= tolerance});
}

/// The scan carried out to its end, with 500 steps at most.
StepScan scanned(const ErrorOf& error, double first, double largest)
{
    StepScan scan(first, largest);
    for (auto dt = scan.next(); dt && scan.tries().size() < 500; dt = scan.next()) try_next(scan, *dt, error);
    return scan;
}

/// The definition, by brute force: the largest of steps a factor of 1.0005 apart from which all smaller ones hold.
double brute_force(const ErrorOf& error, double smallest, double largest)
{
    double enough = 0;
    for (double dt = smallest; dt < largest && error(dt) <= tolerance; dt *= 1.0005) enough = dt;
    return enough;
}

/// An error of first order that scatters with the phase of an impact at `time`.
ErrorOf scattered(double time)
{
    return [=](double dt) {
        const double phase = time / dt;
        return dt * std::abs(phase - std::floor(phase) - 0.5);
    };
}

}  // namespace

TEST_CASE("the step of a smooth error is the one at which it is the tolerance, to a hundredth", "[step_scan]")
{
    for (const double factor : {0.01, 0.3, 1.0, 7.0}) {
        const StepScan scan = scanned([=](double dt) { return factor * dt; }, 1.0 / 60, 1);
        REQUIRE(scan.enough());
        CHECK(*scan.enough() <= tolerance / factor);
        CHECK(*scan.enough() >= 0.99 * tolerance / factor);
        CHECK(scan.tries().size() < 200);
    }
}

TEST_CASE("a band of steps that fail below a larger one that holds is found", "[step_scan]")
{
    // Holds up to 0.001, but not from 0.52 to 0.56 of that.
    const StepScan scan = scanned([](double dt) { return dt > 5.2e-4 && dt < 5.6e-4 ? 1 : dt; }, 1.0 / 60, 0.1);
    REQUIRE(scan.enough());
    CHECK(*scan.enough() <= 5.2e-4);
    CHECK(*scan.enough() >= 5.1e-4);
}

TEST_CASE("steps found where errors scatter are those of the definition within a fifth", "[step_scan]")
{
    for (const double time : {0.98, 0.993, 1.19, 1.31, 1.42, 1.55, 1.78, 1.89}) {
        const ErrorOf error = scattered(time);
        const StepScan scan = scanned(error, 1.0 / 60, 0.1);
        INFO("impact at " << time);
        REQUIRE(scan.enough());
        const double truth = brute_force(error, 1e-5, 0.1);
        CHECK(*scan.enough() >= 0.8 * truth);
        CHECK(*scan.enough() <= 1.2 * truth);
    }
}

TEST_CASE("where every step holds the largest is the answer, and a quarter of it and more were tried", "[step_scan]")
{
    const StepScan scan = scanned([](double) { return 0; }, 1.0 / 60, 0.25);
    REQUIRE(scan.enough());
    CHECK(*scan.enough() == 0.25);
    CHECK(scan.tries().front().dt <= 0.0626);
    CHECK(scan.tries().size() > 64);
    CHECK(scan.tries().size() < 200);
}

TEST_CASE("where no step holds ever smaller ones are tried, a factor of 4 apart", "[step_scan]")
{
    StepScan scan(0.1, 1);
    for (int k = 0; k < 10; ++k) {
        const auto dt = scan.next();
        REQUIRE(dt);
        CHECK(*dt == Approx(0.1 * std::pow(4, -k)));
        scan.add({*dt, std::nullopt, false});
    }
    CHECK_FALSE(scan.enough());
}

TEST_CASE("a step known before that fails bounds the answer", "[step_scan]")
{
    StepScan scan(0.1, 1);
    scan.add({0.1, 2e-4, true});
    scan.add({0.0123, 0.5, false});
    for (auto dt = scan.next(); dt && scan.tries().size() < 500; dt = scan.next())
        try_next(scan, *dt, [](double step) { return step / 1000; });
    REQUIRE(scan.enough());
    CHECK(*scan.enough() < 0.0123);
    CHECK(*scan.enough() > 0.0121);
}

TEST_CASE("the figures of a search count what holds at or below the step found", "[step_scan]")
{
    StepSearch search;
    search.row = CompareRow{};
    search.row->dt = 0.02;
    search.tries = {{0.01, 5e-4, true}, {0.02, 4e-4, true}, {0.03, 2e-3, false}, {0.04, 1e-4, true}};
    const study::SearchFigures told = study::figures_of(search);
    CHECK(told.held == 2);
    CHECK(told.worst_error == 5e-4);
    CHECK(told.too_far->dt == 0.03);
    CHECK(told.fails->dt == 0.03);
    CHECK(told.best->dt == 0.04);
    CHECK(told.lucky == 1);
}
