/// \file
/// The search for steps within the tolerance, for the console.
#pragma once

#include <carom/study.hpp>

#include <string>

namespace carom::cli {

/// A line for each method, and what the columns mean; empty where no steps were searched for.
std::string search_table(const Scene& scene, const Comparison& comparison);

}  // namespace carom::cli
