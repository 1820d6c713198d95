#include "cli/tables.hpp"
#include "report/stress_page.hpp"
#include "study/words.hpp"

#include <fmt/format.h>

#include <cmath>
#include <map>

namespace carom::cli {

namespace {

std::string cell(const stress::Result& result)
{
    const double figure = result.figure();
    return (result.passed() ? "pass " : "FAIL ") + (std::isfinite(figure) ? study::two_digits(figure) : "inf");
}

std::string explanation(const stress::Case& c)
{
    std::string text = fmt::format("{} ({})\n  {}\n  figure: {}\n  passed if {}\n  step: {}\n", c.words.title,
                                   c.words.case_name, c.about, c.words.figure, c.rule(), c.words.step);
    if (!c.is_required()) text += fmt::format("  waits for {}: run and shown, not required\n", c.words.waits_for);
    std::map<std::string, std::string> who;  // fails for a reason
    for (const stress::Result& r : c.results)
        if (!r.passed()) who[r.reason] += (who[r.reason].empty() ? "" : ", ") + r.method;
    for (const auto& [reason, methods] : who) text += fmt::format("  {}: {}\n", methods, reason);
    return text;
}

}  // namespace

std::string stress_table(const stress::Report& report)
{
    std::vector<std::vector<std::string>> rows{{"case"}};
    rows[0].insert(rows[0].end(), report.methods.begin(), report.methods.end());
    const bool is_list = report.methods.empty();
    if (is_list) rows[0].insert(rows[0].end(), {"what", "runs"});
    for (const stress::Case& c : report.cases) {
        std::vector<std::string> row{c.words.case_name + (c.is_required() ? "" : " (waits)")};
        for (const stress::Result& result : c.results) row.push_back(cell(result));
        if (is_list) row.insert(row.end(), {c.words.title, std::to_string(c.trials.size())});
        rows.push_back(std::move(row));
    }
    std::string text = aligned(rows, is_list ? 2 : rows[0].size()) + "\n";
    for (const stress::Case& c : report.cases) text += is_list ? "" : explanation(c) + "\n";
    for (const std::string& sentence : report::stress_verdict(report)) text += sentence + "\n";
    return text;
}

}  // namespace carom::cli
