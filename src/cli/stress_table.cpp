#include "cli/tables.hpp"
#include "study/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace carom::cli {

namespace {

std::string cell(const stress::Result& result)
{
    const double figure = result.evidence.figure;
    return (result.passed() ? "pass " : "FAIL ") + (std::isfinite(figure) ? study::two_digits(figure) : "inf");
}

std::string explanation(const stress::Case& c)
{
    std::string text = fmt::format("{} ({})\n  {}\n  figure: {}\n  passed if {}\n  step: {}\n", c.words.title,
                                   c.words.case_name, c.about, c.words.figure, c.rule(), c.words.step);
    // Methods that fail in the same words share a line.
    std::vector<std::pair<std::string, std::string>> lines;
    for (const stress::Result& r : c.results) {
        if (r.passed()) continue;
        const auto same =
            std::find_if(lines.begin(), lines.end(), [&](const auto& line) { return line.second == r.reason; });
        if (same == lines.end())
            lines.emplace_back(r.method, r.reason);
        else
            same->first += ", " + r.method;
    }
    for (const auto& [methods, reason] : lines) text += fmt::format("  {}: {}\n", methods, reason);
    return text;
}

}  // namespace

std::string stress_table(const stress::Report& report)
{
    std::vector<std::vector<std::string>> rows{{"case"}};
    for (const std::string& method : report.methods) rows[0].push_back(method);
    for (const stress::Case& c : report.cases) {
        std::vector<std::string> row{c.words.case_name};
        for (const stress::Result& result : c.results) row.push_back(cell(result));
        rows.push_back(std::move(row));
    }
    std::string text = aligned(rows, report.methods.size() + 1) + "\n";
    for (const stress::Case& c : report.cases) text += explanation(c) + "\n";
    std::vector<std::string> verdicts;
    for (std::size_t m = 0; m < report.methods.size(); ++m) {
        const auto passed = std::count_if(report.cases.begin(), report.cases.end(),
                                          [&](const stress::Case& c) { return c.results[m].passed(); });
        verdicts.push_back(fmt::format("{} passes {} of {}", report.methods[m], passed, report.cases.size()));
    }
    return text + fmt::format("{}.\n", fmt::join(verdicts, ", "));
}

}  // namespace carom::cli
