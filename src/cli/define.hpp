/// \file
/// Commands as CLI11 sees them, where their definition is a file of its own.
#pragma once

#include "cli/arguments.hpp"

namespace CLI {
class App;
}

namespace carom::cli {

/// An option whose text is kept as typed; values are read later, together with the scene's defaults.
void add_given(CLI::App& app, GivenOptions& given, const std::string& flag, const std::string& value,
               const std::string& help);
/// --max-seconds.
void add_time_limit(CLI::App& app, GivenOptions& given);
/// --allow-overlap and --set.
void add_scene_options(CLI::App& app, bool& allow_overlap, std::vector<std::string>& set);

void define_audit(CLI::App& app, AuditArguments& audit);
void define_scenes(CLI::App& app, ScenesArguments& scenes);
void define_toi(CLI::App& app);
/// --allow-overlap, --set.
void add_scene_options(CLI::App& app, bool& allow_overlap, std::vector<std::string>& set);
void define_tunnel(CLI::App& app, TunnelArguments& tunnel);
void define_verify(CLI::App& app, VerifyArguments& verify);

}  // namespace carom::cli
