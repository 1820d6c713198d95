/// \file
/// Recordings in a folder of their own, gone after the test.
#pragma once

#include "support/scenes.hpp"

#include <carom/error.hpp>
#include <carom/io.hpp>

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace carom::test {

class RecordingFolder {
public:
    RecordingFolder()
        : path_(std::filesystem::temp_directory_path() / ("carom-recording-" + std::to_string(::getpid())))
    {
        std::filesystem::remove_all(path_);
        std::filesystem::create_directories(path_);
    }
    ~RecordingFolder() { std::filesystem::remove_all(path_); }
    RecordingFolder(const RecordingFolder&) = delete;
    RecordingFolder& operator=(const RecordingFolder&) = delete;
    std::filesystem::path operator/(const std::string& name) const { return path_ / name; }

private:
    std::filesystem::path path_;
};

inline Outcome record_to(const std::filesystem::path& file, const Scene& scene, const RunOptions& options = {})
{
    RecordingWriter writer(file, scene, {"event", false, scene.end_time});
    Observer observer;
    observer.on_frame = [&](const RunFrame& frame) { writer.on_frame(frame); };
    observer.on_event = [&](const Event& event) { writer.on_event(event); };
    observer.on_flight = [&](const FlightRecord& flight) { writer.on_flight(flight); };
    const Outcome outcome = simulate(scene, EventDriven{}, options, observer);
    writer.finish(outcome);
    return outcome;
}

/// Everything that a reader gives, as bytes. \throws InputError as the reader
inline std::string content_of(const std::filesystem::path& file)
{
    RecordingReader reader(file);
    std::string text = reader.scene();
    const auto put = [&](const auto& value) { text.append(reinterpret_cast<const char*>(&value), sizeof value); };
    for (const auto& [key, value] : reader.meta()) text += key + "=" + value + "\n";
    const RecordedRun& run = reader.run();
    put(run.frame.epoch_length);
    put(run.frame.cell_size);
    put(run.frame.drag);
    put(run.closing_speed);
    put(run.window);
    for (const Vec3& a : run.frame.accelerations) put(a);
    for (const RecordedSphere& s : run.spheres) {
        put(s.radius);
        put(s.mass);
        put(s.material);
        put(s.fixed);
    }
    for (const RecordedStart& s : run.starts) {
        put(s.position);
        put(s.velocity);
    }
    for (const Plane& p : run.planes) {
        put(p.normal);
        put(p.offset);
    }
    Instant instant;
    while (reader.next(instant)) {
        for (const Event& e : instant.events) {
            put(e.kind);
            put(e.at);
            put(e.a);
            put(e.b);
            put(e.normal);
            put(e.impulse);
        }
        for (const FlightRecord& f : instant.flights) {
            put(f.body);
            put(f.start);
            put(f.cell);
            put(f.local);
            put(f.local_low);
            put(f.velocity);
            put(f.velocity_low);
            put(f.acceleration);
            put(f.own);
            put(f.guarded);
            put(f.support);
            put(f.mode);
            if (f.series) put(f.series->normal_speed);
        }
    }
    for (BodyId b = 0; b < static_cast<BodyId>(run.spheres.size() + run.planes.size()); b += 17)
        text += reader.body_name(b);
    return text;
}

}  // namespace carom::test
