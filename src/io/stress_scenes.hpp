/// \file
/// Stress scenes of a folder, with their variations.
#pragma once

#include "study/stress.hpp"

#include <carom/progress.hpp>

#include <filesystem>
#include <vector>

namespace carom::io {

/// Each scene under `folder` that has a StressPart, by path, followed by its variations. \param on_progress may be
/// empty \throws InputError for a scene or a variation that cannot be read; Stopped by `on_progress`
std::vector<stress::Trial> read_stress_scenes(const std::filesystem::path& folder, const OnProgress& on_progress = {});

}  // namespace carom::io
