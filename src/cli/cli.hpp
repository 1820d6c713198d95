/// \file
/// The command line tool as functions.
#pragma once

#include "cli/arguments.hpp"
#include "cli/console.hpp"

#include <carom/progress.hpp>
#include <carom/scene.hpp>

#include <string>
#include <vector>

namespace carom::cli {

// One file a command. Each returns an exit code and throws InputError or UsageError.
int do_run(const RunArguments& args, const GlobalArguments& global, const Console& console);
int do_compare(const CompareArguments& args, const GlobalArguments& global, const Console& console);
int do_check(const CheckArguments& args, const GlobalArguments& global, const Console& console);
int do_explain(const ExplainArguments& args, const GlobalArguments& global, const Console& console);
int do_stress(const StressArguments& args, const GlobalArguments& global, const Console& console);
int do_tunnel(const TunnelArguments& args, const GlobalArguments& global, const Console& console);
int do_verify(const VerifyArguments& args, const GlobalArguments& global, const Console& console);
int do_audit(const AuditArguments& args, const GlobalArguments& global, const Console& console);
int do_report(const ReportArguments& args, const GlobalArguments& global, const Console& console);
int do_scenes(const ScenesArguments& args, const GlobalArguments& global, const Console& console);
int do_toi(const Console& console);

/// Folder of the catalogue: the environment's CAROM_SCENES, else that of the build.
std::filesystem::path scene_folder();

/// The scene in `file` with the seed and the changes of the command line. \throws InputError; Stopped by `on_progress`
Scene read_with_options(const std::filesystem::path& file, bool allow_overlap, const std::vector<std::string>& set,
                        const GlobalArguments& global, const OnProgress& on_progress = {});

/// Everything but the process: errors become messages on `console.err` and exit codes.
/// \param args without the program's name
int run_cli(const std::vector<std::string>& args, const Console& console);

/// The tool. Never throws.
int run_cli(int argc, char** argv);

}  // namespace carom::cli
