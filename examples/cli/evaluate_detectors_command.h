#pragma once

#include <CLI/CLI.hpp>

#include "examples/cli/common_options.h"

namespace gable {

/// `gable evaluate-detectors`: the paper's Table 1 and confusion matrices.
void add_evaluate_detectors_command(CLI::App* app, const CommandContext& context);

}  // namespace gable
