#include "io/compare_files.hpp"

#include "io/lift_json.hpp"

#include <nlohmann/json.hpp>

namespace carom::io {

namespace {

using Json = nlohmann::ordered_json;

template <typename T>
Json optional_json(const std::optional<T>& value)
{
    return value ? Json(*value) : Json(nullptr);
}

Json mismatches_json(const Scene& scene, const std::vector<ImpactMismatch>& list)
{
    Json json = Json::array();
    for (const ImpactMismatch& each : list)
        json.push_back({{"time", each.time}, {"a", scene.body_name(each.a)}, {"b", scene.body_name(each.b)}});
    return json;
}

Json row_json(const Scene& scene, const CompareRow& row)
{
    // First the keys of the CSV in its order, then what only JSON carries.
    return {{"method", row.method},
            {"dt", optional_json(row.dt)},
            {"substeps", optional_json(row.substeps)},
            {"passes", optional_json(row.passes)},
            {"cpu_seconds", row.cpu_seconds},
            {"cpu_min", row.cpu_min},
            {"cpu_max", row.cpu_max},
            {"position_rms", optional_json(row.position_rms)},
            {"position_max", optional_json(row.position_max)},
            {"position_final_rms", optional_json(row.position_final_rms)},
            {"position_final_max", optional_json(row.position_final_max)},
            {"velocity_rms", optional_json(row.velocity_rms)},
            {"energy_error", optional_json(row.energy_error)},
            {"max_penetration", row.max_penetration},
            {"missed_impacts", row.missed_impacts},
            {"invented_impacts", row.invented_impacts},
            {"impacts", row.impacts},
            {"rest_jitter", optional_json(row.rest_jitter)},
            {"divergence_time", optional_json(row.divergence_time)},
            {"reference_bound", row.reference_bound},
            {"steps", row.steps},
            {"root_solves", row.root_solves},
            {"pair_tests", row.pair_tests},
            {"status", name(row.status)},
            {"message", row.message},
            {"time", row.time},
            {"repeats", row.repeats},
            {"reference_impacts", row.reference_impacts},
            {"mistimed_impacts", row.mistimed_impacts},
            {"missed", mismatches_json(scene, row.missed)},
            {"invented", mismatches_json(scene, row.invented)},
            {"lifted", lifts_json(scene, row.lifts)}};
}

std::string joined(const std::vector<std::string>& sentences)
{
    std::string text;
    for (const std::string& sentence : sentences) text += (text.empty() ? "" : " ") + sentence;
    return text;
}

}  // namespace

std::string compare_json(const Scene& scene, const Comparison& comparison, const CommandFacts& command)
{
    const ReferenceSummary& reference = comparison.reference;
    Json json = {{"format", "carom-compare/1"}, {"scene", scene.name}};
    json["until"] = comparison.until;
    json["tolerance"] = comparison.tolerance;
    json["interrupted"] = comparison.interrupted;
    put_stopped(json, command);
    put_seconds(json, command);
    json["reference"] = {{"kind", reference.kind},
                         {"bound", reference.bound},
                         {"until", reference.until},
                         {"reason", reference.reason},
                         {"impacts", reference.impacts},
                         {"series", reference.series},
                         {"cpu_seconds", reference.cpu_seconds}};
    json["rows"] = Json::array();
    for (const CompareRow& row : comparison.rows) json["rows"].push_back(row_json(scene, row));
    json["verdict"] = joined(comparison.verdict);
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace carom::io
