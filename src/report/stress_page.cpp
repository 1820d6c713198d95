#include "report/stress_page.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace carom::report {

namespace {

using Json = nlohmann::ordered_json;

struct Tally {
    std::size_t passed = 0, of = 0;
};

Tally required(const stress::Report& report, std::size_t contestant)
{
    Tally tally;
    for (const stress::Case& each : report.cases) {
        if (!each.is_required()) continue;
        ++tally.of;
        if (each.results[contestant].passed()) ++tally.passed;
    }
    return tally;
}

}  // namespace

std::vector<std::string> stress_verdict(const stress::Report& report)
{
    std::vector<std::string> sentences, others, waiting;
    for (std::size_t m = 0; m < report.methods.size(); ++m) {
        const Tally tally = required(report, m);
        const std::string text = fmt::format("{} passes {} of {}", report.methods[m], tally.passed, tally.of);
        const bool is_exact = !report.cases.empty() && report.cases.front().results[m].is_exact;
        if (is_exact)
            sentences.push_back(text + (tally.of == 1 ? " case." : " cases."));
        else
            others.push_back(text);
    }
    if (!others.empty()) sentences.push_back(fmt::format("{}.", fmt::join(others, ", ")));
    for (const stress::Case& each : report.cases)
        if (!each.is_required()) waiting.push_back(each.words.case_name + " for " + each.words.waits_for);
    if (!waiting.empty())
        sentences.push_back(fmt::format("Not required yet, and not counted: {}.", fmt::join(waiting, "; ")));
    return sentences;
}

std::string stress_page_data(const stress::Report& report, const std::string& json, const std::string& generator)
{
    Json data = Json::parse(json);
    data["format"] = "carom-stress-page/1";
    data["generator"] = generator;
    data["verdict"] = stress_verdict(report);
    return data.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace carom::report
