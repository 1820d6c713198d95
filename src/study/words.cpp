#include "study/words.hpp"

#include "study/tolerances.hpp"

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

std::string significant(double value, int digits)
{
    if (!std::isfinite(value)) return "not a finite number";
    std::array<char, 32> buffer{};
    std::snprintf(buffer.data(), buffer.size(), "%.*e", digits - 1, value);
    std::snprintf(buffer.data(), buffer.size(), "%.*g", 6, std::strtod(buffer.data(), nullptr));
    return short_exponent(buffer.data());
}

}  // namespace

std::string two_digits(double value)
{
    return significant(value, 2);
}

std::string three_digits(double value)
{
    return significant(value, 3);
}

std::string time_text(double time, const std::string& unit)
{
    return significant(time, time_digits) + (unit.empty() ? "" : " " + unit);
}

std::string step_text(double dt)
{
    std::array<char, 32> buffer{};
    std::snprintf(buffer.data(), buffer.size(), "%.*g", step_digits, dt);
    const bool rounded = std::strtod(buffer.data(), nullptr) != dt;
    // As long as a fraction must be shorter than: what the user typed, if that was a decimal.
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), dt);
    const std::string decimal = short_exponent(std::string(buffer.data(), end.ptr));
    const double steps = std::round(1 / dt);
    if (steps > 1 && steps <= largest_denominator && std::abs(1 / steps - dt) <= same_step * dt) {
        std::string fraction = "1/" + std::to_string(static_cast<long long>(steps));
        if (fraction.size() < decimal.size()) return fraction;
    }
    if (!rounded) return decimal;
    const std::string plain = significant(dt, step_digits);
    std::snprintf(buffer.data(), buffer.size(), "%.*g", step_digits, dt);
    const auto last = std::to_chars(buffer.data(), buffer.data() + buffer.size(), std::strtod(buffer.data(), nullptr),
                                    std::chars_format::scientific);
    const std::string power = short_exponent(std::string(buffer.data(), last.ptr));
    return power.size() < plain.size() ? power : plain;
}

std::string variant_text(const CompareRow& row)
{
    std::string text;
    if (row.substeps.value_or(1) > 1) text += " in " + std::to_string(*row.substeps) + " substeps";
    if (row.passes.value_or(1) > 1) text += " with " + std::to_string(*row.passes) + " passes";
    if (row.order.value_or(ContactOrder::index) != ContactOrder::index)
        text += ", order " + std::string(name(*row.order));
    if (row.integrator.value_or(Integrator::euler) != Integrator::euler)
        text += ", " + std::string(name(*row.integrator));
    return text;
}

std::string length_text(double value, const std::string& unit)
{
    if (!std::isfinite(value)) return three_digits(value);
    if (unit != "m") return three_digits(value) + (unit.empty() ? "" : " " + unit);
    const double size = std::abs(value);
    if (size < smallest_named_length || size >= metres_from) return three_digits(value) + " m";
    constexpr std::array<Prefix, 4> prefixes{
        {{1e-6, 1e-9, " nm"}, {1e-4, 1e-6, " um"}, {1e-2, 1e-3, " mm"}, {1, 1e-2, " cm"}}};
    for (const Prefix& each : prefixes)
        if (size < each.below) return three_digits(value / each.unit) + each.text;
    return three_digits(value) + " m";
}

std::string seconds_text(double seconds)
{
    constexpr std::array<Prefix, 3> prefixes{{{1e-6, 1e-9, " ns"}, {1e-3, 1e-6, " us"}, {1, 1e-3, " ms"}}};
    for (const Prefix& each : prefixes)
        if (seconds < each.below) return two_digits(seconds / each.unit) + each.text;
    return two_digits(seconds) + " s";
}

}  // namespace carom::study
