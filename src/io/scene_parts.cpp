#include <algorithm>
#include <cmath>

#include "core/text.hpp"
#include "io/limits.hpp"
#include "io/scene_draft.hpp"

namespace carom::io {

std::optional<int> as_material(const Place& place, const Scene& scene, Problems& problems)
{
    const auto name = as_string(place, problems);
    if (!name) return {};
    for (std::size_t m = 0; m < scene.materials.size(); ++m)
        if (scene.materials[m].name == *name) return static_cast<int>(m);
    std::vector<std::string> known;
    for (const Material& material : scene.materials) known.push_back(material.name);
    problems.add(place.pointer, "unknown material " + quoted(*name) + suggestion(*name, known, "known"));
    return {};
}

int read_material(ObjectView& view, const SceneDraft& draft)
{
    const auto place = view.find("material");
    return place ? as_material(*place, draft.scene, view.problems()).value_or(0) : 0;
}

std::string read_id(ObjectView& view, const std::string& fallback)
{
    const auto id = view.string("id");
    if (!id) return fallback;
    const auto unfit = [](char c) {
        constexpr unsigned char first_printable = 0x20, del = 0x7f;
        const auto u = static_cast<unsigned char>(c);
        return u < first_printable || u == del || c == ',' || c == '"';
    };
    if (!id->empty() && std::none_of(id->begin(), id->end(), unfit)) return *id;
    view.problem("id", "must be a name without commas, double quotes and control characters");
    return fallback;
}

std::string read_color(ObjectView& view)
{
    const auto color = view.string("color");
    if (!color) return "";
    const auto fit = [](char c) {
        return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
               std::string_view("#()%,./ -").find(c) != std::string_view::npos;
    };
    if (!color->empty() && std::all_of(color->begin(), color->end(), fit)) return *color;
    view.problem("color", "must be a CSS colour, such as \"#d1495b\" or \"teal\"");
    return "";
}

std::optional<Vec3> read_direction(ObjectView& view, std::string_view key)
{
    const auto given = view.vector(key);
    if (!given) return {};
    const double largest = given->cwiseAbs().maxCoeff();
    if (!(largest > 0)) {
        view.problem(key, "must have a direction, is the null vector");
        return {};
    }
    const Vec3 v = largest > safe_component || largest < 1 / safe_component ? Vec3(*given / largest) : *given;
    return Vec3(v / std::sqrt(v.squaredNorm()));
}

std::optional<Region> read_region(ObjectView& view)
{
    view.require({"min", "max"});
    const auto min = view.vector("min");
    const auto max = view.vector("max");
    if (!min || !max) return {};
    if ((min->array() < max->array()).all() && (*max - *min).allFinite()) return Region{*min, *max};
    view.problem("max", "must be greater than \"min\" on each axis");
    return {};
}

MassSpec read_mass(ObjectView& view)
{
    MassSpec spec;
    view.one_of({"mass", "density"}, false);
    spec.mass = view.number("mass", positive).value_or(spec.mass);
    spec.density = view.number("density", positive);
    return spec;
}

}  // namespace carom::io
