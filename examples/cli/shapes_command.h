#pragma once

#include <CLI/CLI.hpp>

#include "examples/cli/common_options.h"

namespace gable {

/// Adds `gable shapes SCAN`, the planar shapes of a scan at its structural scales, and its
/// subcommands annotate, train and evaluate.
void add_shapes_command(CLI::App* app, const CommandContext& context);

}  // namespace gable
