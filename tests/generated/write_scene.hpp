/// \file
/// A scene built in code as a file.
#pragma once

#include <carom/scene.hpp>

#include <filesystem>
#include <string>

namespace carom::test {

/// The same scene when it is read again, normals to rounding, everything else bit for bit. \pre no checks, no defaults
/// of commands
std::string scene_text(const Scene& scene);
void write_scene(const Scene& scene, const std::filesystem::path& file);

}  // namespace carom::test
