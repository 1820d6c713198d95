/// \file
/// Scenes from files, and recordings of runs.
#pragma once

#include <carom/error.hpp>
#include <carom/progress.hpp>
#include <carom/scene.hpp>
#include <carom/simulate.hpp>
#include <carom/verify.hpp>

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace carom {

struct ReadOptions {
    bool allow_overlap = false;         ///< let spheres overlap each other and planes at the start
    std::optional<std::uint64_t> seed;  ///< in place of the scene's
    /// "/pointer=value", applied in this order to the document before it is read: a JSON value, or else a bare string.
    std::vector<std::string> set{};
    OnProgress on_progress{};  ///< false stops the reading: Stopped is thrown
};

/// The scene of a file (format carom-scene/1), expanded and validated. Numbers are those of the file, units are the
/// scene's.
/// \throws InputError with every problem found: "FILE: JSON-POINTER: what is wrong (the cure)"; syntax: "FILE:LINE:COL:
/// ..."; likewise if the file cannot be read; Stopped by `on_progress`. \post the scene is valid (`validate`).
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

/// The file of a scene: `what` as a path if such a file exists, otherwise the catalogue scene of that name under
/// `root`.
/// \throws InputError with the nearest catalogue names, or if `what` is a folder.
std::filesystem::path find_scene(const std::string& what, const std::filesystem::path& root);

/// Name of a recording within the folder of a run.
inline constexpr const char* recording_name = "run.carom";

struct RecordingOptions {
    std::string method = "event";
    bool certified = false;  ///< the run claims double-double flights
    double until = 0;        ///< end asked for [time]
};

/// Writes a recording (docs/recording.md) while a run goes: hand its functions to an Observer. Memory does not grow
/// with the run. The file is whole up to the last chunk, also if the process is killed; chunks are written at least
/// every second while there is something to write.
class RecordingWriter {
public:
    /// Makes the file, in place of one that is there, and its folder. `scene` must outlive the writer.
    /// \throws InputError if it cannot be written; so do all functions below
    RecordingWriter(const std::filesystem::path& file, const Scene& scene, const RecordingOptions& options = {});
    ~RecordingWriter();
    RecordingWriter(const RecordingWriter&) = delete;
    RecordingWriter& operator=(const RecordingWriter&) = delete;

    void on_frame(const RunFrame& frame);
    void on_event(const Event& event);
    void on_flight(const FlightRecord& flight);
    /// Writes the last rows and the end of the run. A recording without this counts as cut off.
    void finish(const Outcome& outcome);

private:
    class Implementation;
    std::unique_ptr<Implementation> implementation_;
};

/// A recording, read chunk by chunk; checksums are compared on the way.
class RecordingReader final : public FlightSource {
public:
    /// \throws InputError if the file cannot be read, is no recording, or is damaged
    explicit RecordingReader(const std::filesystem::path& file);
    ~RecordingReader() override;
    RecordingReader(const RecordingReader&) = delete;
    RecordingReader& operator=(const RecordingReader&) = delete;

    const RecordedRun& run() const override;
    bool next(Instant& instant) override;
    void forget_starts() override;

    /// Words about the run: format, scene, method, number, until; from a finished one also status, message, time, ...
    const std::map<std::string, std::string>& meta() const;
    /// The scene without its spheres, format carom-scene/1.
    const std::string& scene() const;
    /// Id of a sphere or plane as events number them. \throws InputError
    std::string body_name(BodyId body) const;

private:
    class Implementation;
    std::unique_ptr<Implementation> implementation_;
};

/// The file of a recording: `what` if it is a file, else the one in that folder. \throws InputError if there is none
std::filesystem::path find_recording(const std::filesystem::path& what);

}  // namespace carom
