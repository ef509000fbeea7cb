#pragma once

#include <gable/engine/scales/first_shapes.h>
#include <gable/engine/scan.h>

#include <string>

namespace gable {

/// Why a scan in which no first shapes were found has none, for people: "it has 7 points, a shape
/// needs 10", "all its points lie on a line".
std::string lack_of_shapes(const Scan& scan, const FirstShapesOptions& options);

}  // namespace gable
