#include "io/run_json.hpp"

#include "io/json_text.hpp"
#include "io/lift_json.hpp"
#include "io/limits.hpp"
#include "io/vector_json.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include <string_view>

namespace carom::io {

namespace {

using Json = nlohmann::ordered_json;  // dumps numbers that are not finite as null

Json optional_json(const std::optional<double>& value)
{
    return value ? Json(*value) : Json(nullptr);
}

Json counts_json(const Counts& c)
{
    return {{"impacts", c.impacts},
            {"clusters", c.clusters},
            {"capped", c.capped},
            {"early_rests", c.early_rests},
            {"rests", c.rests},
            {"releases", c.releases},
            {"guarded", c.guarded},
            {"settles", c.settles},
            {"cell_crossings", c.cell_crossings},
            {"list_rebuilds", c.list_rebuilds},
            {"stale", c.stale},
            {"pair_tests", c.pair_tests},
            {"root_solves", c.root_solves},
            {"steps", c.steps},
            {"numeric_steps", c.numeric_steps}};
}

Json energy_taken_json(const EnergyTaken& taken)
{
    return {{"closing", taken.closing}, {"settling", taken.settling}, {"stabilising", taken.stabilising},
            {"guard", taken.guard},     {"window", taken.window},     {"capped", taken.capped}};
}

Json early_rest_json(const Scene& scene, const std::optional<EarlyRest>& early)
{
    return early ? Json{{"body", scene.body_name(early->body)}, {"time", early->time}} : Json(nullptr);
}

Json body_seconds_json(const BodyTimes& times)
{
    return {{"closed_form", times.closed_form}, {"numeric", times.numeric}, {"guarded", times.guarded}};
}

Json step_json(const Method& method, const StepOptions& step)
{
    Json json = {{"dt", step.dt},
                 {"substeps", step.substeps},
                 {"passes", step.passes},
                 {"order", std::string(name(step.order))},
                 {"integrator", std::string(name(step.integrator))},
                 {"literal", step.literal},
                 {"seed", step.seed}};
    if (const auto* penalty = std::get_if<Penalty>(&method)) json["stiffness"] = optional_json(penalty->stiffness);
    if (const auto* soft = std::get_if<Soft>(&method)) {
        json["hertz"] = soft->hertz;
        json["damping_ratio"] = soft->damping_ratio;
    }
    return json;
}

Json pressure_json(const Scene& scene, const RunStudy& run)
{
    Json planes = Json::object();
    for (std::size_t p = 0; p < scene.planes.size(); ++p)
        planes[scene.planes[p].id] = p < run.plane_forces.size() ? optional_json(run.plane_forces[p]) : Json(nullptr);
    return {{"virial_z", nullptr}, {"planes", planes}};
}

/// Lists as long as the scene is large: written as text.
void append_rest_times(std::string& text, const Scene& scene, const Outcome& outcome)
{
    constexpr std::size_t indent = json_indent, inner = indent + json_indent;
    text += ',';
    append_line(text, indent);
    text += "\"rest_times\": {";
    bool any = false;
    for (std::size_t i = 0; i < outcome.rest_times.size(); ++i) {
        if (!outcome.rest_times[i]) continue;
        if (any) text += ',';
        any = true;
        append_line(text, inner);
        append_string(text, scene.spheres[i].id);
        text += ": ";
        append_number(text, *outcome.rest_times[i]);
    }
    if (any) append_line(text, indent);
    text += '}';
}

void append_final(std::string& text, const Scene& scene, const Outcome& outcome)
{
    constexpr std::size_t indent = json_indent, inner = indent + json_indent, innermost = inner + json_indent;
    const bool far = scene.origin != Vec3::Zero();
    const auto member = [&](const char* key) {
        append_line(text, innermost);
        text.append(1, '"').append(key).append("\": ");
    };
    text += ',';
    append_line(text, indent);
    text += "\"final\": [";
    for (std::size_t i = 0; i < outcome.final.size(); ++i) {
        const BodyState& state = outcome.final[i];
        if (i > 0) text += ',';
        append_line(text, inner);
        text += '{';
        member("id");
        append_string(text, scene.spheres[i].id);
        text += ',';
        member("position");
        append_vector(text, far ? Vec3(scene.origin + state.position) : state.position, innermost);
        text += ',';
        if (far) {
            member("local");
            append_vector(text, state.position, innermost);
            text += ',';
        }
        member("velocity");
        append_vector(text, state.velocity, innermost);
        text += ',';
        member("mode");
        append_string(text, name(state.mode));
        append_line(text, inner);
        text += '}';
    }
    if (!outcome.final.empty()) append_line(text, indent);
    text += ']';
}

}  // namespace

std::string run_json(const Scene& scene, const Method& method, const RunStudy& run, const RunJsonOptions& options)
{
    const Outcome& outcome = run.outcome;
    const StepOptions* step = step_options(method);
    Json json = {{"format", "carom-run/1"}, {"scene", scene.name}, {"method", run.method}};
    json["kernel"] = outcome.kernel.empty() ? Json(nullptr) : Json(outcome.kernel);
    const auto* event = std::get_if<EventDriven>(&method);
    json["number"] = event != nullptr && event->certified ? "double-double" : "double";
    if (step != nullptr) json["step"] = step_json(method, *step);
    json["status"] = name(outcome.status);
    json["message"] = outcome.message;
    json["time"] = outcome.time;
    if (scene.start_time != EpochTime{})
        json["start_time"] = {{"epoch", scene.start_time.epoch}, {"offset", scene.start_time.offset}};
    if (scene.origin != Vec3::Zero()) json["origin"] = vector_json(scene.origin);
    json["spheres"] = scene.spheres.size();
    json["counts"] = counts_json(outcome.counts);
    json["energy"] = {{"initial", run.initial_energy},
                      {"final", run.final_energy},
                      {"drag", optional_json(run.drag_energy)},
                      {"max_relative_drift", optional_json(run.max_relative_drift)}};
    if (event != nullptr) {
        json["energy"]["taken"] = energy_taken_json(outcome.energy_taken);
        json["energy"]["lifted"] = lifts_json(scene, run.lifts);
        json["early_rest"] = early_rest_json(scene, outcome.early_rest);
        json["body_seconds"] = body_seconds_json(outcome.body_seconds);
    }
    json["momentum"] = {{"initial", vector_json(run.initial_momentum)}, {"final", vector_json(run.final_momentum)}};
    json["max_penetration"] = run.max_penetration;
    json["missed_impacts"] = nullptr;
    json["escaped"] = run.escaped;
    json["cpu_seconds"] = run.cpu_seconds;
    json["wall_seconds"] = run.wall_seconds;
    put_seconds(json, options.command);
    json["event_hash"] = step == nullptr ? Json(fmt::format("{:016x}", outcome.event_hash)) : Json(nullptr);
    json["pressure"] = pressure_json(scene, run);
    std::string text = json.dump(static_cast<int>(json_indent), ' ', false, Json::error_handler_t::replace);
    constexpr std::string_view end = "\n}";
    text.resize(text.size() - end.size());
    append_rest_times(text, scene, outcome);
    if (options.always_final || outcome.final.size() <= max_final_spheres) append_final(text, scene, outcome);
    return text.append(end).append("\n");
}

}  // namespace carom::io
