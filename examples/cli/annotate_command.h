#pragma once

#include <CLI/CLI.hpp>

#include "examples/cli/common_options.h"

namespace gable {

/// Adds `gable annotate`: contact sheets of real buildings, and a file of answers to be corrected.
void add_annotate_command(CLI::App* app, const CommandContext& context);

}  // namespace gable
