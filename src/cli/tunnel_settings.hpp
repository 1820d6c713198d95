/// \file
/// Settings of `carom tunnel`: from the command line, else from the scene's defaults, else built in.
#pragma once

#include "cli/choices.hpp"
#include "tunnel/study.hpp"

#include <functional>
#include <limits>
#include <vector>

namespace carom::cli {

struct TunnelSettings {
    tunnel::Matrix matrix;
    std::vector<tunnel::Contestant> contestants;
    std::vector<tunnel::Absence> absent;  ///< who was asked for, or belongs to all, and is not there
    bool bisect = false;
    double max_seconds = std::numeric_limits<double>::infinity();  ///< for the whole command [s]
};

/// \param file of the scene, for messages; empty: no scene was given, `scene` is a default one
/// \param keep_going asked while an engine's program runs; must outlive the settings
/// \throws UsageError; InputError for what the scene says
TunnelSettings tunnel_settings(const TunnelArguments& args, const GlobalArguments& global, const Scene& scene,
                               const std::string& file, const std::function<bool()>& keep_going);

}  // namespace carom::cli
