#pragma once

#include <CLI/CLI.hpp>

#include "examples/cli/common_options.h"

namespace gable {

/// Adds `gable synthesize`: a surveyed village with its truth, as files in one folder.
void add_synthesize_command(CLI::App* app, const CommandContext& context);

}  // namespace gable
