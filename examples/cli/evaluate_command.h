#pragma once

#include <CLI/CLI.hpp>

#include "examples/cli/common_options.h"

namespace gable {

/// Adds `gable evaluate`: models measured against heights, and against a truth.
void add_evaluate_command(CLI::App* app, const CommandContext& context);

}  // namespace gable
