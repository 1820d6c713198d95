#include "report/page_data.hpp"

#include "core/names.hpp"
#include "report/scene_view.hpp"
#include "report/tolerances.hpp"
#include "study/compare_columns.hpp"
#include "study/method_verdict.hpp"
#include "study/words.hpp"

#include <nlohmann/json.hpp>

#include <cmath>

namespace carom::report {

namespace {

using Json = nlohmann::ordered_json;  // dumps numbers that are not finite as null

template <typename T>
Json optional_json(const std::optional<T>& value)
{
    return value ? Json(*value) : Json(nullptr);
}

std::string label(const CompareRow& row)
{
    std::string text = row.method;
    if (row.dt) text += ", dt = " + study::step_text(*row.dt);
    text += study::variant_text(row);
    if (row.impact && *row.impact != ImpactOperator::reflections)
        text += ", " + std::string(name_of(*row.impact, impact_operator_names));
    return text;
}

Json row_json(const CompareRow& row)
{
    Json json;
    for (const study::CompareColumn& column : study::compare_columns) {
        json[std::string(column.name)] = study::cell_value<Json>(column.cell(row));
        if (column.name == "passes") json["label"] = label(row);
    }
    // Series and lists for the page alone, beyond the columns of the CSV.
    json["mistimed_impacts"] = row.mistimed_impacts;
    json["reference_impacts"] = row.reference_impacts;
    json["time"] = row.time;
    return json;
}

Json series_json(const Comparison& comparison)
{
    Json all = Json::array();
    for (std::size_t i = 0; i < comparison.rows.size(); ++i) {
        const RowSeries& series = comparison.rows[i].series;
        const auto& times = comparison.sample_times;
        // Lines of one length for the page: past the end of the reference there is no error to draw.
        const std::size_t n = std::min(series.penetration.size(), times.size());
        std::vector<double> energy = series.energy_error, position = series.position_max;
        energy.resize(n, std::nan(""));
        position.resize(n, std::nan(""));
        all.push_back({{"row", i},
                       {"time", std::vector<double>(times.begin(), times.begin() + static_cast<std::ptrdiff_t>(n))},
                       {"energy_error", energy},
                       {"penetration", series.penetration},
                       {"position_max", position}});
    }
    return all;
}

Json missed_json(const Scene& scene, const Comparison& comparison)
{
    Json all = Json::array();
    for (std::size_t i = 0; i < comparison.rows.size(); ++i) {
        std::vector<double> times;
        std::vector<std::string> names;
        for (const ImpactMismatch& each : comparison.rows[i].missed) {
            times.push_back(each.time);
            names.push_back(scene.body_name(each.a) + " - " + scene.body_name(each.b));
        }
        if (!times.empty()) all.push_back({{"row", i}, {"times", times}, {"names", names}});
    }
    return all;
}

/// Planes that are seen edge-on, as lines.
Json planes_json(const Scene& scene, const SceneView& view)
{
    Json all = Json::array();
    for (const Plane& plane : scene.planes) {
        const int hidden = 3 - view.axes[0] - view.axes[1];
        if (std::abs(plane.normal[hidden]) > edge_on) continue;
        Json normal = Json::array({plane.normal[view.axes[0]], plane.normal[view.axes[1]]});
        all.push_back({{"normal", normal},
                       {"offset", plane.offset},
                       {"thickness", optional_json(plane.thickness)},
                       {"name", plane.id}});
    }
    return all;
}

std::string color_of(const Scene& scene, const Sphere& sphere)
{
    return sphere.color.empty() ? scene.materials[static_cast<std::size_t>(sphere.material)].color : sphere.color;
}

Json view_json(const Scene& scene, const Comparison& comparison)
{
    if (scene.spheres.empty() || scene.spheres.size() > max_track_spheres) return nullptr;
    const std::size_t stride =
        frame_stride(scene.spheres.size(), comparison.sample_times.size(), comparison.rows.size() + 1);
    const SceneView view = scene_view(scene, comparison);
    static constexpr const char* axis_names[] = {"x", "y", "z"};
    std::vector<double> radius, times;
    std::vector<std::string> color, names;
    for (const Sphere& sphere : scene.spheres) {
        radius.push_back(sphere.radius);
        color.push_back(color_of(scene, sphere));
        names.push_back(sphere.id);
    }
    for (std::size_t k = 0; k < comparison.sample_times.size(); k += stride)
        times.push_back(comparison.sample_times[k]);
    Json tracks = Json::array();
    constexpr int reference_row = -1;
    if (!comparison.reference.tracks.empty())
        tracks.push_back({{"row", reference_row}, {"data", packed_tracks(view, comparison.reference.tracks, stride)}});
    for (std::size_t i = 0; i < comparison.rows.size(); ++i)
        tracks.push_back({{"row", i}, {"data", packed_tracks(view, comparison.rows[i].series.tracks, stride)}});
    return {{"axes", Json::array({axis_names[view.axes[0]], axis_names[view.axes[1]]})},
            {"from_above", view.from_above},
            {"min", view.min},
            {"max", view.max},
            {"radius", radius},
            {"color", color},
            {"names", names},
            {"planes", planes_json(scene, view)},
            {"times", times},
            {"tracks", tracks}};
}

}  // namespace

std::string comparison_data(const Scene& scene, const Comparison& comparison)
{
    const ReferenceSummary& reference = comparison.reference;
    Json json = {{"title", scene.name}, {"description", scene.description}};
    json["units"] = {{"length", scene.units.length}, {"time", scene.units.time}, {"mass", scene.units.mass}};
    json["verdict"] = comparison.verdict;
    json["until"] = comparison.until;
    json["tolerance"] = comparison.tolerance;
    const CompareRow* shown = study::cheapest_stepper(comparison);
    if (shown == nullptr) shown = study::best_stepper(comparison);
    json["step_shown"] = shown != nullptr ? optional_json(shown->dt) : Json(nullptr);
    json["reference"] = {
        {"kind", reference.kind}, {"bound", reference.bound}, {"until", reference.until}, {"reason", reference.reason}};
    json["rows"] = Json::array();
    for (const CompareRow& row : comparison.rows) json["rows"].push_back(row_json(row));
    json["series"] = series_json(comparison);
    json["missed"] = missed_json(scene, comparison);
    json["view"] = view_json(scene, comparison);
    return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string page_data(std::span<const std::string> comparisons, const std::string& generator)
{
    // The comparisons are JSON already: parsing them again would only cost.
    std::string text = R"({"format":"carom-page/1","generator":)" + Json(generator).dump() + R"(,"comparisons":[)";
    for (std::size_t i = 0; i < comparisons.size(); ++i) text += (i > 0 ? "," : "") + comparisons[i];
    return text + "]}";
}

}  // namespace carom::report
