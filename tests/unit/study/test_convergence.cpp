#include "study/convergence.hpp"
#include "study/fit_orders.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <vector>

using namespace carom::study;
using carom::StepSearch;

TEST_CASE("the order of a power law is its exponent, without uncertainty", "[convergence]")
{
    for (const double order : {0.5, 1.0, 2.0}) {
        std::vector<StepError> points;
        for (const double dt : {0.1, 0.03, 0.01, 0.001}) points.push_back({dt, 7 * std::pow(dt, order)});
        const auto fit = fitted_order(points);
        REQUIRE(fit);
        CHECK(fit->order == Approx(order));
        CHECK(fit->uncertainty == Approx(0).margin(1e-12));
        CHECK(fit->steps == 4);
    }
    CHECK_FALSE(fitted_order(std::vector<StepError>{{0.1, 1}, {0.01, 0.1}}));
}

TEST_CASE("the uncertainty of a fitted order is that of the textbook's line", "[convergence]")
{
    // x = ln dt = 0, 1, 2, y = ln error = 0, 2, 1: slope 1/2, residuals -1/2, 1, -1/2, so s^2 = 1.5 / (3 - 2), S_xx
    // = 2.
    const std::vector<StepError> points{{1, 1}, {std::exp(1), std::exp(2)}, {std::exp(2), std::exp(1)}};
    const auto fit = fitted_order(points);
    REQUIRE(fit);
    CHECK(fit->order == Approx(0.5));
    CHECK(fit->uncertainty == Approx(std::sqrt(1.5 / 2)));
}

TEST_CASE("errors that no longer fall are stalled, but not those of rounding", "[convergence]")
{
    const std::vector<StepError> falling{{0.1, 1}, {0.01, 0.1}, {0.001, 0.01}};
    const std::vector<StepError> flat{{0.1, 1}, {0.01, 0.0050}, {0.001, 0.0049}, {1e-4, 0.0049}};
    const std::vector<StepError> rounding{{0.1, 3e-15}, {0.01, 4e-15}, {0.001, 5e-15}};
    CHECK_FALSE(is_stalled(falling, 1e-12));
    CHECK(is_stalled(flat, 1e-12));
    CHECK_FALSE(is_stalled(rounding, 1e-12));
    CHECK(is_stalled(rounding, 1e-16));
}

TEST_CASE("steps close together do not stall because their errors scatter", "[convergence]")
{
    // Three steps within 4 %, the smallest with the largest error; first order over a factor of 32.
    const std::vector<StepError> points{{0.032, 0.032},  {0.008, 0.009},    {0.002, 0.002},
                                        {0.00104, 8e-4}, {0.00102, 1.0e-3}, {0.001, 1.2e-3}};
    CHECK_FALSE(is_stalled(points, 1e-12));
}

TEST_CASE("tries and rows of one method have one order, and none stalls whose smaller steps are exact or enough",
          "[convergence]")
{
    carom::Scene scene;
    scene.spheres.resize(1);
    scene.spheres[0].radius = 0.1;
    carom::Comparison c;
    StepSearch flat, exact, found;
    c.rows.resize(3);
    for (carom::CompareRow& row : c.rows) row.dt = 0.1;
    c.rows[0].method = flat.method = "penalty";
    c.rows[1].method = exact.method = "bisection";
    c.rows[2].method = found.method = "naive";
    flat.end = StepSearch::End::stalls;
    exact.end = found.end = StepSearch::End::found;
    // First order down to 1e-2, then level.
    flat.tries = {
        {1e-4, 1e-2, false}, {4e-4, 1.1e-2, false}, {1.6e-3, 0.9e-2, false}, {6.4e-3, 1e-2, false}, {0.1, 0.1, false}};
    exact.tries = {{0.01, 1e-15, true}, {0.06, 1e-15, true}, {0.095, 1, false}, {0.1, 1, false}, {0.2, 1, false}};
    found.tries = {{0.001, 0.3, true}, {0.01, 0.5, false}, {0.1, 0.4, false}};
    c.searches = {flat, exact, found};
    const std::vector<carom::Convergence> fits = fit_orders(scene, c);
    REQUIRE(fits.size() == 3);
    CHECK(fits[0].stalled);
    CHECK(fits[0].steps == 5);
    CHECK_FALSE(fits[1].stalled);
    CHECK_FALSE(fits[2].stalled);
}
