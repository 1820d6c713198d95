#include "io/audit_files.hpp"

#include "audit/minimal_scene.hpp"
#include "core/names.hpp"
#include "io/scene_json.hpp"

#include <nlohmann/json.hpp>

namespace carom::io {

namespace {

using Json = nlohmann::ordered_json;  // dumps numbers that are not finite as null

Json check_json(const Scene& scene, const Check& check)
{
    Json json = {{"type", name_of(check.type, check_type_names)}};
    if (check.type == CheckType::event_count) {
        json["count"] = check.count;
        json["kind"] = name(check.kind);
    } else {
        json["event"] = check.index;
        json["time"] = check.time;
        if (check.between)
            json["between"] = {scene.body_name((*check.between)[0]), scene.body_name((*check.between)[1])};
    }
    if (check.abs) json["abs"] = *check.abs;
    return json;
}

Json finding_json(const Scene& scene, const audit::Finding& finding)
{
    using audit::FindingKind;
    Json json = {{"kind", name_of(finding.kind, audit::finding_kind_names)},
                 {"time", finding.time},
                 {"a", scene.body_name(finding.a)},
                 {"b", finding.b == no_body ? Json(nullptr) : Json(scene.body_name(finding.b))},
                 {"depth", finding.depth}};
    const bool has_delay = finding.kind == FindingKind::late || finding.kind == FindingKind::early;
    json["by"] = has_delay ? Json(finding.by) : Json(nullptr);
    json["at_least"] = finding.at_least;
    // 0: the frames after it show no flight.
    json["velocity_change"] = finding.change > 0 ? Json(finding.change) : Json(nullptr);
    json["scene"] = finding_file(finding);
    return json;
}

}  // namespace

std::string finding_file(const audit::Finding& finding)
{
    return std::string(name_of(finding.kind, audit::finding_kind_names)) + "-" + std::to_string(finding.number) +
           ".json";
}

std::string finding_scene_json(const Scene& scene, const audit::Finding& finding)
{
    const Scene small = audit::minimal_scene(scene, finding);
    Json json = Json::parse(scene_json(small));
    json["checks"] = Json::array();
    for (const Check& check : small.checks) json["checks"].push_back(check_json(small, check));
    return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string audit_json(const Scene& scene, const std::string& trace, const audit::TraceAudit& audit,
                       const CommandFacts& command)
{
    Json json = {{"format", "carom-audit/1"}, {"scene", scene.name}, {"trace", trace}};
    json["frames"] = audit.frames;
    json["begin"] = audit.begin;
    json["end"] = audit.end;
    json["spheres"] = scene.spheres.size();
    json["place_error"] = audit.place_error;
    json["body_intervals"] = {{"all", audit.bodies.all},
                              {"decided", audit.bodies.decided},
                              {"without_flight", audit.bodies.without_flight},
                              {"straight", audit.bodies.straight},
                              {"coarse", audit.bodies.coarse},
                              {"several", audit.bodies.several}};
    json["touches"] = {{"all", audit.touches.all},
                       {"found", audit.touches.found},
                       {"several", audit.touches.several},
                       {"unsettled", audit.touches.unsettled},
                       {"grazing", audit.grazing}};
    json["missed"] = audit.touches.missed;
    json["late"] = audit.touches.late;
    json["early"] = audit.touches.early;
    json["invented"] = audit.invented;
    json["overlaps"] = audit.overlaps;
    json["deepest_overlap"] = audit.deepest;
    json["undecided"] = audit.undecided();
    put_stopped(json, command);
    put_seconds(json, command);
    json["findings"] = Json::array();
    for (const audit::Finding& finding : audit.findings) json["findings"].push_back(finding_json(scene, finding));
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace carom::io
