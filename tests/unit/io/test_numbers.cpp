#include "io/numbers.hpp"

#include <boost/multiprecision/cpp_int.hpp>
#include <catch2/catch.hpp>

#include <cmath>
#include <cstdlib>
#include <limits>
#include <random>

using namespace carom;
using namespace carom::io;

namespace {

using Rational = boost::multiprecision::cpp_rational;

/// The value of a decimal, without any floating point.
Rational read_decimal(std::string text)
{
    boost::multiprecision::cpp_int scale = 1;
    int exponent = 0;
    if (const std::size_t e = text.find('e'); e != std::string::npos) {
        exponent = std::atoi(text.c_str() + e + 1);
        text.erase(e);
    }
    if (const std::size_t point = text.find('.'); point != std::string::npos) {
        exponent -= static_cast<int>(text.size() - point - 1);
        text.erase(point, 1);
    }
    text.erase(0, std::min(text.find_first_not_of('0'), text.size() - 1));
    for (int i = 0; i < std::abs(exponent); ++i) scale *= 10;
    const boost::multiprecision::cpp_int digits(text);
    return exponent < 0 ? Rational(digits, scale) : Rational(digits * scale);
}

Rational exact(const EpochTime& at, double length)
{
    return Rational(at.epoch) * Rational(length) + Rational(at.offset);
}

}  // namespace

TEST_CASE("a moment whose sum is a double is written as briefly as that double", "[numbers]")
{
    CHECK(exact_time_text({0, 0.451523640985731}, 1) == "0.451523640985731");
    CHECK(exact_time_text({0, 0}, 1) == "0");
    CHECK(exact_time_text({3, 0.5}, 2) == "6.5");
    CHECK(exact_time_text({1, 0.25}, 0.5) == "0.75");
}

TEST_CASE("a moment between two doubles is written with all its digits", "[numbers]")
{
    // 2^40 + 2^-40: 81 bits.
    CHECK(exact_time_text({std::int64_t{1} << 40, 0x1p-40}, 1) ==
          "1099511627776.0000000000009094947017729282379150390625");
    CHECK(exact_time_text({std::int64_t{1} << 40, 0.1}, 1) ==
          "1099511627776.1000000000000000055511151231257827021181583404541015625");
    CHECK(exact_time_text({(std::int64_t{1} << 60) + 1, 0.5}, 1) == "1152921504606846977.5");
}

TEST_CASE("written moments read back exactly, whatever epoch and length", "[numbers]")
{
    std::mt19937_64 generator(11);
    for (int i = 0; i < 2000; ++i) {
        const int exponent = static_cast<int>(generator() % 60) - 40;
        const double length = std::ldexp(1.0, exponent);
        const auto shift = generator() % 63U;
        const EpochTime at{static_cast<std::int64_t>((generator() >> 1U) >> shift),
                           length * static_cast<double>(generator() >> 11U) * 0x1p-53};
        CAPTURE(at.epoch, at.offset, length);
        const Rational value = exact(at, length);
        const double nearest = value.convert_to<double>();
        const std::string text = exact_time_text(at, length);
        if (Rational(nearest) == value)
            CHECK(std::strtod(text.c_str(), nullptr) == nearest);
        else
            CHECK(read_decimal(text) == value);
    }
}

TEST_CASE("the epoch length follows from the two times of an event", "[numbers]")
{
    for (const double length : {0x1p-20, 0.25, 1.0, 8.0, 1024.0})
        for (const std::int64_t epoch : {1LL, 3LL, 1000LL, 1LL << 40U})
            for (const double part : {0.0, 0.3, 0.999999999}) {
                Event event;
                event.at = {epoch, part * length};
                event.time = static_cast<double>(epoch) * length + event.at.offset;
                CHECK(implied_epoch_length(event) == length);
            }
    CHECK(implied_epoch_length(Event{}) == 1);
}

TEST_CASE("numbers are as short as they can be and read back the same", "[numbers]")
{
    CHECK(number_text(0.1) == "0.1");
    CHECK(number_text(-3.0) == "-3");
    CHECK(number_text(std::numeric_limits<double>::infinity()).empty());
    CHECK(number_text(std::numeric_limits<double>::quiet_NaN()).empty());
    CHECK(number_text(std::optional<double>()).empty());
    std::mt19937_64 generator(5);
    for (int i = 0; i < 1000; ++i) {
        const double value =
            std::ldexp(static_cast<double>(generator() >> 11U), static_cast<int>(generator() % 200) - 150);
        CHECK(std::strtod(number_text(value).c_str(), nullptr) == value);
    }
}

TEST_CASE("fields with commas and quotes are quoted", "[numbers]")
{
    CHECK(csv_field("ball") == "ball");
    CHECK(csv_field("fill-0/17") == "fill-0/17");
    CHECK(csv_field("a,b") == "\"a,b\"");
    CHECK(csv_field("5\" ball") == "\"5\"\" ball\"");
}
