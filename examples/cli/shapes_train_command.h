#pragma once

#include <CLI/CLI.hpp>

#include "examples/cli/common_options.h"

namespace gable {

/// Adds `gable shapes train`: a model of structural scales from scans whose scales are marked.
void add_shapes_train_command(CLI::App* shapes, const CommandContext& context);

}  // namespace gable
