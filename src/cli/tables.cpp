#include "cli/tables.hpp"

#include "cli/limits.hpp"

#include "study/words.hpp"

#include <carom/metrics.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>

namespace carom::cli {

namespace {

using study::seconds_text;
using study::three_digits;

using Lines = std::vector<std::vector<std::string>>;

void add_rest_times(const Scene& scene, const Outcome& outcome, Lines& lines)
{
    std::size_t listed = 0;
    for (std::size_t i = 0; i < outcome.rest_times.size(); ++i) {
        if (!outcome.rest_times[i]) continue;
        if (++listed > most_listed_bodies) continue;
        const bool slides = i < outcome.final.size() && outcome.final[i].mode == Mode::sliding;
        lines.push_back({slides ? "slides since" : "rest time",
                         scene.spheres[i].id + " " + with_unit(*outcome.rest_times[i], scene.units.time)});
    }
    if (listed > most_listed_bodies) lines.push_back({"", fmt::format("and {} more", listed - most_listed_bodies)});
}

/// Shares of motion without closed form, and the energy and the time that thresholds took; no line where there is none.
void add_thresholds(const Scene& scene, const Outcome& outcome, Lines& lines)
{
    const BodyTimes& times = outcome.body_seconds;
    const double all = times.closed_form + times.numeric + times.guarded;
    if (outcome.counts.numeric_steps > 0)
        lines.push_back({"numeric", fmt::format("{} steps of clusters, {:.3g} % of all body-seconds",
                                                outcome.counts.numeric_steps, 100 * times.numeric / all)});
    if (outcome.counts.capped > 0)
        lines.push_back({"capped", fmt::format("impact operator met its bound at {} instants: inelastic instead",
                                               outcome.counts.capped)});
    if (outcome.counts.guarded > 0)
        lines.push_back({"guarded", fmt::format("{} windows, {:.3g} % of all body-seconds", outcome.counts.guarded,
                                                100 * times.guarded / all)});
    if (outcome.early_rest)
        lines.push_back(
            {"early rest",
             fmt::format("{} times a sphere alone on another or on a plane, whose bounces would be too many; {} by {} "
                         "at most",
                         outcome.counts.early_rests, scene.body_name(outcome.early_rest->body),
                         with_unit(outcome.early_rest->time, scene.units.time))});
    const EnergyTaken& taken = outcome.energy_taken;
    std::string text;
    for (const auto& [name, energy] : {std::pair{"slow closings", taken.closing},
                                       {"settling", taken.settling},
                                       {"numeric steps", taken.stabilising},
                                       {"guard", taken.guard},
                                       {"windows", taken.window},
                                       {"capped impacts", taken.capped}})
        if (energy != 0) text += fmt::format("{}{} {:.3g}", text.empty() ? "" : ", ", name, energy);
    if (!text.empty()) lines.push_back({"energy taken", text});
}

/// Where and how fast a few spheres ended.
void add_final(const Scene& scene, const Outcome& outcome, Lines& lines)
{
    if (outcome.final.size() > most_listed_bodies) return;
    const auto vector = [](const Vec3& v) { return fmt::format("({:.7g}, {:.7g}, {:.7g})", v[0], v[1], v[2]); };
    for (std::size_t i = 0; i < outcome.final.size(); ++i) {
        const BodyState& state = outcome.final[i];
        const bool still = state.velocity == Vec3::Zero();
        lines.push_back({i == 0 ? "final" : "",
                         fmt::format("{} at {}{}{}", scene.spheres[i].id, vector(scene.origin + state.position),
                                     still ? "" : ", velocity " + vector(state.velocity),
                                     state.mode == Mode::flying ? "" : std::string(", ") + name(state.mode))});
    }
}

/// Contacts and flights keep energy or take it; what makes some is wrong.
std::string drift_text(const RunStudy& run)
{
    const double gain = run.final_energy + run.drag_energy.value_or(0) - run.initial_energy;
    if (!std::isfinite(gain)) return "BLEW UP: no longer a finite number";
    if (gain > energy_rounding * run.max_kinetic_energy)
        return fmt::format("GREW by {:.4g} ({})", gain,
                           run.lifts.empty() ? "no contact gives energy: this run is wrong"
                                             : "spheres were lifted out of planes in which they began");
    if (run.max_relative_drift) return figure(run.max_relative_drift);
    return run.drag_energy ? "- (contacts take energy)" : "- (drag takes energy)";
}

std::string escaped_text(const Scene& scene, const RunStudy& run)
{
    std::string names;
    for (std::size_t i = 0;
         i < run.outcome.final.size() && run.escaped <= static_cast<std::int64_t>(most_listed_bodies); ++i)
        if (escaped(scene, std::span(&run.outcome.final[i], 1)) > 0)
            names += (names.empty() ? ": " : ", ") + scene.spheres[i].id;
    return fmt::format("{} behind a plane or nowhere{}", run.escaped, names);
}

}  // namespace

std::string figure(const std::optional<double>& value)
{
    if (!value) return "-";
    return std::isfinite(*value) ? three_digits(*value) : "inf";
}

std::string counted(std::size_t n, const char* what)
{
    return fmt::format("{} {}{}", n, what, n == 1 ? "" : "s");
}

std::string bodies(const Scene& scene)
{
    return counted(scene.spheres.size(), "sphere") + ", " + counted(scene.planes.size(), "plane");
}

std::string with_unit(double value, const std::string& unit)
{
    return fmt::format("{:.10g}{}{}", value, unit.empty() ? "" : " ", unit);
}

std::string unresolved_advice(const Outcome& outcome)
{
    // Rounded down to three digits, so that a run to there ends before.
    if (outcome.status != Status::unresolved || !(outcome.time > 0)) return "";
    const double unit = std::pow(10.0, std::floor(std::log10(outcome.time)) - 2);
    double before = std::floor(outcome.time / unit) * unit;
    if (before >= outcome.time) before -= unit;
    return fmt::format(
        "what was computed up to there is valid: --until {:.4g} ends the run before it, or keep these bodies from "
        "meeting at one instant",
        before);
}

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

std::string clock_text(const io::CommandFacts& command, double part_cpu_seconds, const std::string& part)
{
    return fmt::format("{} for the whole command (CPU {}), of it {} of CPU for {}", seconds_text(command.seconds),
                       seconds_text(command.cpu_seconds), seconds_text(part_cpu_seconds), part);
}

std::string run_table(const Scene& scene, const RunStudy& run, const io::CommandFacts& command)
{
    const Outcome& outcome = run.outcome;
    const Units& units = scene.units;
    Lines lines;
    lines.push_back({"scene", fmt::format("{} ({})", scene.name, bodies(scene))});
    lines.push_back({"method", run.method + (outcome.kernel.empty() ? "" : " (kernel " + outcome.kernel + ")")});
    lines.push_back({"status", name(outcome.status) + (outcome.message.empty() ? "" : ": " + outcome.message)});
    lines.push_back({"time", with_unit(outcome.time, units.time)});
    const Counts& counts = outcome.counts;
    lines.push_back({"impacts", fmt::format("{}", counts.impacts)});
    if (counts.clusters > 0)
        lines.push_back({"clusters", fmt::format("impacts of several contacts at {} instants", counts.clusters)});
    lines.push_back({"rests", fmt::format("{}", counts.rests)});
    if (counts.releases > 0) lines.push_back({"releases", fmt::format("{}", counts.releases)});
    add_thresholds(scene, outcome, lines);
    add_rest_times(scene, outcome, lines);
    lines.push_back({"energy", fmt::format("{:.10g} -> {:.10g}", run.initial_energy, run.final_energy)});
    if (scene.drag > 0 && run.drag_energy) lines.push_back({"taken by drag", fmt::format("{:.10g}", *run.drag_energy)});
    lines.push_back({"energy drift", drift_text(run)});
    lines.push_back({"max penetration", study::length_text(run.max_penetration, units.length)});
    if (run.escaped > 0) lines.push_back({"escaped", escaped_text(scene, run)});
    add_final(scene, outcome, lines);
    lines.push_back({"clock", clock_text(command, run.cpu_seconds, "the engine")});
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

}  // namespace carom::cli
