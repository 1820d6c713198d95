#include "study/sample_times.hpp"

#include <catch2/catch.hpp>

#include <vector>

using namespace carom::study;

TEST_CASE("a sample on an impact is taken just before and just after it, and no other is", "[compare]")
{
    // Intervals of 0.5: within 5e-10 of an impact.
    const std::vector<double> impacts{0.5, 1.0 + 4e-10, 1.5 + 6e-10};
    const SampleTimes times = sample_times(2, 4, impacts);
    CHECK(times.grid == std::vector<double>{0, 0.5, 1, 1.5, 2});
    CHECK(times.sample == std::vector<std::size_t>{0, 1, 1, 2, 2, 3, 4});
    REQUIRE(times.asked.size() == 7);
    CHECK(times.asked[1] < 0.5);
    CHECK(times.asked[2] > 0.5);
    CHECK(times.asked[2] - times.asked[1] < 3e-9);
    CHECK(times.asked[4] > impacts[1]);
    CHECK(times.asked[5] == 1.5);
    CHECK(times.goes_on(1));
    CHECK_FALSE(times.goes_on(2));
}

TEST_CASE("at the ends of a run a sample on an impact is taken on the side that is there", "[compare]")
{
    const std::vector<double> impacts{0, 2};
    const SampleTimes times = sample_times(2, 1, impacts);
    CHECK(times.sample == std::vector<std::size_t>{0, 1});
    CHECK(times.asked.front() > 0);
    CHECK(times.asked.back() < 2);
}
