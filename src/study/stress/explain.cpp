#include "study/stress/case.hpp"

#include "study/words.hpp"

#include <cmath>

namespace carom::stress {

namespace {

using study::two_digits;

/// The numbers of a symptom.
std::string finding(const Evidence& evidence, Symptom symptom)
{
    switch (symptom) {
        case Symptom::stopped:
            return evidence.stopped;
        case Symptom::other_run:
            return "the events are not those of the same scene at 0";
        case Symptom::missed:
            return "missed " + std::to_string(evidence.missed) + " of " + std::to_string(evidence.expected) +
                   " impacts";
        case Symptom::invented:
            return "made " + std::to_string(evidence.invented) + " impacts too many";
        case Symptom::sank:
            return "sank " + two_digits(evidence.penetration) + " radii deep";
        case Symptom::energy:
            return "energy off by " + two_digits(evidence.energy) + " of the kinetic energy";
        case Symptom::late:
            return "off by " + two_digits(evidence.figure) +
                   (evidence.worst.empty() ? "" : " (" + evidence.worst + ")");
        case Symptom::none:
            break;
    }
    return "";
}

/// Causes that hold wherever a case names none of its own.
std::string general_cause(Symptom symptom)
{
    switch (symptom) {
        case Symptom::missed:
            return "contacts that begin and end between two looks are not seen";
        case Symptom::invented:
            return "an overlap that is not undone within a step is answered again";
        case Symptom::sank:
            return "the surfaces pass each other by that much in a step";
        case Symptom::energy:
            return "impacts act at the end of a step, not where the surfaces meet";
        case Symptom::late:
            return "an impact is found up to a step late";
        default:
            return "";
    }
}

}  // namespace

const char* name(Symptom symptom)
{
    switch (symptom) {
        case Symptom::none:
            return "none";
        case Symptom::stopped:
            return "stopped";
        case Symptom::other_run:
            return "other_run";
        case Symptom::missed:
            return "missed";
        case Symptom::invented:
            return "invented";
        case Symptom::sank:
            return "sank";
        case Symptom::energy:
            return "energy";
        case Symptom::late:
            return "late";
    }
    return "?";
}

Symptom diagnose(const Evidence& evidence, double limit)
{
    constexpr double deep = 0.5, much = 0.01;
    if (!evidence.stopped.empty()) return Symptom::stopped;
    if (!evidence.same_run) return Symptom::other_run;
    if (evidence.figure <= limit) return Symptom::none;
    if (!(evidence.penetration < deep)) return Symptom::sank;
    if (!(evidence.energy < much)) return Symptom::energy;
    if (evidence.missed > 0) return Symptom::missed;
    if (evidence.invented > 0) return Symptom::invented;
    return Symptom::late;
}

std::string explain(const Case& which, const Evidence& evidence, Symptom symptom)
{
    if (symptom == Symptom::none) return "";
    const auto own = which.why.find(symptom);
    const std::string cause = own != which.why.end() ? own->second : general_cause(symptom);
    return finding(evidence, symptom) + (cause.empty() ? "" : ": " + cause);
}

}  // namespace carom::stress
