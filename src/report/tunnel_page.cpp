#include "report/tunnel_page.hpp"

#include "tunnel/columns.hpp"
#include "tunnel/summary.hpp"

#include <nlohmann/json.hpp>

namespace carom::report {

namespace {

using Json = nlohmann::ordered_json;  // dumps numbers that are not finite as null

template <class Columns>
Json names_of(const Columns& columns)
{
    Json names = Json::array();
    for (const auto& column : columns) names.push_back(std::string(column.name));
    return names;
}

template <class Columns, class Lines>
Json table(const Columns& columns, const Lines& lines)
{
    Json all = Json::array();
    for (const auto& line : lines) {
        Json& cells = all.emplace_back(Json::array());
        for (const auto& column : columns) cells.push_back(study::cell_value<Json>(column.cell(line)));
    }
    return all;
}

}  // namespace

std::string tunnel_page_data(const tunnel::Report& report, const std::string& generator,
                             const std::vector<std::string>& scenes)
{
    Json json = {{"format", "carom-tunnel-page/1"},
                 {"generator", generator},
                 {"title", report.scene.empty() ? "Tunnelling" : "Tunnelling: " + report.scene},
                 {"verdict", tunnel::verdict(report)},
                 {"scene", report.scene},
                 {"seed", report.seed}};
    json["absent"] = Json::array();
    for (const tunnel::Absence& each : report.absent)
        json["absent"].push_back({{"name", each.name}, {"reason", each.reason}});
    json["columns"] = names_of(tunnel::row_columns);
    json["rows"] = table(tunnel::row_columns, report.rows);
    json["critical_columns"] = names_of(tunnel::critical_columns);
    json["critical"] = table(tunnel::critical_columns, report.criticals);
    json["scenes"] = scenes;
    return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace carom::report
