/// \file
/// Words of a file that stand for the values of an enumeration: the names are those of its public header.
#pragma once

#include "core/names.hpp"
#include "io/object_view.hpp"

namespace carom::io {

/// The value of `Enum` whose name stands there; empty, with a problem added, if none has it.
template <class Enum, std::size_t N>
std::optional<Enum> as_named(const Place& place, const std::array<std::string_view, N>& names, Problems& problems,
                             std::size_t first = 0)
{
    const auto word = as_word(place, words_of(names), {}, problems);
    return word ? value_named<Enum>(*word, names, first) : std::nullopt;
}

/// The same of a key, empty if the key is missing.
template <class Enum, std::size_t N>
std::optional<Enum> read_named(ObjectView& view, std::string_view key, const std::array<std::string_view, N>& names,
                               std::size_t first = 0)
{
    const auto place = view.find(key);
    return place ? as_named<Enum>(*place, names, view.problems(), first) : std::nullopt;
}

}  // namespace carom::io
