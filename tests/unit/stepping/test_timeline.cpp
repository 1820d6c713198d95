#include "stepping/timeline.hpp"

#include <catch2/catch.hpp>

using carom::stepping::Substep;
using carom::stepping::Timeline;

TEST_CASE("The number of steps is until / dt rounded up, rounding errors aside", "[stepping]")
{
    CHECK(Timeline(1, 0.1, 1).steps() == 10);
    CHECK(Timeline(1, 0.3, 1).steps() == 4);
    CHECK(Timeline(2.1, 0.3, 1).steps() == 7);  // 2.1 / 0.3 = 7.000000000000001 in doubles
    CHECK(Timeline(0.01666666667, 1.0 / 240, 1).steps() == 4);
    CHECK(Timeline(1, 1.0 / 60, 1).steps() == 60);
    CHECK(Timeline(2, 1.0 / 3000, 1).steps() == 6000);
    CHECK(Timeline(1, 5, 1).steps() == 1);
    CHECK(Timeline(1e-12, 1, 1).steps() == 1);
    CHECK(Timeline(0, 1, 1).steps() == 0);
    CHECK(Timeline(1e300, 1e-300, 1).steps() > 0);
}

TEST_CASE("Substeps follow each other without gaps, start at k dt and end at until", "[stepping]")
{
    const double until = 2.05, dt = 0.1;
    const Timeline timeline(until, dt, 3);
    REQUIRE(timeline.steps() == 21);
    double end = 0;
    for (std::int64_t step = 0; step < timeline.steps(); ++step) {
        CHECK(timeline.substep(step, 0).begin == static_cast<double>(step) * dt);
        for (int k = 0; k < 3; ++k) {
            const Substep s = timeline.substep(step, k);
            CHECK(s.begin == end);
            CHECK(s.end > s.begin);
            CHECK(s.length == Approx(s.end - s.begin).epsilon(1e-10));
            end = s.end;
        }
    }
    CHECK(end == until);
    CHECK(timeline.substep(3, 1).length == dt / 3);
    CHECK(timeline.substep(20, 1).length == Approx(0.05 / 3));
}
