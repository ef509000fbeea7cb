#pragma once

#include <string>

namespace gable {

/// "1.25": a number in fixed notation, never "-0.00".
std::string fixed(double value, int decimals);

}  // namespace gable
