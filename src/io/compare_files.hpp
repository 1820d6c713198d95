/// \file
/// The result of a comparison as compare.csv and compare.json; `carom compare -h` says what the columns mean.
#pragma once

#include "io/command_facts.hpp"

#include <carom/study.hpp>

#include <string>

namespace carom::io {

/// Names of the columns (study/compare_columns.hpp), separated by commas.
std::string compare_csv_header();

/// Header and a line for each row. What there is none of, or is not finite, is an empty field.
std::string compare_csv(const Comparison& comparison);

/// Format carom-compare/1, indented. What there is none of, or is not finite, is null.
std::string compare_json(const Scene& scene, const Comparison& comparison, const CommandFacts& command = {});

}  // namespace carom::io
