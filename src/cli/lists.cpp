#include "cli/lists.hpp"

#include "cli/limits.hpp"

#include <charconv>
#include <cmath>
#include <stdexcept>

namespace carom::cli {

namespace {

std::invalid_argument error(std::string_view text, const std::string& what)
{
    return std::invalid_argument("\"" + std::string(text) + "\" " + what);
}

std::string_view trimmed(std::string_view text)
{
    const std::size_t first = text.find_first_not_of(" \t");
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

double parse_decimal(std::string_view text, std::string_view whole)
{
    std::string_view digits = trimmed(text);
    if (!digits.empty() && digits.front() == '+') digits.remove_prefix(1);  // from_chars takes no plus
    double value = 0;
    const auto end = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (digits.empty() || end.ptr != digits.data() + digits.size() || end.ec != std::errc())
        throw error(whole, "is not a number (write 0.001, 1e-3 or 1/1000)");
    return value;
}

void append_range(std::string_view text, std::vector<double>& values)
{
    const std::size_t first = text.find(':'), second = text.find(':', first + 1);
    const auto wrong = [&] { return error(text, "is not a range (write start:stop:lin5 or start:stop:log5)"); };
    if (second == std::string_view::npos || text.find(':', second + 1) != std::string_view::npos) throw wrong();
    const double start = parse_number(text.substr(0, first));
    const double stop = parse_number(text.substr(first + 1, second - first - 1));
    const std::string_view rule = trimmed(text.substr(second + 1));
    const bool logarithmic = rule.substr(0, 3) == "log";
    if (!logarithmic && rule.substr(0, 3) != "lin") throw wrong();
    const long long n = parse_integer(rule.substr(3), 2, most_range_values);
    if (logarithmic && !(start > 0 && stop > 0))
        throw error(text, "needs start and stop above 0 for a logarithmic range");
    for (long long k = 0; k < n; ++k) {
        const double part = static_cast<double>(k) / static_cast<double>(n - 1);
        if (k == 0)
            values.push_back(start);
        else if (k == n - 1)
            values.push_back(stop);  // to the last bit, whatever pow says
        else
            values.push_back(logarithmic ? start * std::pow(stop / start, part) : start + (stop - start) * part);
    }
}

}  // namespace

double parse_number(std::string_view text)
{
    const std::size_t slash = text.find('/');
    double value = 0;
    if (slash == std::string_view::npos) {
        value = parse_decimal(text, text);
    } else {
        const double numerator = parse_decimal(text.substr(0, slash), text);
        const double denominator = parse_decimal(text.substr(slash + 1), text);
        if (denominator == 0) throw error(text, "divides by 0");
        value = numerator / denominator;
    }
    if (!std::isfinite(value)) throw error(text, "is not a finite number");
    return value;
}

long long parse_integer(std::string_view text, long long low, long long high)
{
    const double value = parse_number(text);
    if (value != std::floor(value)) throw error(text, "is not a whole number");
    if (value < static_cast<double>(low) || value > static_cast<double>(high))
        throw error(text, "is not within " + std::to_string(low) + " and " + std::to_string(high));
    return static_cast<long long>(value);
}

std::vector<std::string> parse_words(std::string_view text)
{
    std::vector<std::string> words;
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find(',', begin), text.size());
        const std::string_view word = trimmed(text.substr(begin, end - begin));
        if (word.empty()) throw error(text, "has an empty item");
        words.emplace_back(word);
        begin = end + 1;
    }
    return words;
}

std::vector<double> parse_list(std::string_view text)
{
    std::vector<double> values;
    for (const std::string& word : parse_words(text)) {
        if (word.find(':') == std::string::npos)
            values.push_back(parse_number(word));
        else
            append_range(word, values);
    }
    return values;
}

}  // namespace carom::cli
