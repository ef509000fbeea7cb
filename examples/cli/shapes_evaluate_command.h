#pragma once

#include <CLI/CLI.hpp>

#include "examples/cli/common_options.h"

namespace gable {

/// Adds `gable shapes evaluate`: planar shapes measured against the scan, and against a truth.
void add_shapes_evaluate_command(CLI::App* shapes, const CommandContext& context);

}  // namespace gable
