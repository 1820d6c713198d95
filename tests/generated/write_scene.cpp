#include "generated/write_scene.hpp"

#include "io/scene_json.hpp"

#include <nlohmann/json.hpp>

#include <fstream>

namespace carom::test {

std::string scene_text(const Scene& scene)
{
    using Json = nlohmann::ordered_json;
    Json json = Json::parse(io::scene_json_without_spheres(scene));
    Json spheres = Json::array();
    for (const Sphere& s : scene.spheres)
        spheres.push_back({{"id", s.id},
                           {"radius", s.radius},
                           {"mass", s.mass},
                           {"position", {s.position.x(), s.position.y(), s.position.z()}},
                           {"velocity", {s.velocity.x(), s.velocity.y(), s.velocity.z()}},
                           {"fixed", s.fixed},
                           {"material", scene.materials[static_cast<std::size_t>(s.material)].name}});
    json["spheres"] = spheres;
    return json.dump(1) + "\n";
}

void write_scene(const Scene& scene, const std::filesystem::path& file)
{
    if (file.has_parent_path()) std::filesystem::create_directories(file.parent_path());
    std::ofstream(file) << scene_text(scene);
}

}  // namespace carom::test
