#include "core/names.hpp"
#include "study/tolerances.hpp"
#include "study/words.hpp"
#include "tunnel/summary.hpp"

#include <algorithm>

namespace carom::tunnel {

namespace {

struct Total {
    std::string who;  ///< method, and integrator where there are rows of both
    std::string method;
    std::int64_t trials = 0, tunnelled = 0, wrong = 0;
    std::string from;  ///< "plates from v dt = 1.02 reach on"
};

std::vector<Total> totals(const Report& report)
{
    std::vector<Total> all;
    for (const Summary& sum : summaries(report)) {
        auto total = std::find_if(all.begin(), all.end(), [&](const Total& t) { return t.who == sum.who; });
        if (total == all.end()) {
            total = all.insert(all.end(), Total{});
            total->who = sum.who;
            total->method = sum.method;
        }
        total->trials += sum.trials;
        total->tunnelled += sum.tunnelled;
        total->wrong += sum.wrong;
        if (sum.tunnels_from &&
            total->from.find(target_names[static_cast<std::size_t>(sum.target)]) == std::string::npos)
            total->from += (total->from.empty() ? "" : ", ") +
                           std::string(target_names[static_cast<std::size_t>(sum.target)]) + "s from " +
                           study::three_digits(*sum.tunnels_from);
    }
    return all;
}

/// "12 %"; what rounds to nothing or all is said so.
std::string percent(std::int64_t part, std::int64_t whole)
{
    if (part == 0) return "none";
    if (part == whole) return "all";
    const std::string text =
        study::two_digits(study::per_cent * static_cast<double>(part) / static_cast<double>(whole));
    return text == "100" ? "nearly all" : text + " %";
}

std::string on_event(const Total& total)
{
    const std::string throws = std::to_string(total.trials) + " throws";
    if (total.tunnelled + total.wrong == 0)
        return "event hits in every one of " + throws + ": none tunnelled, none was answered late or wrongly.";
    return "event fails: of " + throws + " " + std::to_string(total.tunnelled) + " tunnelled, " +
           std::to_string(total.wrong) + " were answered late or wrongly.";
}

std::string fate_of(const Total& total)
{
    std::string text = percent(total.tunnelled, total.trials) + " of the throws tunnelled";
    if (!total.from.empty()) text += " (" + total.from + " on)";
    return text + ", " + percent(total.wrong, total.trials) + " were answered late or with another velocity.";
}

/// Methods of one fate share a sentence.
std::vector<std::string> on_others(const std::vector<Total>& all)
{
    std::vector<std::pair<std::string, std::string>> sentences;  // fate, methods
    for (const Total& total : all) {
        if (total.trials == 0 || total.method == method_names().front()) continue;
        const std::string fate = fate_of(total);
        const auto same =
            std::find_if(sentences.begin(), sentences.end(), [&](const auto& s) { return s.first == fate; });
        if (same == sentences.end())
            sentences.emplace_back(fate, total.who);
        else
            same->second += "; " + total.who;
    }
    std::vector<std::string> texts;
    for (const auto& [fate, methods] : sentences) texts.push_back(methods + ": " + fate);
    return texts;
}

}  // namespace

std::vector<std::string> verdict(const Report& report)
{
    const std::vector<Total> all = totals(report);
    std::vector<std::string> sentences = on_others(all);
    for (const Total& total : all)
        if (total.trials > 0 && total.method == method_names().front())
            sentences.insert(sentences.begin(), on_event(total));
    const bool some_tunnel =
        std::any_of(report.rows.begin(), report.rows.end(), [](const Row& row) { return row.tunnelled > 0; });
    if (some_tunnel)
        sentences.push_back(
            "Where methods begin to tunnel is told in v dt / (radius + thickness/2), on which alone the share "
            "depends.");
    for (const EngineSettings& each : report.engines) sentences.push_back(each.name + " is " + each.words + ".");
    for (const Absence& each : report.absent) sentences.push_back("Absent: " + each.name + ", " + each.reason + ".");
    return sentences;
}

}  // namespace carom::tunnel
