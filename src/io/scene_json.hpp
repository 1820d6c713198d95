/// \file
/// A scene as JSON, as it was resolved: fills and boxes expanded, every default written out.
#pragma once

#include <carom/scene.hpp>

#include <string>

namespace carom::io {

/// Format carom-scene/1, but for the spheres: recordings keep those in columns. What only says how to run or check a
/// scene is left out. Numbers read back as the same doubles.
std::string scene_json_without_spheres(const Scene& scene);

/// The same with its spheres, on one line. What is parsed from it has the same bodies, bit for bit.
std::string scene_json(const Scene& scene);

/// A list of strings as JSON, and back. \throws InputError "FILE: damaged ..." if the text is no such list
std::string strings_json(const std::vector<std::string>& strings);
std::vector<std::string> strings_of_json(const std::string& text, const std::string& file);

}  // namespace carom::io
