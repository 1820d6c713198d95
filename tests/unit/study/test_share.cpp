#include "study/share.hpp"

#include <catch2/catch.hpp>

using namespace carom::study;

TEST_CASE("Wilson's interval has the ends that Newcombe printed", "[share]")
{
    // Newcombe, Two-sided confidence intervals for the single proportion, Statistics in Medicine 17, 1998, table I.
    struct Printed {
        int part, whole;
        double low, high;
    };
    for (const Printed& p : {Printed{81, 263, 0.2553, 0.3662}, Printed{15, 148, 0.0624, 0.1605},
                             Printed{0, 20, 0, 0.1611}, Printed{1, 29, 0.0061, 0.1718}}) {
        CAPTURE(p.part, p.whole);
        const Share share = wilson_share(p.part, p.whole);
        CHECK(share.value == Approx(static_cast<double>(p.part) / p.whole));
        CHECK(share.low == Approx(p.low).margin(5e-5));
        CHECK(share.high == Approx(p.high).margin(5e-5));
    }
    CHECK(wilson_share(20, 20).high == 1);
    CHECK(wilson_share(0, 20).low == 0);
}
