#include "study/audit/auditor.hpp"

#include "core/expect.hpp"
#include "study/tolerances.hpp"

#include <algorithm>

namespace carom::study {

namespace {

void count(Audit& audit, const ContactAnswer& answer)
{
    ++audit.audited;
    switch (answer.answer) {
        case Answer::found:
            ++audit.found;
            break;
        case Answer::late:
            ++audit.late;
            break;
        case Answer::missed:
            ++audit.missed;
            break;
        case Answer::wrong:
            ++audit.wrong;
            break;
    }
}

}  // namespace

Auditor::Auditor(const Scene& scene, double until, double longest_step, const OnProgress& on_progress)
    : scene_(scene),
      truth_(record_truth(scene, until + longest_case * longest_step, on_progress)),
      until_(std::clamp(truth_.until - longest_case * longest_step, 0.0, until)),
      drawn_(drawn_contacts(truth_, until_, scene.seed)),
      runner_(scene, truth_)
{
}

AuditSummary Auditor::summary() const
{
    AuditSummary summary;
    summary.until = until_;
    for (const TruthContact& contact : truth_.contacts) summary.contacts += contact.time <= until_;
    summary.drawn = static_cast<std::int64_t>(drawn_.size());
    summary.phases = phases_of(drawn_.size());
    summary.slow = truth_.slow;
    summary.persistent = truth_.persistent;
    return summary;
}

const AuditCases& Auditor::cases(double dt)
{
    const auto known = cases_.find(dt);
    if (known != cases_.end()) return known->second;
    return cases_[dt] = make_cases(scene_, truth_, drawn_, dt, until_, scene_.seed);
}

Audit Auditor::audit(const Method& method, Patience& patience)
{
    CAROM_EXPECT(step_options(method) != nullptr);
    const AuditCases& all = cases(step_options(method)->dt);
    Audit audit;
    audit.crowded = all.crowded;
    double delays = 0;
    for (const ContactCase& each : all.contacts) {
        if (!patience.lasts()) return audit;
        const ContactAnswer answer = runner_.ask(each, method);
        count(audit, answer);
        delays += answer.delay;
    }
    if (const std::int64_t answered = audit.audited - audit.missed; answered > 0)
        audit.delay = delays / static_cast<double>(answered);
    for (const QuietCase& each : all.quiet) {
        if (!patience.lasts()) return audit;
        ++audit.looked_at;
        audit.invented += runner_.invents(each, method);
    }
    return audit;
}

}  // namespace carom::study
