#pragma once

#include <gable/engine/reconstruct/scan/scan_solids.h>
#include <gable/engine/scales/detect_scales.h>
#include <gable/engine/scan.h>

#include <string>
#include <vector>

namespace gable {

/// The closed model of every scale, finest first. Throws Error (kBadInput) naming `scan_name` where
/// no scale can be closed.
std::vector<ScanSolid> close_detected_scales(const std::string& scan_name, const Scan& scan,
                                             const DetectedScales& detected);

/// Writes solid-K.obj (1: finest) of the scales that could be closed, and solids.json with their
/// figures, into a folder:
///
///     {"solids": [{"scale": 1, "file": "solid-1.obj",   null where there is none
///                  "shapes_of_scale": 1,   whose shapes were closed, see close_scales
///                  "planes": 12,       of the roofs
///                  "facets": 40, "triangles": 80,   of the closed model
///                  "rms": 0.12,        metres, of the scan to the model's surface
///                  "mean": 0.07,       metres
///                  "rms_percent": 0.1, of the scan's diagonal
///                  "reason": "..."}]}  where there is no model
///
/// Throws Error (kCannotWrite).
void write_solids(const std::string& folder, const std::vector<ScanSolid>& solids, double diagonal);

/// A line per scale with the same figures.
std::string solids_table(const std::vector<ScanSolid>& solids, double diagonal);

}  // namespace gable
