#include "core/names.hpp"
#include "io/compare_files.hpp"
#include "io/machine.hpp"
#include "study/compare_columns.hpp"
#include "study/cost_ratio.hpp"
#include "study/share.hpp"
#include "study/search/step_scan.hpp"

#include "io/lift_json.hpp"
#include "io/vector_json.hpp"

#include <nlohmann/json.hpp>

namespace carom::io {

namespace {

using Json = nlohmann::ordered_json;

Json mismatches_json(const Scene& scene, const std::vector<ImpactMismatch>& list)
{
    Json json = Json::array();
    for (const ImpactMismatch& each : list)
        json.push_back({{"time", each.time}, {"a", scene.body_name(each.a)}, {"b", scene.body_name(each.b)}});
    return json;
}

Json number_json(const std::optional<double>& value)
{
    return value ? Json(*value) : Json(nullptr);
}

/// A share and the ends of its interval; null of nothing.
Json share_json(std::int64_t part, std::int64_t whole)
{
    if (whole == 0) return nullptr;
    const study::Share share = study::wilson_share(part, whole);
    return Json::array({share.value, share.low, share.high});
}

/// Shares of the audit's counts, with intervals of 95 %.
Json audit_json(const std::optional<Audit>& audit)
{
    if (!audit) return nullptr;
    return {{"found", share_json(audit->found, audit->audited)},
            {"late", share_json(audit->late, audit->audited)},
            {"missed", share_json(audit->missed, audit->audited)},
            {"wrong", share_json(audit->wrong, audit->audited)},
            {"invented", share_json(audit->invented, audit->looked_at)},
            {"looked_at", audit->looked_at},
            {"delay", number_json(audit->delay)}};
}

Json interval_json(double value, double low, double high)
{
    return Json::array({value, low, high});
}

Json machine_json(const Machine& machine)
{
    return {{"cpu", machine.cpu}, {"threads", machine.threads}, {"compiler", machine.compiler}};
}

Json row_json(const Scene& scene, const Comparison& comparison, const CompareRow& row)
{
    // First the keys of the CSV in its order, then what only JSON carries.
    Json json;
    for (const study::CompareColumn& column : study::compare_columns)
        json[std::string(column.name)] = study::cell_value<Json>(column.cell(row));
    json["message"] = row.message;
    json["time"] = row.time;
    json["repeats"] = row.repeats;
    json["cpu_interval"] = interval_json(row.cpu_seconds, row.cpu_low, row.cpu_high);
    const std::optional<study::Ratio> ratio = study::cost_ratio(comparison, row);
    json["cpu_ratio"] = ratio ? interval_json(ratio->value, ratio->low, ratio->high) : Json(nullptr);
    json["reference_impacts"] = row.reference_impacts;
    json["mistimed_impacts"] = row.mistimed_impacts;
    json["missed_at"] = mismatches_json(scene, row.missed);
    json["invented_at"] = mismatches_json(scene, row.invented);
    json["audit"] = audit_json(row.audit);
    json["lifted"] = lifts_json(scene, row.lifts);
    return json;
}

Json convergence_json(const Convergence& fit)
{
    return {{"method", fit.method},           {"variant", fit.variant}, {"order", fit.order},
            {"uncertainty", fit.uncertainty}, {"steps", fit.steps},     {"stalled", fit.stalled},
            {"last_error", fit.last_error}};
}

Json convention_json(const Scene& scene, const Convention& each)
{
    Json bodies = Json::array(), answers = Json::object();
    for (const BodyId body : each.bodies) bodies.push_back(scene.body_name(body));
    for (const Convention::Answer& answer : each.answers) {
        Json velocities = Json::array();
        for (const Vec3& v : answer.velocities) velocities.push_back(vector_json(v));
        answers[std::string(name_of(answer.impact_operator, impact_operator_names))] = velocities;
    }
    return {{"time", each.time}, {"bodies", bodies}, {"differ", each.differ}, {"velocities", answers}};
}

Json search_json(const StepSearch& search)
{
    const study::SearchFigures figures = study::figures_of(search);
    const auto step = [](const std::optional<StepSearch::Try>& each) { return each ? Json(each->dt) : Json(nullptr); };
    const auto error = [](const std::optional<StepSearch::Try>& each) {
        return each ? number_json(each->error) : Json(nullptr);
    };
    return {{"method", search.method},
            {"variant", search.variant},
            {"end", name_of(search.end, step_search_names)},
            {"dt", number_json(search.row ? search.row->dt : std::nullopt)},
            {"tried", search.tries.size()},
            {"held", figures.held},
            {"worst_error", figures.held > 0 ? Json(figures.worst_error) : Json(nullptr)},
            {"smallest", search.tries.empty() ? Json(nullptr) : Json(search.tries.front().dt)},
            {"complete", search.is_complete},
            {"largest", search.largest},
            {"too_far", step(figures.too_far)},
            {"too_far_error", error(figures.too_far)},
            {"best_step", step(figures.best)},
            {"best_error", error(figures.best)}};
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
    json["compared_until"] = comparison.compared_until;
    json["machine"] = machine_json(this_machine());
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
                         {"cpu_seconds", reference.cpu_seconds},
                         {"conventions", Json::array()}};
    for (const Convention& each : reference.conventions)
        json["reference"]["conventions"].push_back(convention_json(scene, each));
    json["audit"] = {{"until", comparison.audit.until}, {"contacts", comparison.audit.contacts},
                     {"drawn", comparison.audit.drawn}, {"phases", comparison.audit.phases},
                     {"slow", comparison.audit.slow},   {"persistent", comparison.audit.persistent}};
    json["rows"] = Json::array();
    for (const CompareRow& row : comparison.rows) json["rows"].push_back(row_json(scene, comparison, row));
    json["convergence"] = Json::array();
    for (const Convergence& fit : comparison.convergence) json["convergence"].push_back(convergence_json(fit));
    json["searches"] = Json::array();
    for (const StepSearch& search : comparison.searches) json["searches"].push_back(search_json(search));
    json["verdict"] = joined(comparison.verdict);
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace carom::io
