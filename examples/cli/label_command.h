#pragma once

#include <CLI/CLI.hpp>

#include "examples/cli/common_options.h"

namespace gable {

/// `gable label`: crops of real houses with the solver's own answers as targets.
void add_label_command(CLI::App* app, const CommandContext& context);

}  // namespace gable
