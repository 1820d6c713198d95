#include <algorithm>
#include <charconv>
#include <cmath>

#include "core/text.hpp"
#include "io/limits.hpp"
#include "io/object_view.hpp"

namespace carom::io {

namespace {

std::string range_in_words(const Range& range)
{
    const bool above = range.min > any_number.min;
    const bool below = range.max < any_number.max;
    if (above && below && !range.min_excluded)
        return "must be between " + to_text(range.min) + " and " + to_text(range.max);
    const std::string low = above ? (range.min_excluded ? "> " : ">= ") + to_text(range.min) : "";
    const std::string high = below ? "<= " + to_text(range.max) : "";
    return "must be " + low + (above && below ? " and " : "") + high;
}

std::string type_problem(const std::string& expected, const Json& found)
{
    return "must be " + expected + ", is " + describe(found);
}

std::string choices(const std::vector<std::string>& words)
{
    std::string text;
    for (const auto& word : words) text += (text.empty() ? " (take " : ", ") + word;
    return text + ")";
}

}  // namespace

std::optional<double> as_number(const Place& place, const Range& range, Problems& problems)
{
    if (place.value->kind != Json::Kind::number) {
        problems.add(place.pointer, type_problem("a number", *place.value));
        return {};
    }
    const double x = place.value->number;
    if (x < range.min || x > range.max || (range.min_excluded && x == range.min)) {
        problems.add(place.pointer, range_in_words(range) + ", is " + place.value->text);
        return {};
    }
    return x;
}

std::optional<std::uint64_t> as_integer(const Place& place, std::uint64_t min, std::uint64_t max, Problems& problems)
{
    const Json& json = *place.value;
    std::uint64_t n = 0;
    bool whole = json.kind == Json::Kind::number;
    if (whole) {
        const char* end = json.text.data() + json.text.size();
        const auto result = std::from_chars(json.text.data(), end, n);
        if (result.ec != std::errc{} || result.ptr != end) {  // such as 1e3 or 5.0
            whole = json.number >= 0 && json.number <= largest_exact && json.number == std::floor(json.number);
            n = whole ? static_cast<std::uint64_t>(json.number) : 0;
        }
    }
    if (whole && n >= min && n <= max) return n;
    problems.add(place.pointer,
                 type_problem("an integer from " + std::to_string(min) + " to " + std::to_string(max), json));
    return {};
}

std::optional<std::string> as_string(const Place& place, Problems& problems)
{
    if (place.value->kind == Json::Kind::string) return place.value->text;
    problems.add(place.pointer, type_problem("a string", *place.value));
    return {};
}

std::optional<bool> as_boolean(const Place& place, Problems& problems)
{
    if (place.value->kind == Json::Kind::boolean) return place.value->boolean;
    problems.add(place.pointer, type_problem("true or false", *place.value));
    return {};
}

std::optional<Vec3> as_vector(const Place& place, Problems& problems)
{
    const Json& json = *place.value;
    constexpr std::size_t dimensions = 3;
    if (json.kind != Json::Kind::array || json.items.size() != dimensions) {
        problems.add(place.pointer, type_problem("a list of 3 numbers", json));
        return {};
    }
    Vec3 v = Vec3::Zero();
    bool good = true;
    for (std::size_t i = 0; i < dimensions; ++i) {
        const auto x = as_number({&json.items[i], join(place.pointer, i)}, any_number, problems);
        good = good && x;
        v[static_cast<Eigen::Index>(i)] = x.value_or(0);
    }
    if (!good) return {};
    return v;
}

std::vector<Place> as_list(const Place& place, Problems& problems)
{
    std::vector<Place> places;
    if (place.value->kind != Json::Kind::array) {
        problems.add(place.pointer, type_problem("a list", *place.value));
        return places;
    }
    for (std::size_t i = 0; i < place.value->items.size(); ++i)
        places.push_back({&place.value->items[i], join(place.pointer, i)});
    return places;
}

std::optional<std::string> as_word(const Place& place, const std::vector<std::string>& words,
                                   const std::vector<std::string>& later, Problems& problems)
{
    const auto text = as_string(place, problems);
    if (!text || std::find(words.begin(), words.end(), *text) != words.end()) return text;
    const bool planned = std::find(later.begin(), later.end(), *text) != later.end();
    problems.add(place.pointer, quoted(*text) + (planned ? ": not yet supported" + choices(words)
                                                         : ": unknown" + suggestion(*text, words, "take")));
    return {};
}

}  // namespace carom::io
