/// \file
/// What the user typed that has no effect. It is no error, but silence would mislead.
#pragma once

#include "cli/arguments.hpp"

#include <carom/method.hpp>
#include <carom/scene.hpp>

#include <string>
#include <vector>

namespace carom::cli {

/// Typed options that `method` does not look at: "--dt is for stepping methods ...".
std::vector<std::string> ignored_options(const GivenOptions& given, const Method& method);

/// Materials that --set made or changed and no body has.
std::vector<std::string> unused_materials(const Scene& scene, const std::vector<std::string>& set);

}  // namespace carom::cli
