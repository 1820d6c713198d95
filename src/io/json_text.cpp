#include "io/json_text.hpp"

#include "io/limits.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace carom::io {

namespace {

bool is_plain(char c)
{
    constexpr char first_printable = 0x20, del = 0x7f;
    return c >= first_printable && c < del && c != '"' && c != '\\';
}

}  // namespace

void append_number(std::string& text, double value)
{
    if (!std::isfinite(value)) {
        text += "null";
        return;
    }
    std::array<char, 64> digits{};
    // Function that dump() calls. (std::to_chars writes other digits of the same number: 1 for 1.0, 1e-04 for 0.0001.)
    char* end = nlohmann::detail::to_chars(digits.data(), digits.data() + digits.size(), value);
    text.append(digits.data(), end);
}

void append_string(std::string& text, std::string_view value)
{
    if (std::all_of(value.begin(), value.end(), is_plain)) {
        text.append(1, '"').append(value).append(1, '"');
        return;
    }
    text += nlohmann::json(value).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

void append_vector(std::string& text, const Vec3& value, std::size_t indent)
{
    text += '[';
    for (int axis = 0; axis < 3; ++axis) {
        if (axis > 0) text += ',';
        append_line(text, indent + json_indent);
        append_number(text, value[axis]);
    }
    append_line(text, indent);
    text += ']';
}

void append_line(std::string& text, std::size_t indent)
{
    text.append(1, '\n').append(indent, ' ');
}

}  // namespace carom::io
