/// \file
/// JSON text as a tree that remembers what the file wrote: the order of keys, the digits of numbers. Nobody above this
/// file sees the parser.
#pragma once

#include "core/patience.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace carom::io {

struct Json {
    enum class Kind { null, boolean, number, string, array, object };

    Kind kind = Kind::null;
    bool boolean = false;
    double number = 0;
    std::string text;               ///< of a string; of a number: its digits as written
    std::vector<Json> items;        ///< of an array or object
    std::vector<std::string> keys;  ///< of an object: one for each item, unique

    const Json* find(std::string_view key) const;
};

/// `parent` + "/" + key, with ~ and / escaped (RFC 6901).
std::string join(const std::string& parent, std::string_view key);
std::string join(const std::string& parent, std::size_t index);

/// Kind of a value, for messages: `the string "abc"`, `the number 3`, `a list of 2`, ...
std::string describe(const Json& value);

/// \param file for messages only.
/// \throws InputError with "FILE:LINE:COL: ..." for a syntax error or a number too large for a double, and "FILE:
/// POINTER: ..." for every duplicate key.
/// Stopped if the patience ends.
Json parse_json(std::string_view text, const std::string& file, Patience& patience);
Json parse_json(std::string_view text, const std::string& file);

}  // namespace carom::io
