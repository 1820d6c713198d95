/// \file
/// Results as text for people.
#pragma once

#include "study/stress/stress.hpp"

#include <carom/checks.hpp>
#include <carom/study.hpp>

#include <string>
#include <vector>

namespace carom::cli {

/// Rows of cells as aligned columns; the first row is the head, the first `left` columns are words.
std::string aligned(const std::vector<std::vector<std::string>>& rows, std::size_t left);

/// A run in a dozen lines.
std::string run_table(const Scene& scene, const RunStudy& run);

/// The checks of a scene, one a line.
std::string check_table(const Scene& scene, const std::string& name, const CheckReport& report);

/// A comparison, one row a line, then the verdict.
std::string compare_table(const Scene& scene, const Comparison& comparison);

/// Cases by methods, then each case with its rule and why methods fail it.
std::string stress_table(const stress::Report& report);

}  // namespace carom::cli
