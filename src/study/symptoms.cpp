#include "study/symptoms.hpp"

#include "core/names.hpp"
#include "study/largest.hpp"
#include "study/tolerances.hpp"
#include "study/words.hpp"

#include <algorithm>
#include <cmath>

namespace carom::stress {

namespace {

using study::two_digits;

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
    evidence.penetration = outcome.max_penetration / smallest_radius(scene);
    const std::vector<BodyState> start = initial_states(scene);
    const double kinetic = std::max(kinetic_energy(scene, start), kinetic_energy(scene, outcome.final));
    if (conserves_energy(scene) && kinetic > 0)
        evidence.energy = std::abs(energy_difference(scene, outcome.final, start)) / kinetic;
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
    return method != "event" && method != "toi" && method != "speculative";
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

}  // namespace

Evidence evidence_of(const Scene& scene, const CheckReport& report, const std::set<CheckType>& left_out)
{
    Evidence evidence;
    const Outcome& outcome = report.run.study.outcome;
    note_end(evidence, scene, outcome);
    for (std::size_t k = 0; k < scene.checks.size(); ++k) {
        const Check& check = scene.checks[k];
        if (left_out.contains(check.type)) continue;
        if (check.type == CheckType::event_count && check.kind == EventKind::impact) {
            const std::int64_t too_few = check.count - outcome.counts.impacts;
            evidence.expected = check.count;
            evidence.missed = std::max<std::int64_t>(0, too_few);
            evidence.invented = std::max<std::int64_t>(0, -too_few);
        }
        if (const auto& repeat = report.run.sights[k].repeat) {
            evidence.other_events = evidence.other_events || repeat->other_events;
            if (repeat->outcome.status != Status::reached_end) evidence.stopped = report.results[k].message;
        }
        note_figure(evidence, figure_of(report.results[k], scene.stress->exact), report.results[k].what);
    }
    return evidence;
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

std::string explain(const StressPart& words, const std::string& method, const Evidence& evidence, Symptom symptom)
{
    const std::string numbers = finding(evidence, symptom);
    if (!has_causes(method, symptom)) return numbers;
    const auto own = words.causes.find(symptom);
    const std::string cause(own != words.causes.end() ? own->second : name_of(symptom, general_causes));
    return numbers + (cause.empty() ? "" : ": " + cause);
}

}  // namespace carom::stress
