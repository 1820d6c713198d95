#include "study/stress.hpp"

#include "core/names.hpp"
#include "study/clock.hpp"
#include "study/largest.hpp"
#include "study/tolerances.hpp"
#include "study/words.hpp"

#include <carom/checks.hpp>
#include <carom/error.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace carom::stress {

namespace {

using study::two_digits;

bool is_exact(const std::string& method)
{
    return method == method_names().front();
}

/// Error of a check in units of tolerance / exact; in its own unit where nothing but 0 is right.
double figure_of(const CheckResult& result, double exact)
{
    if (!result.error) return std::numeric_limits<double>::infinity();
    return result.tolerance > 0 ? *result.error / (result.tolerance / exact) : *result.error;
}

void note_figure(Evidence& evidence, double value, const std::string& where)
{
    const double before = evidence.figure;
    study::keep_largest(evidence.figure, value);
    if (!(evidence.figure == before) && !std::isnan(before)) evidence.worst = where;
}

void note_end(Evidence& evidence, const Scene& scene, const Outcome& outcome)
{
    const bool finite = std::all_of(outcome.final.begin(), outcome.final.end(), [](const BodyState& s) {
        return s.position.allFinite() && s.velocity.allFinite();
    });
    if (outcome.status != Status::reached_end)
        evidence.stopped = outcome.message.empty() ? name(outcome.status) : outcome.message;
    else if (!finite)
        evidence.stopped = "ended in numbers that are not finite";
    study::keep_largest(evidence.penetration, outcome.max_penetration / smallest_radius(scene));
    const std::vector<BodyState> start = initial_states(scene);
    const double kinetic = std::max(kinetic_energy(scene, start), kinetic_energy(scene, outcome.final));
    if (conserves_energy(scene) && kinetic > 0)
        study::keep_largest(evidence.energy, std::abs(energy_difference(scene, outcome.final, start)) / kinetic);
}

void note_impacts(Evidence& evidence, std::int64_t expected, std::int64_t found)
{
    evidence.expected += expected;
    evidence.missed += std::max<std::int64_t>(0, expected - found);
    evidence.invented += std::max<std::int64_t>(0, found - expected);
}

Evidence measure(const Case& which, const std::string& method, const std::function<bool()>& goes_on)
{
    Evidence evidence;
    for (const Scene& scene : which.scenes) {
        CheckOptions options;
        options.method = make_method(method, StepOptions{.dt = scene.stress->dt});
        if (!is_exact(method)) options.max_seconds = study::longest_stress_run;
        options.on_progress = [&](double) { return goes_on(); };
        const CheckReport report = check_scene(scene, options);
        const Outcome& outcome = report.run.study.outcome;
        note_end(evidence, scene, outcome);
        for (std::size_t k = 0; k < scene.checks.size(); ++k) {
            const Check& check = scene.checks[k];
            if (check.type == CheckType::rest_time && !is_exact(method)) continue;  // discrete methods know no rest
            if (check.type == CheckType::event_count && check.kind == EventKind::impact)
                note_impacts(evidence, check.count, outcome.counts.impacts);
            if (const auto& repeat = report.run.sights[k].repeat) {
                evidence.other_events = evidence.other_events || repeat->other_events;
                if (repeat->outcome.status != Status::reached_end) evidence.stopped = report.results[k].message;
            }
            note_figure(evidence, figure_of(report.results[k], scene.stress->exact),
                        (which.scenes.size() > 1 ? scene.name + ", " : "") + report.results[k].what);
        }
    }
    return evidence;
}

/// The numbers of a symptom.
std::string finding(const Evidence& evidence, Symptom symptom)
{
    const auto& [figure, worst, stopped, other, expected, missed, invented, penetration, energy] = evidence;
    const std::array<std::string, symptom_names.size()> findings{
        "",
        stopped,
        "the events of the repeated run are not those of the first",
        "sank " + two_digits(penetration) + " radii deep",
        "energy off by " + two_digits(energy) + " of the kinetic energy",
        "missed " + std::to_string(missed) + " of " + std::to_string(expected) + " impacts",
        "made " + std::to_string(invented) + " impacts too many",
        "off by " + two_digits(figure) + (worst.empty() ? "" : " (" + worst + ")")};
    return findings[static_cast<std::size_t>(symptom)];
}

/// Whether the causes, those of the cases too, are this method's: they are of methods that look for contacts at the
/// ends of their steps alone. `toi` searches the step, `speculative` foresees contacts, and `bisection` goes back into
/// a step at whose end there is an overlap.
bool has_causes(const std::string& method, Symptom symptom)
{
    if (method == "bisection") return symptom == Symptom::missed;
    return method != "toi" && method != "speculative";
}

/// Causes that hold wherever a case names none of its own, by Symptom.
constexpr std::array<std::string_view, symptom_names.size()> general_causes{
    "",
    "",
    "",
    "the surfaces pass each other by that much in a step",
    "impacts act at the end of a step, not where the surfaces meet",
    "contacts that begin and end between two looks are not seen",
    "an overlap that is not undone within a step is answered again",
    "an impact is found up to a step late"};

std::string explain(const StressPart& words, const std::string& method, const Evidence& evidence, Symptom symptom)
{
    if (!has_causes(method, symptom)) return finding(evidence, symptom);
    const auto own = words.causes.find(symptom);
    const std::string cause(own != words.causes.end() ? own->second : name_of(symptom, general_causes));
    return finding(evidence, symptom) + (cause.empty() ? "" : ": " + cause);
}

std::string at_most(double limit)
{
    return limit > 0 ? "at most " + two_digits(limit) : "0";
}

Result judge(const Case& which, const std::string& method, const std::function<bool()>& goes_on)
{
    study::Stopwatch watch;
    Result result{.method = method, .evidence = measure(which, method, goes_on), .limit = 0, .reason = ""};
    watch.pause();
    result.limit = is_exact(method) ? which.words.exact : which.words.limit;
    result.symptom = diagnose(result.evidence, result.limit);
    if (!result.passed()) result.reason = explain(which.words, method, result.evidence, result.symptom);
    result.seconds = watch.cpu();
    return result;
}

}  // namespace

std::vector<Case> cases_of(const std::vector<Scene>& scenes)
{
    std::map<std::string, Case> cases;
    for (const Scene& scene : scenes) {
        const StressPart& part = *scene.stress;
        auto& [words, about, members, results] =
            cases.try_emplace(part.case_name, Case{part, "", {}, {}}).first->second;
        if (words.exact != part.exact || words.limit != part.limit)
            throw InputError({"stress case \"" + part.case_name + "\": its scenes give different limits (see \"" +
                              scene.name + "\")"});
        if (words.title.empty()) words.title = part.title;
        if (words.figure.empty()) words.figure = part.figure;
        if (words.step.empty()) words.step = part.step;
        words.causes.insert(part.causes.begin(), part.causes.end());
        about += (about.empty() ? "" : " ") + scene.description;
        members.push_back(scene);
    }
    std::vector<Case> list;
    for (auto& [name, each] : cases) list.push_back(std::move(each));
    return list;
}

Symptom diagnose(const Evidence& evidence, double limit)
{
    if (!evidence.stopped.empty()) return Symptom::stopped;
    if (evidence.other_events) return Symptom::other_run;
    if (evidence.figure <= limit) return Symptom::none;
    if (!(evidence.penetration < study::sunk)) return Symptom::sank;
    if (!(evidence.energy < study::much_energy)) return Symptom::energy;
    if (evidence.missed > 0) return Symptom::missed;
    if (evidence.invented > 0) return Symptom::invented;
    return Symptom::late;
}

std::string Case::rule() const
{
    const std::string rule = "the figure is " + at_most(words.limit);
    return words.exact == words.limit ? rule : rule + "; for event, which claims to be exact, " + at_most(words.exact);
}

bool Report::event_passes() const
{
    return std::all_of(cases.begin(), cases.end(), [](const Case& each) {
        return std::all_of(each.results.begin(), each.results.end(),
                           [](const Result& r) { return r.passed() || !is_exact(r.method); });
    });
}

Report run_cases(std::vector<Case> cases, const std::vector<std::string>& methods, const OnProgress& on_progress)
{
    Report report{methods.empty() ? method_names() : methods, {}, false};
    for (const std::string& method : report.methods) make_method(method);  // throws for unknown ones
    const auto runs = static_cast<double>(cases.size() * report.methods.size());
    double done = 0;
    for (Case& each : cases) {
        for (const std::string& method : report.methods) {
            const std::string what = each.words.case_name + ", " + method;
            const auto goes_on = [&] {
                return !on_progress || on_progress({"stress", what, done / runs, done, "runs"});
            };
            Result result = judge(each, method, goes_on);
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
