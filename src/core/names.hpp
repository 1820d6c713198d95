/// \file
/// Enumerations whose names are an array beside them, names[k] being that of the value `first` + k.
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace carom {

/// The name of `value`. \pre it has one
template <class Enum, std::size_t N>
constexpr std::string_view name_of(Enum value, const std::array<std::string_view, N>& names, std::size_t first = 0)
{
    return names[static_cast<std::size_t>(value) - first];
}

/// The value that is called `word`, if one is.
template <class Enum, std::size_t N>
std::optional<Enum> value_named(std::string_view word, const std::array<std::string_view, N>& names,
                                std::size_t first = 0)
{
    const auto found = std::find(names.begin(), names.end(), word);
    if (found == names.end()) return {};
    return static_cast<Enum>(static_cast<std::size_t>(found - names.begin()) + first);
}

template <std::size_t N>
std::vector<std::string> words_of(const std::array<std::string_view, N>& names)
{
    return {names.begin(), names.end()};
}

}  // namespace carom
