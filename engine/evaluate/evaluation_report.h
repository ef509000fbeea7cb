#pragma once

#include <gable/engine/evaluate/evaluation.h>

#include <string>

namespace gable {

/// The figures as lines of text; with `per_building`, a table of all buildings as well.
std::string evaluation_report(const Evaluation& evaluation, bool per_building = false);

}  // namespace gable
