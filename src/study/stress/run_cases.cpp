#include "study/clock.hpp"
#include "study/stress/case.hpp"
#include "study/words.hpp"

#include <carom/error.hpp>
#include <carom/method.hpp>

#include <algorithm>

namespace carom::stress {

namespace {

std::vector<Case> all_cases()
{
    std::vector<Case> all;
    for (const auto& group :
         {ratio_cases(), magnitude_cases(), place_cases(), contact_cases(), series_cases(), long_cases()})
        all.insert(all.end(), group.begin(), group.end());
    return all;
}

bool is_exact(std::string_view method)
{
    return method == method_names().front();
}

std::string at_most(double limit)
{
    return limit > 0 ? "at most " + study::two_digits(limit) : "0";
}

std::string rule_of(const Case& c)
{
    std::string rule = "the figure is " + at_most(c.limit);
    if (c.exact_limit != c.limit) rule += "; for event, which claims to be exact, " + at_most(c.exact_limit);
    return rule;
}

Result judge(const Case& c, const std::string& method, Patience& patience)
{
    study::Stopwatch watch;
    const Evidence evidence = c.measure(method, patience);
    watch.pause();
    Result result{.method = method, .figure = evidence.figure, .worst = evidence.worst};
    result.limit = is_exact(method) ? c.exact_limit : c.limit;
    result.symptom = diagnose(evidence, result.limit);
    result.passed = result.symptom == Symptom::none;
    result.reason = explain(c, evidence, result.symptom);
    result.seconds = watch.cpu();
    return result;
}

std::vector<Case> chosen(const std::optional<std::string>& only)
{
    std::vector<Case> cases = all_cases();
    if (!only) return cases;
    std::erase_if(cases, [&](const Case& c) { return c.name != *only; });
    if (!cases.empty()) return cases;
    std::string known;
    for (const std::string& each : case_names()) known += (known.empty() ? "" : ", ") + each;
    throw InputError({"unknown case \"" + *only + "\" (take " + known + ")"});
}

}  // namespace

std::vector<std::string> case_names()
{
    std::vector<std::string> names;
    for (const Case& c : all_cases()) names.push_back(c.name);
    return names;
}

bool Report::event_passes() const
{
    return std::all_of(cases.begin(), cases.end(), [](const CaseResult& c) {
        return std::all_of(c.results.begin(), c.results.end(),
                           [](const Result& r) { return r.passed || !is_exact(r.method); });
    });
}

Report run_cases(const Options& options)
{
    Report report;
    report.methods = options.methods.empty() ? method_names() : options.methods;
    for (const std::string& method : report.methods) make_method(method);  // throws for unknown ones
    const std::vector<Case> cases = chosen(options.only);
    Patience patience(options.on_progress);
    patience.begin("stress", static_cast<double>(cases.size() * report.methods.size()), "runs");
    double done = 0;
    for (const Case& c : cases) {
        CaseResult row{c.name, c.title, c.about, c.figure, rule_of(c), c.step, {}};
        for (const std::string& method : report.methods) {
            patience.name(c.name + ", " + method);
            if (patience.lasts(done)) row.results.push_back(judge(c, method, patience));
            if (patience.ended()) {
                report.interrupted = true;
                return report;
            }
            ++done;
        }
        report.cases.push_back(std::move(row));
    }
    return report;
}

}  // namespace carom::stress
