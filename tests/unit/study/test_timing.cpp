#include "study/timing.hpp"

#include <catch2/catch.hpp>

#include <numeric>

using namespace carom::study;

namespace {

std::vector<double> one_to(int n)
{
    std::vector<double> values(static_cast<std::size_t>(n));
    std::iota(values.begin(), values.end(), 1.0);
    return values;
}

}  // namespace

TEST_CASE("the median's interval has the ranks of the printed tables", "[timing]")
{
    // Conover, Practical nonparametric statistics, 3rd ed., quantile test: 95 % for the median, ranks of n values.
    struct Printed {
        int n, low, high;
    };
    for (const Printed& p : {Printed{6, 1, 6}, Printed{8, 1, 8}, Printed{9, 2, 8}, Printed{10, 2, 9},
                             Printed{15, 4, 12}, Printed{20, 6, 15}, Printed{30, 10, 21}}) {
        CAPTURE(p.n);
        const MedianTime time = median_time(one_to(p.n));
        CHECK(time.low == p.low);
        CHECK(time.high == p.high);
    }
    const MedianTime few = median_time({5, 1, 3});
    CHECK(few.median == 3);
    CHECK(few.min == 1);
    CHECK(few.max == 5);
    CHECK(few.low == 1);
    CHECK(few.high == 5);
}
