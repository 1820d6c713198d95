/// \file
/// Verdict on the step of one stepping method, by its rows.
#pragma once

#include "study/verdict_words.hpp"

#include <string>

namespace carom::study {

/// Rows of one method, substeps and passes: how large a step is enough, as far as the steps tried can tell. One step
/// that holds proves nothing where a smaller one fails.
struct StepBracket {
    const CompareRow* enough = nullptr;   ///< largest step from which every smaller one tried holds; null if none
    const CompareRow* too_far = nullptr;  ///< the next larger one, which does not hold; null if none
    std::size_t smaller = 0;              ///< steps tried below `enough`
};

/// The bracket of `method` whose `enough` takes the least CPU time.
StepBracket step_bracket(const Comparison& comparison, const std::string& method);

/// The row of a stepping method that the verdict is about: the cheapest that is `enough` for its method, otherwise the
/// one with the smallest error; null if there is none.
const CompareRow* cheapest_stepper(const Comparison& comparison);
const CompareRow* best_stepper(const Comparison& comparison);

/// One sentence about a stepping method.
std::string method_sentence(const VerdictWords& words, const std::string& method);

}  // namespace carom::study
