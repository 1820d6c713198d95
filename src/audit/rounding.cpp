#include "audit/rounding.hpp"

#include "audit/tolerances.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace carom::audit {

namespace {

bool is_digit(char c)
{
    return c >= '0' && c <= '9';
}

}  // namespace

void Rounding::see(std::string_view number)
{
    int digits = 0, decimals = 0;
    bool after_point = false;
    std::size_t at = 0;
    for (; at < number.size() && number[at] != 'e' && number[at] != 'E'; ++at) {
        if (number[at] == '.') after_point = true;
        if (!is_digit(number[at])) continue;
        if (digits > 0 || number[at] != '0') ++digits;
        if (after_point) ++decimals;
    }
    if (at < number.size()) {
        const bool plus = at + 1 < number.size() && number[at + 1] == '+';
        int exponent = 0;
        std::from_chars(number.data() + at + (plus ? 2 : 1), number.data() + number.size(), exponent);
        decimals -= exponent;
    }
    digits_ = std::max(digits_, digits);
    decimals_ = std::max(decimals_, decimals);
}

double Rounding::of(double value) const
{
    const double last = std::pow(10.0, -decimals_);
    if (value == 0) return last / 2;
    const double significant = std::pow(10.0, std::floor(std::log10(std::abs(value))) + 1 - digits_);
    return std::max(last, significant) / 2;
}

double TraceRounding::place_error(const Vec3& place, double radius) const
{
    const double largest = place.lpNorm<Eigen::Infinity>();
    const double unit = places.digits() <= digits_of_single ? single_rounding : double_rounding;
    return std::sqrt(3.0) * (places.of(largest) + engine_roundings * unit * (largest + radius));
}

}  // namespace carom::audit
