/// \file
/// Notes on what is no error, but silence would mislead: options without effect, energy from nowhere.
#pragma once

#include "cli/arguments.hpp"

#include <carom/method.hpp>
#include <carom/scene.hpp>
#include <carom/study.hpp>

#include <span>
#include <string>
#include <vector>

namespace carom::cli {

/// Typed options that `method` does not look at: "--dt is for stepping methods ...".
std::vector<std::string> ignored_options(const GivenOptions& given, const Method& method);

/// Materials that --set made or changed and no body has.
std::vector<std::string> unused_materials(const Scene& scene, const std::vector<std::string>& set);

/// Notes on the bodies that were lifted out of an overlap, and the energy that gave.
std::vector<std::string> lift_notes(const Scene& scene, std::span<const Lift> lifts);

}  // namespace carom::cli
