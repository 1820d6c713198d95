/// \file
/// The verdict's sentence on instants whose outcome is a convention.
#pragma once

#include "study/verdict_words.hpp"

namespace carom::study {

/// Names the first instant at which operators differ, its bodies and what each operator gives, and how many more there
/// are; empty where none differ.
std::string convention_sentence(const Scene& scene, const VerdictWords& words);

}  // namespace carom::study
