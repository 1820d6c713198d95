#include "study/words.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace carom::study {

namespace {

/// "1e-05" as "1e-5".
std::string short_exponent(std::string text)
{
    const std::size_t e = text.find('e');
    if (e == std::string::npos) return text;
    std::size_t digit = e + 1;
    if (digit < text.size() && text[digit] == '+') text.erase(digit, 1);
    if (digit < text.size() && text[digit] == '-') ++digit;
    while (digit + 1 < text.size() && text[digit] == '0') text.erase(digit, 1);
    return text;
}

struct Prefix {
    double below, unit;
    const char* text;
};

}  // namespace

std::string two_digits(double value)
{
    if (!std::isfinite(value)) return "not a finite number";
    std::array<char, 32> buffer{};
    std::snprintf(buffer.data(), buffer.size(), "%.1e", value);
    std::snprintf(buffer.data(), buffer.size(), "%g", std::strtod(buffer.data(), nullptr));
    return short_exponent(buffer.data());
}

std::string step_text(double dt)
{
    std::array<char, 32> buffer{};
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), dt);
    std::string decimal = short_exponent(std::string(buffer.data(), end.ptr));
    const double steps = std::round(1 / dt);
    constexpr double most = 1e9;
    if (!(steps > 1 && steps <= most) || 1 / steps != dt) return decimal;
    std::string fraction = "1/" + std::to_string(static_cast<long long>(steps));
    return fraction.size() < decimal.size() ? fraction : decimal;
}

std::string length_text(double value, const std::string& unit)
{
    if (!std::isfinite(value)) return two_digits(value);
    if (unit != "m") return two_digits(value) + (unit.empty() ? "" : " " + unit);
    constexpr double smallest_named = 1e-9, in_words_below = 1;
    const double size = std::abs(value);
    if (size < smallest_named || size >= in_words_below) return two_digits(value) + " m";
    constexpr std::array<Prefix, 4> prefixes{
        {{1e-6, 1e-9, " nm"}, {1e-4, 1e-6, " um"}, {1e-2, 1e-3, " mm"}, {1, 1e-2, " cm"}}};
    for (const Prefix& each : prefixes)
        if (size < each.below) return two_digits(value / each.unit) + each.text;
    return two_digits(value) + " m";
}

std::string seconds_text(double seconds)
{
    constexpr std::array<Prefix, 3> prefixes{{{1e-6, 1e-9, " ns"}, {1e-3, 1e-6, " us"}, {1, 1e-3, " ms"}}};
    for (const Prefix& each : prefixes)
        if (seconds < each.below) return two_digits(seconds / each.unit) + each.text;
    return two_digits(seconds) + " s";
}

}  // namespace carom::study
