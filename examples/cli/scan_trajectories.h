#pragma once

#include <gable/engine/io/scans/scan_file.h>
#include <gable/engine/scales/detect_scales.h>
#include <gable/engine/scan.h>

#include <functional>
#include <string>
#include <vector>

#include "examples/cli/common_options.h"

namespace gable {

/// A scan file and its trajectory.
struct ScanTrajectory {
  std::string path;
  Scan scan;
  CollapsedScan collapsed;
};

/// Computes the trajectories of scans, each on a thread of its own, and calls work(i, trajectory)
/// from that thread. Shows progress; scans without planar shapes are skipped with a line. Throws
/// the first error by the order of the files; kInterrupted where a stop is requested.
void for_trajectories(
    const std::vector<std::string>& files, const ReadScanOptions& reading,
    const CommonOptions& options, const CommandContext& context,
    const std::function<void(size_t index, const ScanTrajectory& trajectory)>& work);

}  // namespace gable
