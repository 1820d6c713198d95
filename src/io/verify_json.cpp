#include "io/verify_json.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

namespace carom::io {

namespace {

using Json = nlohmann::ordered_json;  // dumps numbers that are not finite as null

Json body_json(const Certificate& c, const RecordingReader& recording, BodyId body)
{
    return body < 0 || body >= c.spheres + c.planes ? Json(nullptr) : Json(recording.body_name(body));
}

Json meta_json(const RecordingReader& recording, const char* key)
{
    const auto found = recording.meta().find(key);
    return found == recording.meta().end() ? Json(nullptr) : Json(found->second);
}

Json violations_json(const Certificate& c, const RecordingReader& recording)
{
    Json list = Json::array();
    for (const Violation& v : c.violations)
        list.push_back({{"what", v.what},
                        {"time", v.time},
                        {"a", body_json(c, recording, v.a)},
                        {"b", body_json(c, recording, v.b)}});
    return list;
}

}  // namespace

std::string verify_json(const Certificate& c, const RecordingReader& recording, const CommandFacts& command)
{
    Json json = {{"format", "carom-verify/1"}, {"holds", c.holds() && c.stopped ? Json(nullptr) : Json(c.holds())}};
    for (const char* key : {"scene", "method", "number", "status"}) json[key] = meta_json(recording, key);
    json["complete"] = c.complete;
    json["until"] = c.until;
    put_stopped(json, command);
    put_seconds(json, command);
    json["spheres"] = c.spheres;
    json["planes"] = c.planes;
    json["events"] = c.events;
    json["flights"] = c.flights;
    json["event_hash"] = fmt::format("{:016x}", c.event_hash);
    json["pairs"] = c.pairs;
    json["segments"] = c.segments;
    json["needed_double_double"] = c.needed_double_double;
    json["needed_exact"] = c.needed_exact;
    json["smallest_gap"] = c.smallest_gap;
    json["smallest_gap_time"] = c.smallest_gap_time;
    json["impulses"] = c.impulses;
    json["tie"] = recording.run().tie;
    json["largest"] = {{"impact_gap", c.largest_impact_gap},         {"jump", c.largest_jump},
                       {"impulse_error", c.largest_impulse_error},   {"law_error", c.largest_law_error},
                       {"momentum_error", c.largest_momentum_error}, {"energy_error", c.largest_energy_error}};
    json["clusters"] = c.clusters;
    json["rests_on_spheres"] = c.rests_on_spheres;
    json["releases_of_spheres"] = c.releases_of_spheres;
    json["guards"] = c.guards;
    json["settles"] = c.settles;
    json["largest_absorbed"] = c.largest_absorbed;
    json["numeric"] = {{"depth", c.numeric_depth},
                       {"guarded_depth", c.guarded_depth},
                       {"jump", c.largest_numeric_jump},
                       {"kick", c.largest_numeric_kick}};
    json["body_seconds"] = {{"exact", c.body_seconds.exact},           {"bounded", c.body_seconds.bounded},
                            {"in_contact", c.body_seconds.in_contact}, {"numeric", c.body_seconds.numeric},
                            {"guarded", c.body_seconds.guarded},       {"not_certified", c.body_seconds.not_certified}};
    json["violated"] = c.violated;
    json["violations"] = violations_json(c, recording);
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace carom::io
