#include "io/stress_files.hpp"

#include "core/names.hpp"
#include "io/numbers.hpp"

#include <nlohmann/json.hpp>

namespace carom::io {

namespace {

using Json = nlohmann::ordered_json;  // dumps numbers that are not finite as null

/// Keys of a result, in the order of stress.csv.
Json result_json(const stress::Result& result)
{
    const stress::Finding& worst = result.worst();
    return {{"method", result.method},
            {"passed", result.passed()},
            {"figure", result.figure()},
            {"limit", result.limit},
            {"symptom", name_of(worst.symptom, symptom_names)},
            {"scene", worst.trial},
            {"worst", worst.evidence.worst},
            {"reason", result.reason},
            {"cpu_seconds", result.seconds}};
}

Json runs_json(const stress::Result& result)
{
    Json runs = Json::array();
    for (const stress::Finding& each : result.findings)
        runs.push_back({{"scene", each.trial},
                        {"figure", each.evidence.figure},
                        {"symptom", name_of(each.symptom, symptom_names)},
                        {"worst", each.evidence.worst}});
    return runs;
}

std::string field(const Json& value)
{
    if (value.is_number()) return number_text(value.get<double>());
    return value.is_string() ? csv_field(value.get<std::string>()) : value.dump();
}

}  // namespace

std::string stress_csv(const stress::Report& report)
{
    std::string text = std::string(stress_csv_header) + "\n";
    for (const stress::Case& each : report.cases)
        for (const stress::Result& result : each.results) {
            text += each.words.case_name + "," + csv_field(each.words.waits_for);
            const Json fields = result_json(result);
            for (const Json& value : fields) text += "," + field(value);
            text += "\n";
        }
    return text;
}

std::string stress_json(const stress::Report& report, const CommandFacts& command)
{
    Json json = {{"format", "carom-stress/1"},
                 {"methods", report.methods},
                 {"event_passes", report.exact_hold()},
                 {"interrupted", report.interrupted}};
    put_stopped(json, command);
    put_seconds(json, command);
    json["cases"] = Json::array();
    for (const stress::Case& each : report.cases) {
        const StressPart& words = each.words;
        Json& entry = json["cases"].emplace_back(Json{{"name", words.case_name},
                                                      {"title", words.title},
                                                      {"about", each.about},
                                                      {"figure", words.figure},
                                                      {"rule", each.rule()},
                                                      {"step", words.step},
                                                      {"waits_for", words.waits_for},
                                                      {"results", Json::array()}});
        for (const stress::Result& result : each.results) {
            entry["results"].push_back(result_json(result));
            entry["results"].back()["runs"] = runs_json(result);
        }
    }
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace carom::io
