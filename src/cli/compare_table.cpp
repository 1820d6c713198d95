#include "cli/tables.hpp"

#include "study/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

namespace carom::cli {

const char* const compare_legend =
    "max error: farthest that a sphere is from the reference at any of 200 sample times; at end: at the last of them\n"
    "energy err: most that the energy is off at a sample time, of the reference's largest kinetic energy\n"
    "overlap: deepest, for a stepper before it corrects; jitter: rms speed of what rests in the reference\n"
    "late: impacts that come more than 3 steps early or late; missed: that never come (compare.csv adds the two)\n"
    "invented: impacts that the reference does not have within 3 steps, the late ones among them\n"
    "diverges: when a sphere is first off by 0.01 of the smallest radius; impacts are counted up to then\n"
    "CPU: median of the repeats; x event: that over the event run's\n";

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

std::string bracketed(const std::string& unit)
{
    return unit.empty() ? "" : " [" + unit + "]";
}

/// Impacts are counted while run and reference agree. A run that parts from it before the first one has none to miss,
/// and so has one whose reference ends at the start.
bool never_judged(const CompareRow& row)
{
    return (row.divergence_time || !row.position_max) && row.reference_impacts == 0;
}

std::string status_text(const CompareRow& row)
{
    const std::string status = name(row.status);
    return row.status == Status::reached_end ? status : status + " at " + time_text(row.time, "");
}

std::vector<Column> columns(const Scene& scene, const Comparison& comparison)
{
    const Units& units = scene.units;
    const std::string length = bracketed(units.length);
    const std::string speed =
        units.length.empty() || units.time.empty() ? "" : bracketed(units.length + "/" + units.time);
    const auto number = [](const std::optional<int>& value) { return value ? std::to_string(*value) : "-"; };
    const auto several = [&](std::optional<int> CompareRow::*member) {
        return std::any_of(comparison.rows.begin(), comparison.rows.end(),
                           [&](const CompareRow& r) { return (r.*member).value_or(1) != 1; });
    };
    const auto event =
        std::find_if(comparison.rows.begin(), comparison.rows.end(), [](const CompareRow& r) { return !r.dt; });
    // A run that stopped early is no measure of what going to the end costs.
    const double unit_cost =
        event != comparison.rows.end() && event->status == Status::reached_end ? event->cpu_seconds : 0;

    std::vector<Column> all;
    all.push_back({"method", [](const CompareRow& r) { return r.method; }});
    all.push_back({"dt", [](const CompareRow& r) { return r.dt ? step_text(*r.dt) : "-"; }});
    if (several(&CompareRow::substeps))
        all.push_back({"substeps", [=](const CompareRow& r) { return number(r.substeps); }});
    if (several(&CompareRow::passes)) all.push_back({"passes", [=](const CompareRow& r) { return number(r.passes); }});
    all.push_back({"max error" + length, [](const CompareRow& r) { return figure(r.position_max); }});
    all.push_back({"within " + study::length_text(comparison.tolerance, units.length),
                   [&](const CompareRow& r) {
                       return !r.position_max ? "-" : *r.position_max <= comparison.tolerance ? "yes" : "no";
                   },
                   false});
    all.push_back({"at end" + length, [](const CompareRow& r) { return figure(r.position_final_max); }, false});
    all.push_back({"energy err", [](const CompareRow& r) { return figure(r.energy_error); }, false});
    all.push_back({"overlap" + length, [](const CompareRow& r) { return figure(r.max_penetration); }});
    all.push_back({"late",
                   [](const CompareRow& r) { return never_judged(r) ? "-" : std::to_string(r.mistimed_impacts); },
                   false});
    all.push_back({"missed",
                   [](const CompareRow& r) {
                       return never_judged(r)
                                  ? "-"
                                  : fmt::format("{}/{}", r.missed_impacts - r.mistimed_impacts, r.reference_impacts);
                   },
                   false});
    all.push_back({"invented",
                   [](const CompareRow& r) {
                       return never_judged(r) && r.invented_impacts == 0 ? "-" : std::to_string(r.invented_impacts);
                   },
                   false});
    all.push_back({"jitter" + speed, [](const CompareRow& r) { return figure(r.rest_jitter); }, false});
    all.push_back({"diverges",
                   [](const CompareRow& r) { return r.divergence_time ? time_text(*r.divergence_time, "") : "-"; },
                   false});
    all.push_back({"CPU", [](const CompareRow& r) { return seconds_text(r.cpu_seconds); }});
    all.push_back(
        {"x event",
         [=](const CompareRow& r) { return unit_cost > 0 ? study::two_digits(r.cpu_seconds / unit_cost) : "-"; },
         false});
    all.push_back({"status", status_text});
    return all;
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
        text += " (" + study::two_digits(comparison.tolerance / radius) +
                " of the smallest radius; --tolerance changes it)";
    return text + "\n";
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
    std::string text = head(scene, comparison) + "\n" + aligned(lines, 2) + "\n" + compare_legend + "\n";
    for (const std::string& sentence : comparison.verdict) text += sentence + "\n";
    return text;
}

}  // namespace carom::cli
