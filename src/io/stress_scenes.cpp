#include "io/stress_scenes.hpp"

#include <carom/io.hpp>

namespace carom::io {

std::vector<stress::Trial> read_stress_scenes(const std::filesystem::path& folder, const OnProgress& on_progress)
{
    std::vector<stress::Trial> trials;
    ReadOptions options;
    options.on_progress = on_progress;
    for (const std::filesystem::path& file : scene_files(folder)) {
        options.set.clear();
        Scene scene = read_scene(file, options);
        if (!scene.stress) continue;
        const std::string name = file.stem().string();
        const std::vector<StressMember> members = scene.stress->members;
        trials.push_back({name, std::move(scene)});
        for (const StressMember& member : members) {
            options.set = member.set;
            trials.push_back({name + ", " + member.name, read_scene(file, options)});
        }
    }
    return trials;
}

}  // namespace carom::io
