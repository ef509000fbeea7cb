#pragma once

#include <CLI/CLI.hpp>

#include "examples/cli/common_options.h"

namespace gable {

/// Adds `gable shapes annotate`: contact sheets of trajectories, and a file to mark scales in.
void add_shapes_annotate_command(CLI::App* shapes, const CommandContext& context);

}  // namespace gable
