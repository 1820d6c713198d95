/// \file
/// The answers of the search for steps, and orders of convergence, in words.
#pragma once

#include "study/verdict_words.hpp"

#include <string>

namespace carom::study {

/// One sentence about the largest step of one method within the tolerance, or why there is none.
std::string search_sentence(const VerdictWords& words, const StepSearch& search);

/// How fast errors fall, and which no longer do; empty where too few steps were run.
std::string convergence_sentence(const VerdictWords& words);

/// "; asked impact by impact, it misses 12.1 % (10.2-14.3) and answers 3 % late"; empty without an audit.
std::string audit_clause(const CompareRow& row);

}  // namespace carom::study
