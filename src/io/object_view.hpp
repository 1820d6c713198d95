/// \file
/// Typed reading of JSON that knows where it is: every value that is missing, of the wrong type, out of range or
/// unknown becomes one problem with its pointer and its cure; reading goes on.
#pragma once

#include <carom/types.hpp>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/json.hpp"
#include "io/problems.hpp"

namespace carom::io {

/// Which numbers a key may have.
struct Range {
    double min = -std::numeric_limits<double>::max();
    double max = std::numeric_limits<double>::max();
    bool min_excluded = false;
};
inline constexpr Range any_number{};
inline constexpr Range positive{0, std::numeric_limits<double>::max(), true};
inline constexpr Range not_negative{0, std::numeric_limits<double>::max(), false};
inline constexpr Range fraction{0, 1, false};

/// A value and where it stands.
struct Place {
    const Json* value;
    std::string pointer;
};

/// One value read as a type; empty, with a problem added, if it is none.
std::optional<double> as_number(const Place& place, const Range& range, Problems& problems);
std::optional<std::uint64_t> as_integer(const Place& place, std::uint64_t min, std::uint64_t max, Problems& problems);
std::optional<std::string> as_string(const Place& place, Problems& problems);
std::optional<bool> as_boolean(const Place& place, Problems& problems);
std::optional<Vec3> as_vector(const Place& place, Problems& problems);
std::vector<Place> as_list(const Place& place, Problems& problems);
/// One of `words`; those `later` belong to the format but are not supported yet.
std::optional<std::string> as_word(const Place& place, const std::vector<std::string>& words,
                                   const std::vector<std::string>& later, Problems& problems);

/// One object of the file. Ask for each key that it may have, then `finish`: what nobody asked for is an unknown key.
class ObjectView {
public:
    ObjectView(const Place& place, Problems& problems);

    const std::string& pointer() const { return place_.pointer; }
    std::string pointer(std::string_view key) const { return join(place_.pointer, key); }
    Problems& problems() { return problems_; }
    bool is_object() const { return place_.value->kind == Json::Kind::object; }

    /// The value of a key, if it is there; the key is known from here on.
    std::optional<Place> find(std::string_view key);
    bool has(std::string_view key) { return find(key).has_value(); }

    /// Each that is missing becomes a problem.
    void require(std::initializer_list<std::string_view> keys);
    /// A problem if more than one is there, and with `need_one` if none is.
    void one_of(std::initializer_list<std::string_view> keys, bool need_one);

    /// Empty if the key is missing, or wrong (then with a problem).
    std::optional<double> number(std::string_view key, const Range& range = any_number);
    std::optional<std::uint64_t> integer(std::string_view key, std::uint64_t min, std::uint64_t max);
    std::optional<std::string> string(std::string_view key);
    std::optional<bool> boolean(std::string_view key);
    std::optional<Vec3> vector(std::string_view key);
    /// One of `words`; those `later` belong to the format but are not supported yet.
    std::optional<std::string> word(std::string_view key, const std::vector<std::string>& words,
                                    const std::vector<std::string>& later = {});
    std::vector<Place> list(std::string_view key);

    void problem(std::string_view key, const std::string& what) { problems_.add(pointer(key), what); }
    /// The key belongs to the format, but only `harmless` values of it are supported yet.
    void not_yet(std::string_view key, bool (*harmless)(const Json&));

    /// Keys that people try here: each that is there is an unknown key, with this cure.
    void never(std::initializer_list<std::string_view> keys, const std::string& cure);

    void finish();

private:
    Place place_;
    Problems& problems_;
    std::vector<std::string> asked_;
    std::vector<bool> consumed_;  ///< for each key of the object
};

}  // namespace carom::io
