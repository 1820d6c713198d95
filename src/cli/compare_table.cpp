#include "cli/compare_audit.hpp"
#include "cli/search_table.hpp"
#include "cli/tables.hpp"

#include "study/compare_columns.hpp"
#include "study/cost_ratio.hpp"
#include "study/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <set>

namespace carom::cli {

const char* const compare_legend =
    "max error: farthest that a sphere is from the reference at any of 200 sample times; at end: at the last of them\n"
    "energy err: most that the energy is off at a sample time, of the reference's largest kinetic energy\n"
    "overlap: deepest, for a stepper before it corrects; left: after it, at sample times; jitter: rms speed of what "
    "rests in the reference\n"
    "found, late, missed, wrong: of the impacts audited, with the interval of 95 %: answered in their step with the\n"
    "  right velocity; in the step after; not at all; with another velocity; crowded: not audited, another is too "
    "near\n"
    "invented: two steps of a body without an impact in which it answers one; event: beside the reference's impacts\n"
    "run missed, run invented: impacts of the whole run that never come, or that the reference has not\n"
    "diverges: when a sphere is first off by 0.01 of the smallest radius; impacts are counted up to then\n"
    "CPU: median of the repeats, samples included; x event: that over the event run's, with the interval of 95 %\n";

namespace {

using study::seconds_text;
using study::step_text;
using study::time_text;

/// A column: its heading, and a cell for each row. Without any cell but "-" it is left out.
struct Column {
    std::string title;
    std::function<std::string(const CompareRow&)> cell;
    bool always = true;
};

std::string unit_text(study::ColumnUnit unit, const Units& units)
{
    switch (unit) {
        case study::ColumnUnit::length:
            return units.length;
        case study::ColumnUnit::speed:
            return units.length.empty() || units.time.empty() ? "" : units.length + "/" + units.time;
        case study::ColumnUnit::time:     // cells and the head say which
        case study::ColumnUnit::seconds:  // cells say it, with a prefix
        case study::ColumnUnit::none:
            break;
    }
    return "";
}

/// Heading and unit of the column of compare.csv that has this name.
std::string heading(std::string_view name, const Units& units)
{
    const study::CompareColumn& column = study::compare_column(name);
    const std::string unit = unit_text(column.unit, units);
    return std::string(column.heading) + (unit.empty() ? "" : " [" + unit + "]");
}

/// Impacts are counted while run and reference agree. A run that parts from it before the first one has none to miss,
/// and so has one whose reference ends at the start. A peer shows no impacts at all.
bool never_judged(const CompareRow& row)
{
    return row.peer_settings || ((row.divergence_time || !row.position_max) && row.reference_impacts == 0);
}

std::string status_text(const CompareRow& row)
{
    const std::string status = name(row.status);
    return row.status == Status::reached_end ? status : status + " at " + time_text(row.time, "");
}

/// Words of a row in a column; "-" for nothing.
std::string word(std::string_view column, const CompareRow& row)
{
    const std::string text = std::get<std::string>(study::compare_column(column).cell(row));
    return text.empty() ? "-" : text;
}

/// Whether rows that have something in a column of words have different things.
bool differs(const Comparison& comparison, std::string_view column)
{
    std::set<std::string> words;
    for (const CompareRow& row : comparison.rows) words.insert(word(column, row));
    words.erase("-");
    return words.size() > 1;
}

std::vector<Column> columns(const Scene& scene, const Comparison& comparison)
{
    const Units& units = scene.units;
    const auto named = [&](std::string_view name) { return heading(name, units); };
    const auto number = [](const std::optional<int>& value) { return value ? std::to_string(*value) : "-"; };
    const auto several = [&](std::optional<int> CompareRow::*member) {
        return std::any_of(comparison.rows.begin(), comparison.rows.end(),
                           [&](const CompareRow& r) { return (r.*member).value_or(1) != 1; });
    };
    std::vector<Column> all;
    all.push_back({named("method"), [](const CompareRow& r) { return r.method; }});
    all.push_back({named("dt"), [](const CompareRow& r) { return r.dt ? step_text(*r.dt) : "-"; }});
    if (several(&CompareRow::substeps))
        all.push_back({named("substeps"), [=](const CompareRow& r) { return number(r.substeps); }});
    if (several(&CompareRow::passes))
        all.push_back({named("passes"), [=](const CompareRow& r) { return number(r.passes); }});
    for (const char* name : {"order", "integrator", "impact"})
        if (differs(comparison, name)) all.push_back({named(name), [=](const CompareRow& r) { return word(name, r); }});
    all.push_back({named("position_max"), [](const CompareRow& r) { return figure(r.position_max); }});
    all.push_back({"within " + study::length_text(comparison.tolerance, units.length),
                   [&](const CompareRow& r) {
                       return !r.position_max ? "-" : *r.position_max <= comparison.tolerance ? "yes" : "no";
                   },
                   false});
    all.push_back(
        {named("position_final_max"), [](const CompareRow& r) { return figure(r.position_final_max); }, false});
    all.push_back({named("energy_error"), [](const CompareRow& r) { return figure(r.energy_error); }, false});
    all.push_back({named("max_penetration"), [](const CompareRow& r) { return figure(r.max_penetration); }});
    all.push_back({named("overlap_left"), [](const CompareRow& r) { return figure(r.overlap_left); }, false});
    all.push_back({named("audited"),
                   [](const CompareRow& r) { return r.audit ? std::to_string(r.audit->audited) : "-"; }, false});
    all.push_back(
        {named("found"), [](const CompareRow& r) { return share_with_interval(r.audit, &Audit::found); }, false});
    for (const auto& [name, part] :
         {std::pair("late", &Audit::late), std::pair("missed", &Audit::missed), std::pair("wrong", &Audit::wrong)})
        all.push_back({named(name), [part](const CompareRow& r) { return share_cell(r.audit, part); }, false});
    all.push_back({named("invented"),
                   [](const CompareRow& r) { return share_cell(r.audit, &Audit::invented, &Audit::looked_at); },
                   false});
    all.push_back({named("crowded"),
                   [](const CompareRow& r) { return r.audit && r.dt ? std::to_string(r.audit->crowded) : "-"; },
                   false});
    all.push_back({named("missed_impacts"),
                   [](const CompareRow& r) {
                       return never_judged(r)
                                  ? "-"
                                  : fmt::format("{}/{}", r.missed_impacts - r.mistimed_impacts, r.reference_impacts);
                   },
                   false});
    all.push_back({named("invented_impacts"),
                   [](const CompareRow& r) {
                       return never_judged(r) && r.invented_impacts == 0 ? "-" : std::to_string(r.invented_impacts);
                   },
                   false});
    all.push_back({named("absorbed"),
                   [](const CompareRow& r) { return r.absorbed_impacts ? std::to_string(*r.absorbed_impacts) : "-"; },
                   false});
    all.push_back({named("rest_jitter"), [](const CompareRow& r) { return figure(r.rest_jitter); }, false});
    all.push_back({named("divergence_time"),
                   [](const CompareRow& r) { return r.divergence_time ? time_text(*r.divergence_time, "") : "-"; },
                   false});
    all.push_back({named("cpu_seconds"), [](const CompareRow& r) { return seconds_text(r.cpu_seconds); }});
    all.push_back({"x event",
                   [&](const CompareRow& r) {
                       const auto ratio = study::cost_ratio(comparison, r);
                       return ratio ? study::ratio_text(*ratio) : "-";
                   },
                   false});
    all.push_back({named("status"), status_text});
    return all;
}

/// A line for each engine that is none of carom's: what was set.
std::string peer_lines(const Comparison& comparison)
{
    std::string text;
    std::set<std::string> told;
    for (const CompareRow& row : comparison.rows)
        if (!row.peer_settings.value_or("").empty() && told.insert(row.method).second)
            text += fmt::format("{}: {}\n", row.method, *row.peer_settings);
    return text;
}

std::string head(const Scene& scene, const Comparison& comparison)
{
    const ReferenceSummary& reference = comparison.reference;
    const std::string& unit = scene.units.length;
    std::string text =
        fmt::format("{}: {}, to t = {}\n", scene.name, bodies(scene), with_unit(comparison.until, scene.units.time));
    text += fmt::format("Reference: {}, bound {}", reference.kind, study::length_text(reference.bound, unit));
    if (reference.until < comparison.until)
        text += fmt::format("; it ends at t = {}, errors and impacts are counted up to there\n  ({})",
                            time_text(reference.until, scene.units.time), reference.reason);
    text += "\nTolerance: position error " + study::length_text(comparison.tolerance, unit);
    if (const double radius = smallest_radius(scene); radius > 0)
        text += " (" + study::two_digits(comparison.tolerance / radius) + " of the smallest radius" +
                (comparison.is_default_tolerance ? "; --tolerance changes it)" : ")");
    return text + "\n" + audit_line(comparison) + peer_lines(comparison);
}

}  // namespace

std::string compare_table(const Scene& scene, const Comparison& comparison)
{
    std::vector<std::vector<std::string>> lines(comparison.rows.size() + 1);
    for (const Column& column : columns(scene, comparison)) {
        std::vector<std::string> cells{column.title};
        for (const CompareRow& row : comparison.rows) cells.push_back(column.cell(row));
        const bool empty = std::all_of(cells.begin() + 1, cells.end(), [](const auto& cell) { return cell == "-"; });
        if (empty && !column.always) continue;
        for (std::size_t i = 0; i < cells.size(); ++i) lines[i].push_back(cells[i]);
    }
    std::string text = head(scene, comparison) + "\n" + aligned(lines, 2) + "\n" + search_table(scene, comparison) +
                       compare_legend + "\n";
    for (const std::string& sentence : comparison.verdict) text += sentence + "\n";
    return text;
}

}  // namespace carom::cli
