#include "io/numbers.hpp"

#include "core/expect.hpp"
#include "io/limits.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace carom::io {

std::string number_text(double value)
{
    return std::isfinite(value) ? fmt::format("{}", value) : std::string();
}

std::string number_text(const std::optional<double>& value)
{
    return value ? number_text(*value) : std::string();
}

double implied_epoch_length(const Event& event)
{
    if (event.at.epoch == 0) return 1;
    // time is the sum rounded once, so this is the length within a few ulp: the power of two nearest to it is exact.
    const double length = (event.time - event.at.offset) / static_cast<double>(event.at.epoch);
    return std::ldexp(1.0, static_cast<int>(std::lround(std::log2(length))));
}

namespace {

/// All decimal digits of a finite double >= 0.
std::string exact_decimal(double value)
{
    std::string text = fmt::format("{:.{}f}", value, most_fraction_digits);
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
    return text;
}

/// Sum of two decimals without sign or exponent.
std::string add_decimals(std::string a, std::string b)
{
    for (std::string* each : {&a, &b})
        if (each->find('.') == std::string::npos) *each += '.';
    const std::size_t whole = std::max(a.find('.'), b.find('.'));
    for (std::string* each : {&a, &b}) each->insert(0, whole - each->find('.'), '0');
    const std::size_t size = std::max(a.size(), b.size());
    for (std::string* each : {&a, &b}) each->append(size - each->size(), '0');
    int carry = 0;
    for (std::size_t i = size; i-- > 0;) {
        if (a[i] == '.') continue;
        const int digit = (a[i] - '0') + (b[i] - '0') + carry;
        a[i] = static_cast<char>('0' + digit % 10);
        carry = digit / 10;
    }
    if (carry > 0) a.insert(0, 1, static_cast<char>('0' + carry));
    a.erase(a.find_last_not_of('0') + 1);
    if (a.back() == '.') a.pop_back();
    return a;
}

}  // namespace

std::string exact_time_text(const EpochTime& at, double epoch_length)
{
    CAROM_EXPECT(at.epoch >= 0 && epoch_length > 0 && at.offset >= 0);
    // The epoch in two parts, so that each is a double exactly, and stays one when scaled by a power of two.
    constexpr int low_bits = 32;
    const std::int64_t high_part = at.epoch >> low_bits;
    const double high = std::ldexp(static_cast<double>(high_part), low_bits) * epoch_length;
    const double low = static_cast<double>(at.epoch - (high_part << low_bits)) * epoch_length;
    const double base = high + low;
    const double sum = base + at.offset;
    // Fast2Sum (Dekker 1971): exact for a >= b >= 0; the errors are what the sums lost.
    const double lost_low = low - (base - high);
    const double big = std::max(base, at.offset), small = std::min(base, at.offset);
    const double lost_offset = small - (sum - big);
    if (lost_low == 0 && lost_offset == 0) return fmt::format("{}", sum);
    return add_decimals(add_decimals(exact_decimal(high), exact_decimal(low)), exact_decimal(at.offset));
}

std::string csv_field(std::string_view text)
{
    if (text.find_first_of(",\"\r\n") == std::string_view::npos) return std::string(text);
    std::string quoted = "\"";
    for (const char c : text) {
        if (c == '"') quoted += '"';
        quoted += c;
    }
    return quoted + '"';
}

}  // namespace carom::io
