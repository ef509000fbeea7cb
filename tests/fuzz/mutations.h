#pragma once

#include <gable/grammar/random.h>

#include <string>
#include <vector>

namespace gable {

/// A damaged copy of one of the seeds: one to eight of bit flips, changed bytes, cuts, doubled or
/// removed parts, parts of other seeds, and numbers (in decimal or binary) that readers fear.
std::string mutated(const std::vector<std::string>& seeds, Random* random);

}  // namespace gable
