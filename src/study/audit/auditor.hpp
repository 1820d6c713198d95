/// \file
/// The one-step audit: would a method have missed it? The answer does not depend on drift: before each impact of the
/// truth the method begins anew from the exact state.
#pragma once

#include "study/audit/run.hpp"

#include "core/patience.hpp"

#include <carom/study.hpp>

#include <map>
#include <vector>

namespace carom::study {

class Auditor {
public:
    /// Records the truth. \param until impacts up to here are asked about [time] \param longest_step [time]
    Auditor(const Scene& scene, double until, double longest_step, const OnProgress& on_progress);

    AuditSummary summary() const;
    bool stopped() const { return truth_.stopped; }
    const Truth& truth() const { return truth_; }

    /// Incomplete where patience ended. \pre a discrete method, its step at most the longest
    Audit audit(const Method& method, Patience& patience);

private:
    const AuditCases& cases(double dt);

    const Scene& scene_;
    Truth truth_;
    double until_;
    std::vector<std::size_t> drawn_;
    CaseRunner runner_;
    std::map<double, AuditCases> cases_;
};

}  // namespace carom::study
