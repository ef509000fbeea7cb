#pragma once

#include <CLI/CLI.hpp>

#include "examples/cli/common_options.h"

namespace gable {

/// Adds `gable reconstruct`: heights to house models.
void add_reconstruct_command(CLI::App* app, const CommandContext& context);

}  // namespace gable
