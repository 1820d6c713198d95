#include "audit/rounding.hpp"

#include <catch2/catch.hpp>

using carom::Vec3;
using carom::audit::Rounding;
using carom::audit::TraceRounding;

TEST_CASE("numbers with so many decimals are known to half a unit of the last one, small ones too")
{
    Rounding rounding;
    for (const char* text : {"12.345678", "0.000012", "-3.100000"}) rounding.see(text);
    CHECK(rounding.of(12.345678) == Approx(5e-7));
    CHECK(rounding.of(0.000012) == Approx(5e-7));
    CHECK(rounding.of(0) == Approx(5e-7));
}

TEST_CASE("numbers with so many significant digits are known to half a unit of the last one, whatever their size")
{
    Rounding rounding;
    for (const char* text : {"12.3456", "0.0123456", "1.23456e-17", "1234.56"}) rounding.see(text);
    CHECK(rounding.digits() == 6);
    CHECK(rounding.of(1234.56) == Approx(5e-3));
    CHECK(rounding.of(0.0123456) == Approx(5e-8));
}

TEST_CASE("zeros that are not printed do not make a number less known than others of its column")
{
    Rounding rounding;
    rounding.see("0.5");
    CHECK(rounding.of(0.5) == Approx(0.05));
    rounding.see("0.4999999999999999");
    CHECK(rounding.of(0.5) == Approx(5e-17));
}

TEST_CASE("exponents move the point")
{
    Rounding rounding;
    rounding.see("1.25E+02");
    CHECK(rounding.decimals() == 0);
    CHECK(rounding.digits() == 3);
    rounding.see("-2.5e-3");
    CHECK(rounding.decimals() == 4);
}

TEST_CASE("nine digits may be those of single precision, whose steps round more than digits say")
{
    TraceRounding single, full;
    single.places.see("1.23456789");
    full.places.see("1.2345678901234567");
    CHECK(single.place_error({1, 0, 0}, 0.5) > 1e-6);
    CHECK(full.place_error({1, 0, 0}, 0.5) < 1e-13);
}
