#include "cli/tables.hpp"

#include "study/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace carom::cli {

namespace {

using study::seconds_text;
using study::step_text;
using study::two_digits;

std::string with_unit(double value, const std::string& unit)
{
    return fmt::format("{:.10g}{}{}", value, unit.empty() ? "" : " ", unit);
}

std::string figure(const std::optional<double>& value)
{
    if (!value) return "-";
    return std::isfinite(*value) ? two_digits(*value) : "inf";
}

std::string per_speed(const Units& units)
{
    return units.length.empty() || units.time.empty() ? "" : units.length + "/" + units.time;
}

std::string counted(std::size_t n, const char* what)
{
    return fmt::format("{} {}{}", n, what, n == 1 ? "" : "s");
}

std::string bodies(const Scene& scene)
{
    return counted(scene.spheres.size(), "sphere") + ", " + counted(scene.planes.size(), "plane");
}

using Lines = std::vector<std::vector<std::string>>;

void add_rest_times(const Scene& scene, const Outcome& outcome, Lines& lines)
{
    constexpr std::size_t most = 10;
    std::size_t listed = 0;
    for (std::size_t i = 0; i < outcome.rest_times.size(); ++i) {
        if (!outcome.rest_times[i]) continue;
        if (++listed > most) continue;
        lines.push_back({"rest time", scene.spheres[i].id + " " + with_unit(*outcome.rest_times[i], scene.units.time)});
    }
    if (listed > most) lines.push_back({"", fmt::format("and {} more", listed - most)});
}

}  // namespace

std::string aligned(const std::vector<std::vector<std::string>>& rows, std::size_t left)
{
    std::vector<std::size_t> widths;
    for (const auto& row : rows) {
        widths.resize(std::max(widths.size(), row.size()));
        for (std::size_t c = 0; c < row.size(); ++c) widths[c] = std::max(widths[c], row[c].size());
    }
    std::string text;
    for (const auto& row : rows) {
        std::string line;
        for (std::size_t c = 0; c < row.size(); ++c) {
            if (c > 0) line += "  ";
            line += c < left ? fmt::format("{:<{}}", row[c], widths[c]) : fmt::format("{:>{}}", row[c], widths[c]);
        }
        line.erase(line.find_last_not_of(' ') + 1);
        text += line + "\n";
    }
    return text;
}

std::string run_table(const Scene& scene, const RunStudy& run)
{
    const Outcome& outcome = run.outcome;
    const Units& units = scene.units;
    Lines lines;
    lines.push_back({"scene", fmt::format("{} ({})", scene.name, bodies(scene))});
    lines.push_back({"method", run.method + (outcome.kernel.empty() ? "" : " (kernel " + outcome.kernel + ")")});
    lines.push_back({"status", name(outcome.status) + (outcome.message.empty() ? "" : ": " + outcome.message)});
    lines.push_back({"time", with_unit(outcome.time, units.time)});
    lines.push_back({"impacts", fmt::format("{}", outcome.counts.impacts)});
    lines.push_back({"rests", fmt::format("{}", outcome.counts.rests)});
    add_rest_times(scene, outcome, lines);
    lines.push_back({"energy", fmt::format("{:.10g} -> {:.10g}", run.initial_energy, run.final_energy)});
    lines.push_back({"energy drift", run.max_relative_drift ? figure(run.max_relative_drift)
                                                            : std::string("- (contacts take energy)")});
    lines.push_back({"max penetration", study::length_text(run.max_penetration, units.length)});
    if (run.escaped > 0) lines.push_back({"escaped", fmt::format("{}", run.escaped)});
    lines.push_back({"CPU time", seconds_text(run.cpu_seconds)});
    return aligned(lines, 2);
}

std::string check_table(const Scene& scene, const std::string& name, const CheckReport& report)
{
    const Outcome& outcome = report.run.study.outcome;
    std::int64_t held = 0;
    std::string misses;
    Lines lines{{"  check", "", "error", "allowed"}};
    for (const CheckResult& each : report.results) {
        lines.push_back({"  " + each.what, carom::name(each.verdict), figure(each.error), figure(each.tolerance)});
        if (each.verdict == CheckVerdict::holds)
            ++held;
        else
            misses += fmt::format("  {}: {}: {}\n", carom::name(each.verdict), each.what, each.message);
    }
    if (report.results.empty()) lines.clear();
    std::string head = fmt::format("{} ({}): {} of {} checks hold", name, scene.name, held, report.results.size());
    if (outcome.status != Status::reached_end)
        head += fmt::format(", ended {} at t = {:.10g}", carom::name(outcome.status), outcome.time);
    return head + "\n" + aligned(lines, 2) + misses;
}

std::string compare_table(const Scene& scene, const Comparison& comparison)
{
    const ReferenceSummary& reference = comparison.reference;
    const std::string& unit = scene.units.length;
    std::string text =
        fmt::format("{}: {}, to t = {}\n", scene.name, bodies(scene), with_unit(comparison.until, scene.units.time));
    text += fmt::format("Reference: {}, bound {}{}\n\n", reference.kind, study::length_text(reference.bound, unit),
                        reference.until < comparison.until
                            ? fmt::format(", up to t = {:.6g} ({})", reference.until, reference.reason)
                            : "");
    const auto event =
        std::find_if(comparison.rows.begin(), comparison.rows.end(), [](const CompareRow& r) { return !r.dt; });
    const auto several = [&](std::optional<int> CompareRow::*member) {
        return std::any_of(comparison.rows.begin(), comparison.rows.end(),
                           [&](const CompareRow& r) { return (r.*member).value_or(1) != 1; });
    };
    const bool substeps = several(&CompareRow::substeps), passes = several(&CompareRow::passes);
    std::vector<std::string> head{"method", "dt"};
    if (substeps) head.push_back("substeps");
    if (passes) head.push_back("passes");
    const std::string of_length = unit.empty() ? "" : " [" + unit + "]";
    const std::string speed = per_speed(scene.units);
    for (const std::string& title :
         {std::string("CPU"), std::string("x event"), "max error" + of_length, "at end" + of_length,
          std::string("energy err"), "overlap" + of_length, std::string("missed"), std::string("invented"),
          "jitter" + (speed.empty() ? "" : " [" + speed + "]"), std::string("diverges"), std::string("status")})
        head.push_back(title);
    Lines lines{head};
    for (const CompareRow& row : comparison.rows) {
        std::vector<std::string> line{row.method, row.dt ? step_text(*row.dt) : "-"};
        if (substeps) line.push_back(row.substeps ? std::to_string(*row.substeps) : "-");
        if (passes) line.push_back(row.passes ? std::to_string(*row.passes) : "-");
        line.push_back(seconds_text(row.cpu_seconds));
        line.push_back(event != comparison.rows.end() && event->cpu_seconds > 0
                           ? two_digits(row.cpu_seconds / event->cpu_seconds)
                           : "-");
        line.push_back(figure(row.position_max));
        line.push_back(figure(row.position_final_max));
        line.push_back(figure(row.energy_error));
        line.push_back(figure(row.max_penetration));
        line.push_back(fmt::format("{}/{}", row.missed_impacts, row.reference_impacts));
        line.push_back(std::to_string(row.invented_impacts));
        line.push_back(figure(row.rest_jitter));
        line.push_back(row.divergence_time ? fmt::format("{:.3g}", *row.divergence_time) : "-");
        line.push_back(name(row.status));
        lines.push_back(std::move(line));
    }
    text += aligned(lines, 2) + "\n";
    for (const std::string& sentence : comparison.verdict) text += sentence + "\n";
    return text;
}

}  // namespace carom::cli
