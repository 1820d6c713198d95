#include "io/scene_json.hpp"

#include "core/names.hpp"
#include "io/vector_json.hpp"

#include <carom/error.hpp>

#include <nlohmann/json.hpp>

namespace carom::io {

namespace {

using Json = nlohmann::ordered_json;

void put(Json& json, const char* key, const std::optional<double>& value)
{
    if (value) json[key] = *value;
}

Json materials_json(const Scene& scene)
{
    Json json = Json::object();
    for (const Material& m : scene.materials) {
        json[m.name] = {{"restitution", m.restitution}, {"tangential", m.tangential}};
        if (!m.color.empty()) json[m.name]["color"] = m.color;
    }
    return json;
}

Json contacts_json(const Scene& scene)
{
    Json json = Json::array();
    const auto material = [&](int m) { return scene.materials[static_cast<std::size_t>(m)].name; };
    for (const ContactRule& rule : scene.contacts) {
        Json& entry = json.emplace_back(Json{{"between", {material(rule.a), material(rule.b)}}});
        put(entry, "restitution", rule.restitution);
        put(entry, "tangential", rule.tangential);
        put(entry, "attenuation", rule.attenuation);
    }
    return json;
}

Json rest_json(const RestOptions& rest)
{
    Json json = {{"policy", name_of(rest.policy, rest_policy_names)}};
    put(json, "closing_speed", rest.closing_speed);
    put(json, "window", rest.window);
    put(json, "numeric_step", rest.numeric_step);
    put(json, "gap_tolerance", rest.gap_tolerance);
    json["series_below"] = rest.series_below;
    return json;
}

Json impact_json(const ImpactOptions& impact)
{
    Json json = {{"operator", name_of(impact.impact_operator, impact_operator_names)}};
    put(json, "tie", impact.tie);
    if (impact.on_cap != OnCap::accept) json["on_cap"] = name_of(impact.on_cap, on_cap_names);
    if (impact.impact_operator != ImpactOperator::lcp) return json;
    json["law"] = name_of(impact.lcp.law, lcp_law_names);
    json["solver"] = name_of(impact.lcp.solver, lcp_solver_names);
    json["sweeps"] = impact.lcp.sweeps;
    return json;
}

Json guard_json(const GuardOptions& guard)
{
    if (!guard.on) return "off";
    Json json = {{"impacts", guard.impacts}};
    put(json, "window", guard.window);
    json["fallback"] = name_of(guard.fallback, guard_fallback_names);
    return json;
}

Json planes_json(const Scene& scene)
{
    Json json = Json::array();
    for (const Plane& plane : scene.planes) {
        Json& entry =
            json.emplace_back(Json{{"id", plane.id},
                                   {"normal", vector_json(plane.normal)},
                                   {"offset", plane.offset},
                                   {"material", scene.materials[static_cast<std::size_t>(plane.material)].name}});
        put(entry, "thickness", plane.thickness);
    }
    return json;
}

constexpr auto replace = Json::error_handler_t::replace;

}  // namespace

std::string scene_json_without_spheres(const Scene& scene)
{
    Json json = {{"format", "carom-scene/1"}, {"name", scene.name}, {"description", scene.description}};
    json["units"] = {{"length", scene.units.length}, {"time", scene.units.time}, {"mass", scene.units.mass}};
    json["gravity"] = vector_json(scene.gravity);
    json["drag"] = scene.drag;
    json["origin"] = vector_json(scene.origin);
    json["start_time"] = {{"epoch", scene.start_time.epoch}, {"offset", scene.start_time.offset}};
    json["end_time"] = scene.end_time;
    json["seed"] = scene.seed;
    json["materials"] = materials_json(scene);
    json["contacts"] = contacts_json(scene);
    json["rest"] = rest_json(scene.rest);
    json["impact"] = impact_json(scene.impact);
    json["guard"] = guard_json(scene.guard);
    json["planes"] = planes_json(scene);
    return json.dump(1, ' ', false, replace);
}

std::string scene_json(const Scene& scene)
{
    Json json = Json::parse(scene_json_without_spheres(scene));
    json["spheres"] = Json::array();
    for (const Sphere& sphere : scene.spheres) {
        Json& entry = json["spheres"].emplace_back(
            Json{{"id", sphere.id},
                 {"radius", sphere.radius},
                 {"mass", sphere.mass},
                 {"position", vector_json(sphere.position)},
                 {"velocity", vector_json(sphere.velocity)},
                 {"material", scene.materials[static_cast<std::size_t>(sphere.material)].name}});
        if (sphere.fixed) entry["fixed"] = true;
    }
    return json.dump(-1, ' ', false, replace);
}

std::string strings_json(const std::vector<std::string>& strings)
{
    return Json(strings).dump(-1, ' ', false, replace);
}

std::vector<std::string> strings_of_json(const std::string& text, const std::string& file)
{
    const Json json = Json::parse(text, nullptr, false);
    if (!json.is_array()) throw InputError({file + ": damaged: ids are no list"});
    std::vector<std::string> strings;
    for (const Json& each : json) {
        if (!each.is_string()) throw InputError({file + ": damaged: an id is no text"});
        strings.push_back(each.get<std::string>());
    }
    return strings;
}

}  // namespace carom::io
