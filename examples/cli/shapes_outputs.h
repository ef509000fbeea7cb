#pragma once

#include <gable/engine/scales/detect_scales.h>
#include <gable/engine/scan.h>

#include <string>

namespace gable {

/// Writes scale-K.ply, .json and .obj of every scale (1: finest) and trajectory.json into a folder.
/// Throws Error (kCannotWrite).
void write_scales(const std::string& folder, const Scan& scan, const DetectedScales& detected);

/// Removes what a run with more scales left in a folder: scale-K.ply, .json and .obj of K greater
/// than `num_scales`.
void remove_further_scales(const std::string& folder, int num_scales);

/// The number of a file "scale-K.EXTENSION" (extension with its dot), 0 for other names.
int scale_number(const std::string& name, const std::string& extension);

/// A line per scale: shapes, coverage, RMS, configuration.
std::string scales_table(const DetectedScales& detected);

}  // namespace gable
