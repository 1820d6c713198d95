#include "study/search_words.hpp"

#include "study/share.hpp"
#include "study/tolerances.hpp"
#include "study/words.hpp"

#include <array>
#include <cmath>
#include <utility>

namespace carom::study {

namespace {

std::string percent_with_interval(std::int64_t part, std::int64_t whole)
{
    const Share share = wilson_share(part, whole);
    return three_digits(per_cent * share.value) + " % (" + three_digits(per_cent * share.low) + "-" +
           three_digits(per_cent * share.high) + ")";
}

std::string order_text(const Convergence& fit)
{
    return fit.method + fit.variant + " as dt^" + two_digits(fit.order) + " +- " + two_digits(fit.uncertainty);
}

}  // namespace

std::string audit_clause(const CompareRow& row)
{
    if (!row.audit || row.audit->audited == 0) return "";
    const Audit& audit = *row.audit;
    const std::array<std::pair<std::int64_t, const char*>, 3> faults{
        {{audit.missed, "misses "}, {audit.late, "answers late "}, {audit.wrong, "answers with a wrong velocity "}}};
    std::string text;
    for (const auto& [count, verb] : faults)
        if (count > 0) text += (text.empty() ? "" : ", ") + (verb + percent_with_interval(count, audit.audited));
    if (text.empty()) text = "finds all " + std::to_string(audit.audited) + " that could be asked about";
    if (audit.invented > 0)
        text += ", invents in " + percent_with_interval(audit.invented, audit.looked_at) + " of steps";
    return "; asked impact by impact, it " + text;
}

std::string search_sentence(const VerdictWords& words, const StepSearch& search)
{
    const std::string what = search.method + search.variant + words.while_known() + ": ";
    if (search.end == StepSearch::End::found && search.row) {
        std::string text = what + "dt = " + step_text(*search.row->dt) +
                           " is the largest step from which all smaller ones tried keep within " + words.tolerance() +
                           "; it costs " + words.cost(*search.row);
        if (search.too_far && search.too_far_error)
            text += "; at " + step_text(*search.too_far) + " it is off by " + words.length(*search.too_far_error);
        return text + audit_clause(*search.row) + ".";
    }
    if (!search.best_error) return what + "no step tried gave a finite answer.";
    const std::string best = words.length(*search.best_error) + " at dt = " + step_text(*search.best_step);
    if (search.end == StepSearch::End::stalls)
        return what + "no step keeps within " + words.tolerance() + ": the error stalls, smaller steps leave it at " +
               best + ".";
    return what + "no step that can be run in " + seconds_text(search_budget) + " keeps within " + words.tolerance() +
           " (best " + best + ").";
}

std::string convergence_sentence(const VerdictWords& words)
{
    std::string falls, stalls;
    for (const Convergence& fit : words.comparison().convergence) {
        if (fit.stalled)
            stalls += (stalls.empty() ? "" : ", ") + fit.method + fit.variant + " at " + words.length(fit.last_error);
        else
            falls += (falls.empty() ? "" : ", ") + order_text(fit);
    }
    std::string text;
    if (!falls.empty()) text = "Errors fall with the step: " + falls + ".";
    if (!stalls.empty())
        text += (text.empty() ? "" : " ") + ("Errors no longer fall with smaller steps: " + stalls + ".");
    return text;
}

}  // namespace carom::study
