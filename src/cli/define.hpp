/// \file
/// Commands as CLI11 sees them, where their definition is a file of its own.
#pragma once

#include "cli/arguments.hpp"

namespace CLI {
class App;
}

namespace carom::cli {

void define_scenes(CLI::App& app, ScenesArguments& scenes);
void define_toi(CLI::App& app);
void define_verify(CLI::App& app, VerifyArguments& verify);

}  // namespace carom::cli
