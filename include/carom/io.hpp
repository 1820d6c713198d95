/// \file
/// Scenes from files.
#pragma once

#include <carom/error.hpp>
#include <carom/scene.hpp>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace carom {

struct ReadOptions {
    bool allow_overlap = false;         ///< let spheres overlap each other and planes at the start
    std::optional<std::uint64_t> seed;  ///< in place of the scene's
    /// "/pointer=value", applied in this order to the document before it is read: a JSON value, or else a bare string.
    std::vector<std::string> set;
};

/// Read, expand and validate a scene file (format carom-scene/1). Numbers are those of the file, units are the scene's.
/// \throws InputError with every problem found: "FILE: JSON-POINTER: what is wrong (the cure)"; syntax: "FILE:LINE:COL:
/// ..."; likewise if the file cannot be read. \post the scene is valid (`validate`).
Scene read_scene(const std::filesystem::path& file, const ReadOptions& options = {});

/// The same for text in memory, UTF-8; `file` is used in messages only.
Scene parse_scene(std::string_view text, const std::string& file, const ReadOptions& options = {});

/// Every scene file under `root` (recursively, *.json but not the schema), readable or not, sorted by path.
std::vector<std::filesystem::path> scene_files(const std::filesystem::path& root);

struct CatalogueEntry {
    std::string name;  ///< what users type: the file's stem
    std::filesystem::path path;
    std::string title, description;
};

/// Scenes under `root` (recursively, *.json but not the schema), sorted by name. Unreadable files are left out; no
/// folder, no entries. Nothing is thrown.
std::vector<CatalogueEntry> list_scenes(const std::filesystem::path& root);

/// `what` as a path if such a file exists, otherwise the catalogue scene of that name under `root`.
/// \throws InputError with the nearest catalogue names, or if `what` is a folder.
std::filesystem::path find_scene(const std::string& what, const std::filesystem::path& root);

}  // namespace carom
