#pragma once

#include <CLI/CLI.hpp>

#include "examples/cli/common_options.h"

namespace gable {

/// Adds `gable refine`: given models moved to where heights want them.
void add_refine_command(CLI::App* app, const CommandContext& context);

}  // namespace gable
