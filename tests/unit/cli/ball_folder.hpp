/// \file
/// A folder with a scene of a ball over a floor, for tests of commands.
#pragma once

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace carom::test {

inline constexpr const char* ball_scene =
    R"({"format": "carom-scene/1", "name": "Ball", "gravity": [0, 0, -9.81], "end_time": 1,
 "units": {"length": "m", "time": "s", "mass": "kg"},
 "materials": {"rubber": {"restitution": 0.8}},
 "spheres": [{"id": "ball", "radius": 0.1, "position": [0, 0, 1.1], "velocity": [0.2, 0, 0], "material": "rubber"}],
 "planes": [{"id": "floor", "normal": [0, 0, 1], "offset": 0, "material": "rubber"}],
 "compare": {"methods": ["event", "pbd"], "dt": ["1/60"]}})";

/// A folder for one test, gone afterwards.
class Folder {
public:
    Folder() : path_(std::filesystem::temp_directory_path() / ("carom-cli-" + std::to_string(::getpid())))
    {
        std::filesystem::remove_all(path_);
        std::filesystem::create_directories(path_);
        write("ball.json", ball_scene);
    }
    ~Folder() { std::filesystem::remove_all(path_); }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;

    std::string operator/(const std::string& name) const { return (path_ / name).string(); }
    void write(const std::string& name, const std::string& text) const { std::ofstream(path_ / name) << text; }
    std::string read(const std::string& name) const
    {
        std::ifstream stream(path_ / name);
        return {std::istreambuf_iterator<char>(stream), {}};
    }

private:
    std::filesystem::path path_;
};

}  // namespace carom::test
