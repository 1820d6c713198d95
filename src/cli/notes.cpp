#include "cli/notes.hpp"

#include "cli/limits.hpp"
#include "io/problems.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace carom::cli {

std::vector<std::string> ignored_options(const GivenOptions& given, const Method& method)
{
    const bool steps = step_options(method) != nullptr;
    std::vector<std::string> notes;
    for (const char* option : {"dt", "substeps", "passes", "order", "integrator"})
        if (!steps && given.contains(option))
            notes.push_back(std::string("--") + option + " has no effect: " + std::string(name(method)) +
                            " takes no steps (name a stepping method: --method pbd)");
    if (given.contains("literal") && name(method) != "pbd")
        notes.push_back("--literal has no effect: it is for --method pbd");
    if (given.contains("most_impacts") && name(method) != "toi")
        notes.push_back("--most-impacts has no effect: it is for --method toi");
    if (given.contains("kernel") && steps)
        notes.push_back("--kernel has no effect: it is for the event method, not for " + std::string(name(method)));
    if (given.contains("certified") && steps)
        notes.push_back("--certified has no effect: it is for the event method, not for " + std::string(name(method)));
    const auto of_one = [&](const char* option, const char* key, std::string_view method_name) {
        if (given.contains(key) && name(method) != method_name)
            notes.push_back(fmt::format("--{} has no effect: it is for --method {}", option, method_name));
    };
    of_one("stiffness", "stiffness", Penalty::method_name);
    of_one("hertz", "hertz", Soft::method_name);
    of_one("damping-ratio", "damping_ratio", Soft::method_name);
    return notes;
}

std::vector<std::string> unused_materials(const Scene& scene, const std::vector<std::string>& set)
{
    std::set<std::size_t> used;
    for (const Sphere& sphere : scene.spheres) used.insert(static_cast<std::size_t>(sphere.material));
    for (const Plane& plane : scene.planes) used.insert(static_cast<std::size_t>(plane.material));
    std::vector<std::string> names;
    for (const std::size_t material : used) names.push_back(scene.materials[material].name);
    std::vector<std::string> notes;
    for (const std::string& assignment : set) {
        constexpr std::string_view section = "/materials/";
        if (!assignment.starts_with(section)) continue;
        const std::string material =
            assignment.substr(section.size(), assignment.find_first_of("/=", section.size()) - section.size());
        const bool known = std::any_of(scene.materials.begin(), scene.materials.end(),
                                       [&](const Material& each) { return each.name == material; });
        if (known && std::find(names.begin(), names.end(), material) == names.end())
            notes.push_back("--set " + assignment + " has no effect: no body is of the material \"" + material + "\"" +
                            io::suggestion(material, names, "in use"));
    }
    return notes;
}

std::vector<std::string> lift_notes(const Scene& scene, std::span<const Lift> lifts)
{
    std::vector<std::string> notes;
    double others = 0;
    for (const Lift& lift : lifts) {
        if (notes.size() == most_listed_bodies) {
            others += lift.energy;
            continue;
        }
        notes.push_back(fmt::format(
            "\"{}\" began inside plane \"{}\" and was lifted out of it by {:.6g} when it came to rest on it: "
            "that gave it an energy of {:.6g} (move it out of the plane, and nothing is given)",
            scene.body_name(lift.sphere), scene.body_name(lift.plane), lift.depth, lift.energy));
    }
    if (lifts.size() > most_listed_bodies)
        notes.push_back(fmt::format("so were {} more, which gave {:.6g}", lifts.size() - most_listed_bodies, others));
    return notes;
}

}  // namespace carom::cli
