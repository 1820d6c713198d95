/// \file
/// Commands as CLI11 sees them, where their definition is a file of its own.
#pragma once

#include "cli/arguments.hpp"

namespace CLI {
class App;
}

namespace carom::cli {

void define_scenes(CLI::App& app, ScenesArguments& scenes);

}  // namespace carom::cli
