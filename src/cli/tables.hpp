/// \file
/// Results as text for people.
#pragma once

#include "audit/report.hpp"
#include "io/command_facts.hpp"
#include "study/stress.hpp"
#include "tunnel/study.hpp"

#include <carom/checks.hpp>
#include <carom/study.hpp>

#include <string>
#include <vector>

namespace carom::cli {

/// Rows of cells as aligned columns; the first row is the head, the first `left` columns are words.
std::string aligned(const std::vector<std::vector<std::string>>& rows, std::size_t left);

// Parts that tables share.
std::string figure(const std::optional<double>& value);        ///< three digits; "-" for none
std::string counted(std::size_t n, const char* what);          ///< "3 spheres"
std::string bodies(const Scene& scene);                        ///< "3 spheres, 1 plane"
std::string with_unit(double value, const std::string& unit);  ///< ten digits
/// "3.1 s for the whole command (CPU 3 s), 0.13 s of CPU for the engine".
std::string clock_text(const io::CommandFacts& command, double part_cpu_seconds, const std::string& part);

/// How to go on after a run that met something which it cannot resolve; empty for others.
std::string unresolved_advice(const Outcome& outcome);

/// A run in a dozen lines.
std::string run_table(const Scene& scene, const RunStudy& run, const io::CommandFacts& command);

/// The checks of a scene, one a line.
std::string check_table(const Scene& scene, const std::string& name, const CheckReport& report);

/// Meanings of the columns of `compare_table`, for the table and for the help.
extern const char* const compare_legend;

/// A comparison, one row a line, then what its columns mean, and the verdict.
std::string compare_table(const Scene& scene, const Comparison& comparison);

/// The matrix summed up by method and target, or each row where there are few; then critical speeds beside the law.
std::string tunnel_table(const tunnel::Report& report);

/// The audit of a trace: what was decided, and the first findings.
std::string audit_table(const Scene& scene, const audit::TraceAudit& audit);

/// Cases by methods, then each case with its rule and why methods fail it; without methods a list of the cases.
std::string stress_table(const stress::Report& report);

}  // namespace carom::cli
