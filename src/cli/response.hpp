/// \file
/// How a run answers several contacts at once, rest, and accumulating impacts: chosen by options, and in words.
#pragma once

#include "cli/arguments.hpp"

#include <carom/scene.hpp>

#include <string>

namespace carom::cli {

/// The scene with what `--impact` and `--guard` say in place of its own, or else what its `run` says.
/// \throws UsageError, InputError as Choices
Scene with_response(Scene scene, const GivenOptions& given, const std::string& file);

// In words, with every default filled in.
std::string impact_words(const Scene& scene);
std::string rest_words(const Scene& scene);
std::string guard_words(const Scene& scene);

}  // namespace carom::cli
