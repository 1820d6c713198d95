/// \file
/// One command as it goes: its clock and its end, the line that shows how far it is, and the scenes that it reads.
#pragma once

#include "cli/arguments.hpp"
#include "cli/command_watch.hpp"
#include "cli/progress.hpp"

#include <carom/scene.hpp>

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace carom::cli {

/// Begin of a command, before it reads anything.
class Session {
public:
    /// \param given with --max-seconds, if it was typed. \throws UsageError if that is no number > 0
    Session(const GivenOptions& given, const GlobalArguments& global, const Console& console);

    CommandWatch watch;
    ProgressLine progress;

    /// Shows the progress of long work, and ends it when the command must end. \pre the session outlives it
    OnProgress on_progress();
    /// The same for a run to `until`, which tells the time that it has reached [time].
    std::function<bool(double)> on_time(const std::string& stage, double until, const Scene& scene);

    /// The scene in `file` with the seed and the changes of the command line.
    /// \throws InputError; CommandEnded if the command must end before it is read
    Scene read(const std::filesystem::path& file, bool allow_overlap, const std::vector<std::string>& set);

private:
    const GlobalArguments& global_;
};

}  // namespace carom::cli
