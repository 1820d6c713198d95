#include "io/check_json.hpp"

#include <nlohmann/json.hpp>

namespace carom::io {

namespace {

using Json = nlohmann::ordered_json;  // dumps numbers that are not finite as null

Json result_json(const CheckResult& result)
{
    return {{"check", result.what},
            {"verdict", name(result.verdict)},
            {"error", result.error ? Json(*result.error) : Json(nullptr)},
            {"tolerance", result.tolerance},
            {"message", result.message}};
}

}  // namespace

std::string check_json(const std::vector<CheckedScene>& scenes, const CommandFacts& command)
{
    Json list = Json::array();
    bool all_hold = !command.stopped;
    for (const CheckedScene& each : scenes) {
        Json results = Json::array();
        for (const CheckResult& result : each.report.results) results.push_back(result_json(result));
        const Outcome& outcome = each.report.run.study.outcome;
        const bool passed = each.report.all_hold() && outcome.status == Status::reached_end;
        all_hold = all_hold && passed;
        list.push_back({{"name", each.name},
                        {"title", each.title},
                        {"passed", passed},
                        {"status", name(outcome.status)},
                        {"message", outcome.message},
                        {"time", outcome.time},
                        {"cpu_seconds", each.report.run.study.cpu_seconds},
                        {"checks", results}});
    }
    Json json = {{"format", "carom-check/1"}, {"passed", all_hold}};
    put_stopped(json, command);
    put_seconds(json, command);
    json["scenes"] = list;
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace carom::io
