#pragma once

#include <gable/engine/scales/scale_labels.h>

#include <string>
#include <vector>

namespace gable {

/// Where the scales of a scan begin, in a labels file.
struct ScanScaleLabels {
  std::string file;    ///< of the scan, relative to the folder of the labels file
  ScaleLabels labels;  ///< of its trajectory
  bool known = false;  ///< from known planes; false: proposed, for a person to correct
};

/// The scales of many scans, to train a model on.
struct ScaleLabelsFile {
  int num_scales = 0;  ///< of every scan, [1, 62]
  std::vector<ScanScaleLabels> scans;
};

/// Writes labels as JSON that people edit, a scan a line:
///
///     {"format": "gable scale labels", "version": 1,
///      "scales": 3,                     scales of every scan
///      "scans": [
///       {"file": "scans/a.ply",         relative to the folder of this file, where possible
///        "configurations": 1840,        of the scan's trajectory, so that another is noticed
///        "first": [1650, 1790, 1832],   the configuration at which each scale begins, finest first
///        "source": "proposed"}]}        or "known": from known planes in the scan
///
/// Configurations before the first scale belong to none. A scale that the object does not have
/// begins where the next one does; one missing at the coarse end at "configurations". Throws Error
/// (kCannotWrite).
void write_scale_labels(const std::string& path, const ScaleLabelsFile& file);

/// Throws Error: kNoInput where the file does not exist, kBadInput where it is no such file, or a
/// scan's numbers fall, lie outside its trajectory or are not one per scale; the line names the
/// scan.
ScaleLabelsFile read_scale_labels(const std::string& path);

/// A scan's name in a labels file: relative to the folder of the labels file where possible.
std::string name_in_labels(const std::string& scan, const std::string& labels);

}  // namespace gable
