#include "study/stress.hpp"

#include "study/clock.hpp"
#include "study/largest.hpp"
#include "study/tolerances.hpp"
#include "study/words.hpp"

#include <carom/error.hpp>

#include <algorithm>
#include <map>

namespace carom::stress {

namespace {

/// Scene, what is wrong and why, and how many others are.
std::string sentence(const StressPart& words, const Result& result)
{
    const Finding& worst = result.worst();
    if (worst.symptom == Symptom::none) return "";
    const auto failed = std::count_if(result.findings.begin(), result.findings.end(),
                                      [](const Finding& each) { return each.symptom != Symptom::none; });
    const std::string text = worst.trial + ": " + explain(words, result.method, worst.evidence, worst.symptom);
    if (failed == 1) return text;
    return text + " (" + std::to_string(failed) + " of " + std::to_string(result.findings.size()) + " scenes fail)";
}

Result judge(const Case& which, const Contestant& who, const std::function<bool()>& goes_on)
{
    study::Stopwatch watch;
    Result result{
        .method = who.name, .is_exact = who.is_exact, .limit = who.is_exact ? which.words.exact : which.words.limit};
    for (const Trial& trial : which.trials) {
        if (!goes_on()) return result;
        const Evidence evidence = evidence_of(trial.scene, who.check(trial.scene, goes_on), who.left_out);
        result.findings.push_back({trial.name, evidence, diagnose(evidence, result.limit)});
    }
    watch.pause();
    result.reason = sentence(which.words, result);
    result.seconds = watch.cpu();
    return result;
}

void take_words(StressPart& words, const StressPart& part)
{
    for (std::string StressPart::*text :
         {&StressPart::title, &StressPart::figure, &StressPart::step, &StressPart::waits_for})
        if ((words.*text).empty()) words.*text = part.*text;
    words.causes.insert(part.causes.begin(), part.causes.end());
}

}  // namespace

std::vector<Contestant> contestants(const std::vector<std::string>& methods)
{
    std::vector<Contestant> list;
    for (const std::string& name : methods.empty() ? method_names() : methods) {
        const bool is_exact = step_options(make_method(name)) == nullptr;  // throws for unknown ones
        const std::set<CheckType> left_out = is_exact ? std::set<CheckType>{} : std::set{CheckType::rest_time};
        list.push_back({name, is_exact, left_out, [=](const Scene& scene, const std::function<bool()>& goes_on) {
                            CheckOptions options{.method = make_method(name, StepOptions{.dt = scene.stress->dt})};
                            if (auto* penalty = std::get_if<Penalty>(&options.method))
                                penalty->stiffness = scene.stress->stiffness;
                            if (!is_exact || !scene.stress->waits_for.empty())
                                options.max_seconds = study::longest_stress_run;
                            options.on_progress = [&](double) { return goes_on(); };
                            return check_scene(scene, options);
                        }});
    }
    return list;
}

std::vector<Case> cases_of(const std::vector<Trial>& trials)
{
    std::map<std::string, Case> cases;
    for (const Trial& trial : trials) {
        const StressPart& part = *trial.scene.stress;
        Case& each = cases.try_emplace(part.case_name, Case{part, "", {}, {}}).first->second;
        if (each.words.exact != part.exact || each.words.limit != part.limit)
            throw InputError({"stress case \"" + part.case_name + "\": its scenes give different limits (see \"" +
                              trial.name + "\")"});
        take_words(each.words, part);
        if (each.about.find(trial.scene.description) == std::string::npos)
            each.about += (each.about.empty() ? "" : " ") + trial.scene.description;
        each.trials.push_back(trial);
    }
    std::vector<Case> list;
    for (auto& [name, each] : cases) list.push_back(std::move(each));
    return list;
}

double Result::figure() const
{
    double largest = 0;
    for (const Finding& each : findings) study::keep_largest(largest, each.evidence.figure);
    return largest;
}

const Finding& Result::worst() const
{
    // The gravest symptom is the first of its enumeration, but for `none`.
    const auto rank = [](const Finding& each) {
        return each.symptom == Symptom::none ? symptom_names.size() : static_cast<std::size_t>(each.symptom);
    };
    return *std::min_element(findings.begin(), findings.end(), [&](const Finding& a, const Finding& b) {
        return rank(a) != rank(b) ? rank(a) < rank(b) : a.evidence.figure > b.evidence.figure;
    });
}

std::string Case::rule() const
{
    const auto at_most = [](double limit) { return limit > 0 ? "at most " + study::two_digits(limit) : "0"; };
    const std::string rule = "the figure is " + at_most(words.limit);
    return words.exact == words.limit ? rule : rule + "; for event, which claims to be exact, " + at_most(words.exact);
}

bool Report::exact_hold() const
{
    return std::none_of(cases.begin(), cases.end(), [](const Case& each) {
        return each.is_required() && std::any_of(each.results.begin(), each.results.end(),
                                                 [](const Result& r) { return r.is_exact && !r.passed(); });
    });
}

Report run_cases(std::vector<Case> cases, const std::vector<Contestant>& who, const OnProgress& on_progress)
{
    Report report;
    for (const Contestant& each : who) report.methods.push_back(each.name);
    const auto runs = static_cast<double>(cases.size() * who.size());
    double done = 0;
    for (Case& each : cases) {
        for (const Contestant& contestant : who) {
            const std::string what = each.words.case_name + ", " + contestant.name;
            const auto goes_on = [&] {
                return !on_progress || on_progress({"stress", what, done / runs, done, "runs"});
            };
            Result result = judge(each, contestant, goes_on);
            report.interrupted = !goes_on();
            if (report.interrupted) return report;
            each.results.push_back(std::move(result));
            ++done;
        }
        report.cases.push_back(std::move(each));
    }
    return report;
}

}  // namespace carom::stress
