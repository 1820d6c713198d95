/// \file
/// Numbers as text for messages: locale free and the same everywhere.
#pragma once

#include <array>
#include <charconv>
#include <string>

namespace carom {

/// The shortest text that reads back as `x`.
inline std::string to_text(double x)
{
    std::array<char, 32> buffer{};
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), x).ptr;
    return {buffer.data(), end};
}

/// The text of `x` to `digits` significant digits, for sizes that people need roughly.
inline std::string to_text(double x, int digits)
{
    std::array<char, 64> buffer{};
    const auto end =
        std::to_chars(buffer.data(), buffer.data() + buffer.size(), x, std::chars_format::general, digits).ptr;
    return {buffer.data(), end};
}

inline std::string quoted(const std::string& text)
{
    return '"' + text + '"';
}

}  // namespace carom
