/// \file
/// Words of the command line, as data. Nothing here reads a file or runs anything.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace carom::cli {

struct GlobalArguments {
    bool json = false, quiet = false, verbose = false, no_progress = false;
    std::optional<std::uint64_t> seed;
};

/// Options that a scene can give defaults for, as typed: name with `_` for `-`, and text.
using GivenOptions = std::map<std::string, std::string>;

struct RunArguments {
    std::string scene;
    GivenOptions given;  ///< method, dt, substeps, passes, order, integrator, literal, most_impacts, until, max_events,
                         ///< max_seconds, kernel, certified, impact, guard, stiffness, hertz, damping_ratio, frames
    bool always_final = false, allow_overlap = false;
    std::vector<std::string> set;  ///< "/pointer=value"
    std::string out;               ///< folder for run.json and frames.csv; may be empty
    std::string events;            ///< CSV file, or "-": stdout; may be empty
};

struct CompareArguments {
    std::string scene;
    GivenOptions given;  ///< methods, dt, substeps, passes, order, integrator, literal, until, repeats, tolerance,
                         ///< max_seconds, impact
    bool allow_overlap = false;
    std::vector<std::string> set;  ///< "/pointer=value"
    std::string out;               ///< folder; empty: out/compare-NAME
};

struct CheckArguments {
    GivenOptions given;  ///< max_seconds
    std::vector<std::string> scenes;
    bool allow_overlap = false;
    std::vector<std::string> set;  ///< "/pointer=value", of every scene
};

struct ExplainArguments {
    std::string scene;
    std::string kernel;  ///< forced; may be empty
    bool allow_overlap = false;
    std::vector<std::string> set;  ///< "/pointer=value"
};

struct StressArguments {
    GivenOptions given;             ///< methods, max_seconds
    std::vector<std::string> only;  ///< names of cases; empty: all
    bool list = false;              ///< say what cases there are, and run none
    std::string out;                ///< folder for files and page; may be empty
};

struct TunnelArguments {
    std::string scene;   ///< whose bodies are thrown; empty: the matrix
    GivenOptions given;  ///< speed, thickness, radius, dt, target, offset, methods, trials, bisect, max_seconds
    bool allow_overlap = false;
    std::vector<std::string> set;  ///< "/pointer=value"
    std::string out;               ///< folder for files and page; may be empty
};

struct VerifyArguments {
    GivenOptions given;      ///< max_seconds
    std::string run;         ///< folder of a run, or its recording
    bool all_pairs = false;  ///< without the grid
};

struct AuditArguments {
    GivenOptions given;  ///< max_seconds
    std::string trace;   ///< table t,id,x,y,z
    std::string scene;
    bool allow_overlap = false;
    std::vector<std::string> set;  ///< "/pointer=value"
    std::string out;               ///< folder for audit.json and the scenes of findings; may be empty
};

struct ReportArguments {
    GivenOptions given;  ///< max_seconds
    std::vector<std::string> folders;
    std::string out;  ///< HTML file; empty: FOLDER/report.html for one folder, out/report.html for several
};

enum class ScenesAction { list, show, validate, schema };

struct ScenesArguments {
    ScenesAction action = ScenesAction::list;
    std::string show;                   ///< scene to show
    std::vector<std::string> validate;  ///< scenes to validate; empty: the catalogue
};

enum class Command { run, compare, check, explain, stress, tunnel, verify, audit, report, scenes, toi };

struct Arguments {
    GlobalArguments global;
    Command command = Command::run;
    RunArguments run;
    CompareArguments compare;
    CheckArguments check;
    ExplainArguments explain;
    StressArguments stress;
    TunnelArguments tunnel;
    VerifyArguments verify;
    AuditArguments audit;
    ReportArguments report;
    ScenesArguments scenes;
};

/// The arguments, or what to print and return instead: help, version, a usage error.
struct ParseResult {
    std::optional<Arguments> arguments;
    int exit_code = 0;
    std::string out, err;
};

/// \param args without the program's name
ParseResult parse_arguments(const std::vector<std::string>& args);

/// Why these arguments belong to a later version, if they do: "view: not yet ...".
std::optional<std::string> later_feature(const std::vector<std::string>& args);

}  // namespace carom::cli
