#include "io/tunnel_files.hpp"

#include "io/numbers.hpp"
#include "io/scene_json.hpp"
#include "study/tolerances.hpp"
#include "study/words.hpp"
#include "tunnel/columns.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace carom::io {

namespace {

using Json = nlohmann::ordered_json;  // dumps numbers that are not finite as null

struct CellText {
    std::string operator()(const std::string& text) const { return csv_field(text); }
    std::string operator()(std::optional<double> value) const { return number_text(value); }
    std::string operator()(std::optional<std::int64_t> value) const { return value ? std::to_string(*value) : ""; }
};

template <class Columns, class Lines>
std::string csv(const Columns& columns, const Lines& lines)
{
    std::string text;
    for (const auto& column : columns) text += std::string(column.name) + ",";
    text.back() = '\n';
    for (const auto& line : lines) {
        for (const auto& column : columns) text += std::visit(CellText{}, column.cell(line)) + ",";
        text.back() = '\n';
    }
    return text;
}

template <class Columns, class Lines>
Json objects(const Columns& columns, const Lines& lines)
{
    Json all = Json::array();
    for (const auto& line : lines) {
        Json& entry = all.emplace_back(Json::object());
        for (const auto& column : columns) entry[std::string(column.name)] = study::cell_value<Json>(column.cell(line));
    }
    return all;
}

}  // namespace

std::string tunnel_csv(const tunnel::Report& report)
{
    return csv(tunnel::row_columns, report.rows);
}

std::string critical_csv(const tunnel::Report& report)
{
    return csv(tunnel::critical_columns, report.criticals);
}

std::string tunnel_json(const tunnel::Report& report, const CommandFacts& command)
{
    Json json = {{"format", "carom-tunnel/1"},
                 {"scene", report.scene},
                 {"seed", report.seed},
                 {"event_holds", report.exact_hold()},
                 {"interrupted", report.interrupted}};
    put_stopped(json, command);
    put_seconds(json, command);
    json["absent"] = Json::array();
    for (const tunnel::Absence& each : report.absent)
        json["absent"].push_back({{"name", each.name}, {"reason", each.reason}});
    json["engines"] = Json::array();
    for (const tunnel::EngineSettings& each : report.engines)
        json["engines"].push_back({{"name", each.name}, {"settings", each.words}});
    json["rows"] = objects(tunnel::row_columns, report.rows);
    json["critical"] = objects(tunnel::critical_columns, report.criticals);
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string throw_scene_json(const tunnel::Row& row)
{
    tunnel::Throw t = tunnel::example_of(row);
    const std::string target(name_of(row.cell.target, tunnel::target_names));
    t.scene.name = row.method + " at a " + target;
    t.scene.description = "A throw of carom tunnel: the contact is at t = " + number_text(t.contact_time) +
                          ", in the first of three steps of " + study::step_text(row.cell.dt) + ".";
    t.scene.end_time = study::longest_case * row.cell.dt;
    Json json = Json::parse(scene_json(t.scene));
    const std::vector<std::string>& known = method_names();
    if (std::find(known.begin(), known.end(), row.method) != known.end()) {
        json["run"] = {{"method", row.method}};
        if (row.integrator) {
            json["run"]["dt"] = row.cell.dt;
            json["run"]["integrator"] = name(*row.integrator);
        }
    }
    json["compare"] = {{"dt", Json::array({row.cell.dt})}};
    return json.dump(2) + "\n";
}

}  // namespace carom::io
