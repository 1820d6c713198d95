#include "io/stress_files.hpp"

#include "core/names.hpp"
#include "io/numbers.hpp"

#include <nlohmann/json.hpp>

namespace carom::io {

namespace {

using Json = nlohmann::ordered_json;  // dumps numbers that are not finite as null

Json result_json(const stress::Result& result)
{
    return {{"method", result.method},
            {"passed", result.passed},
            {"figure", result.figure},
            {"limit", result.limit},
            {"symptom", name_of(result.symptom, symptom_names)},
            {"worst", result.worst},
            {"reason", result.reason},
            {"cpu_seconds", result.seconds}};
}

Json case_json(const stress::CaseResult& c)
{
    Json json = {{"name", c.name},     {"title", c.title}, {"about", c.about},
                 {"figure", c.figure}, {"rule", c.rule},   {"step", c.step}};
    json["results"] = Json::array();
    for (const stress::Result& result : c.results) json["results"].push_back(result_json(result));
    return json;
}

}  // namespace

std::string stress_csv(const stress::Report& report)
{
    std::string text = std::string(stress_csv_header) + "\n";
    for (const stress::CaseResult& c : report.cases)
        for (const stress::Result& r : c.results)
            text += c.name + "," + r.method + "," + (r.passed ? "true" : "false") + "," + number_text(r.figure) + "," +
                    number_text(r.limit) + "," + std::string(name_of(r.symptom, symptom_names)) + "," +
                    csv_field(r.worst) + "," + csv_field(r.reason) + "," + number_text(r.seconds) + "\n";
    return text;
}

std::string stress_json(const stress::Report& report)
{
    Json json = {{"format", "carom-stress/1"},
                 {"methods", report.methods},
                 {"event_passes", report.event_passes()},
                 {"interrupted", report.interrupted}};
    json["cases"] = Json::array();
    for (const stress::CaseResult& c : report.cases) json["cases"].push_back(case_json(c));
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace carom::io
