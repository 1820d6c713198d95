/// \file
/// The stress report as stress.csv and stress.json.
#pragma once

#include "io/command_facts.hpp"
#include "study/stress.hpp"

#include <string>

namespace carom::io {

inline constexpr const char* stress_csv_header =
    "case,waits_for,method,passed,figure,limit,symptom,scene,worst,reason,cpu_seconds";

/// Header and a line for each case and method; `scene` and `worst` are the run and the check that speak most against
/// it. A figure that is not finite is an empty field.
std::string stress_csv(const stress::Report& report);

/// Format carom-stress/1, indented; with every run of a case. A figure that is not finite is null.
std::string stress_json(const stress::Report& report, const CommandFacts& command = {});

}  // namespace carom::io
