/// \file
/// JSON written straight into a text, for lists of as many entries as there are spheres: a tree of them costs ten times
/// as much. The text is that of nlohmann::ordered_json::dump(2).
#pragma once

#include <carom/types.hpp>

#include <string>
#include <string_view>

namespace carom::io {

/// The digits that dump() writes; null for what is not finite.
void append_number(std::string& text, double value);
/// With its quotes and escapes.
void append_string(std::string& text, std::string_view value);
/// A list of three numbers, each on a line of its own. \param indent of the line on which it begins [spaces]
void append_vector(std::string& text, const Vec3& value, std::size_t indent);
/// A new line and so many spaces.
void append_line(std::string& text, std::size_t indent);

}  // namespace carom::io
