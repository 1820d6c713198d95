/// \file
/// The result of a comparison as compare.csv and compare.json; `carom compare -h` says what the columns mean.
#pragma once

#include "io/command_facts.hpp"

#include <carom/study.hpp>

#include <string>

namespace carom::io {

inline constexpr const char* compare_csv_header =
    "method,dt,substeps,passes,cpu_seconds,cpu_min,cpu_max,position_rms,position_max,position_final_rms,position_final_"
    "max,"
    "velocity_rms,energy_error,max_penetration,missed_impacts,invented_impacts,impacts,rest_jitter,divergence_time,"
    "reference_bound,steps,root_solves,pair_tests,status";

/// Header and a line for each row. What there is none of, or is not finite, is an empty field.
std::string compare_csv(const Comparison& comparison);

/// Format carom-compare/1, indented. What there is none of, or is not finite, is null.
std::string compare_json(const Scene& scene, const Comparison& comparison, const CommandFacts& command = {});

}  // namespace carom::io
