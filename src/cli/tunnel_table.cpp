#include "cli/limits.hpp"
#include "cli/tables.hpp"
#include "core/names.hpp"
#include "study/words.hpp"
#include "tunnel/law.hpp"
#include "tunnel/summary.hpp"
#include "tunnel/tolerances.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace carom::cli {

namespace {

using Lines = std::vector<std::vector<std::string>>;

std::string word(tunnel::Target target)
{
    return std::string(name_of(target, tunnel::target_names));
}

std::string name_of_row(const std::string& method, const std::string& variant,
                        const std::optional<Integrator>& integrator)
{
    std::string text = method;
    if (integrator == Integrator::parabola) text += ", parabola";
    return variant.empty() ? text : text + ", " + variant;
}

std::string share_text(std::int64_t part, std::int64_t whole)
{
    return whole == 0 ? "-" : study::three_digits(static_cast<double>(part) / static_cast<double>(whole));
}

std::string each_row(const tunnel::Report& report)
{
    Lines lines{{"method", "target", "dt", "speed", "radius", "thickness", "v dt/reach", "throws", "tunnelled", "law",
                 "wrong", "worst error"}};
    for (const tunnel::Row& row : report.rows)
        lines.push_back(
            {name_of_row(row.method, row.variant, row.integrator), word(row.cell.target), study::step_text(row.cell.dt),
             study::three_digits(row.cell.speed), study::three_digits(row.cell.radius), figure(row.cell.thickness),
             study::three_digits(row.cell.number()), std::to_string(row.trials), share_text(row.tunnelled, row.trials),
             figure(row.law), share_text(row.wrong, row.trials), figure(row.worst_error)});
    return aligned(lines, 2);
}

std::string summed_up(const tunnel::Report& report)
{
    Lines lines{{"method", "target", "cells", "throws", "tunnelled", "share", "from", "off the law", "wrong",
                 "worst error / r"}};
    for (const tunnel::Summary& sum : tunnel::summaries(report))
        lines.push_back({sum.name, word(sum.target), std::to_string(sum.cells), std::to_string(sum.trials),
                         std::to_string(sum.tunnelled), share_text(sum.tunnelled, sum.trials), figure(sum.tunnels_from),
                         figure(sum.off_the_law), std::to_string(sum.wrong), figure(sum.worst_error)});
    return aligned(lines, 2) +
           "\nfrom: the lowest v dt / (radius + thickness/2) at which a throw tunnelled; off the law: the largest "
           "distance "
           "of\na share from the law, in standard deviations; tunnel.csv (-o DIR) has each cell.\n";
}

/// Critical speeds of one contestant at one kind of hit, in chords a step: they are the same for every size and step.
struct Span {
    double low = INFINITY, high = 0;
    std::size_t searches = 0, never = 0;
    bool is_below = false;      ///< some tunnel at every speed looked at
    std::optional<double> law;  ///< [chords a step]
    double worst = 0;           ///< largest distance from the law, part of it
};

using End = tunnel::CriticalSpeed::End;

/// Distance of a speed that was found from the law, part of it.
std::optional<double> off_the_law(const tunnel::Critical& critical)
{
    if (critical.speed.end != End::found || !critical.law) return {};
    return std::abs(critical.speed.speed / *critical.law - 1);
}

std::string speed_text(const tunnel::CriticalSpeed& critical)
{
    if (critical.end == End::never) return "never";
    return (critical.end == End::below ? "below " : "") + study::three_digits(critical.speed);
}

void add(Span& span, const tunnel::Critical& critical)
{
    const double unit = tunnel::chord_of(critical.cell, critical.offset) / critical.cell.dt;
    ++span.searches;
    if (critical.law) span.law = *critical.law / unit;
    if (critical.speed.end == End::never) {
        ++span.never;
        return;
    }
    span.is_below = span.is_below || critical.speed.end == End::below;
    span.low = std::min(span.low, critical.speed.speed / unit);
    span.high = std::max(span.high, critical.speed.speed / unit);
    span.worst = std::max(span.worst, off_the_law(critical).value_or(0));
}

std::string law_text(const std::optional<double>& law)
{
    if (!law) return "-";
    return std::isinf(*law) ? "never" : study::three_digits(*law);
}

std::string span_text(const Span& span)
{
    const std::string low = (span.is_below ? "below " : "") + study::three_digits(span.low);
    const std::string high = study::three_digits(span.high);
    if (span.is_below && span.low == span.high) return low;
    return low == high ? low : low + " to " + high;
}

std::string each_critical(const tunnel::Report& report)
{
    Lines lines{{"method", "target", "offset", "dt", "radius", "thickness", "critical speed", "law", "off by"}};
    for (const tunnel::Critical& each : report.criticals) {
        const std::optional<double> off = off_the_law(each);
        lines.push_back({name_of_row(each.method, each.variant, each.integrator), word(each.cell.target),
                         study::three_digits(each.offset), study::step_text(each.cell.dt),
                         study::three_digits(each.cell.radius), figure(each.cell.thickness), speed_text(each.speed),
                         law_text(each.law), off ? fmt::format("{:.2g} %", *off * per_cent) : "-"});
    }
    return "\n" + aligned(lines, 2) +
           "\ncritical speed: the lowest that tunnels, found within 1 %; law: "
           "(radius + thickness/2)/dt and its like (docs/tunnel.md).\n";
}

std::string critical_table(const tunnel::Report& report)
{
    if (report.criticals.size() <= tunnel::most_listed_rows) return each_critical(report);
    std::vector<std::pair<std::string, Span>> spans;
    for (const tunnel::Critical& each : report.criticals) {
        std::string key = name_of_row(each.method, each.variant, each.integrator) + "\t" + word(each.cell.target);
        auto found = std::find_if(spans.begin(), spans.end(), [&](const auto& span) { return span.first == key; });
        if (found == spans.end()) found = spans.insert(spans.end(), {std::move(key), Span{}});
        add(found->second, each);
    }
    Lines lines{{"method", "target", "searches", "critical speed", "law", "off by"}};
    for (const auto& [key, span] : spans) {
        const std::size_t tab = key.find('\t');
        const bool never = span.never == span.searches;
        lines.push_back({key.substr(0, tab), key.substr(tab + 1), std::to_string(span.searches),
                         never ? "never" : span_text(span), law_text(span.law),
                         never || !span.law ? "-" : fmt::format("{:.2g} %", span.worst * per_cent)});
    }
    return "\n" + aligned(lines, 2) +
           "\ncritical speed: the lowest that tunnels, in chords a step, over all sizes, offsets and steps; each was "
           "found "
           "within 1 %.\nA chord is radius + thickness/2 of a plate, sqrt((r1+r2)^2 - b^2) of a sphere hit at offset "
           "b; "
           "critical.csv (-o DIR) has each.\n";
}

}  // namespace

std::string tunnel_table(const tunnel::Report& report)
{
    std::string text = report.rows.size() <= tunnel::most_listed_rows ? each_row(report) : summed_up(report);
    if (!report.criticals.empty()) text += critical_table(report);
    text += "\n";
    for (const std::string& sentence : tunnel::verdict(report)) text += sentence + "\n";
    return text;
}

}  // namespace carom::cli
