#include "examples/cli/scan_trajectories.h"

#include <gable/engine/error.h>
#include <gable/engine/parallel_ranges.h>
#include <gable/engine/scales/lack_of_shapes.h>

#include <atomic>
#include <exception>
#include <iostream>

#include "examples/cli/progress.h"
#include "examples/cli/scan_input.h"

namespace gable {

void for_trajectories(
    const std::vector<std::string>& files, const ReadScanOptions& reading,
    const CommonOptions& options, const CommandContext& context,
    const std::function<void(size_t index, const ScanTrajectory& trajectory)>& work) {
  const int threads = options.num_threads();
  FirstShapesOptions first_shapes;
  if (files.size() == 1) first_shapes.threads = threads;
  Progress progress("scans", files.size(), progress_style(options.quiet), std::cerr);
  std::vector<std::exception_ptr> failures(files.size());
  std::atomic<bool> failed = false;
  const auto one = [&](size_t i) {
    ScanTrajectory trajectory;
    trajectory.path = files[i];
    ScanFile file = read_scan_file(files[i], reading);
    const std::string skipped = skipped_line(files[i], file);
    if (!skipped.empty()) progress.say(skipped);
    trajectory.scan = std::move(file.scan);
    trajectory.collapsed = collapse_scan(trajectory.scan, first_shapes);
    if (trajectory.collapsed.trajectory.num_first > 0) {
      work(i, trajectory);
    } else {
      progress.say(files[i] + ": left out, it has no planar shapes: " +
                   lack_of_shapes(trajectory.scan, first_shapes));
    }
    progress.advance();
  };
  const auto guarded = [&](size_t i, size_t) {
    if (failed || context.stop.stop_requested()) return;
    try {
      one(i);
    } catch (...) {
      failures[i] = std::current_exception();
      failed = true;
    }
  };
  for_ranges(files.size(), threads, guarded, 1);
  for (const std::exception_ptr& failure : failures) {
    if (failure) std::rethrow_exception(failure);
  }
  if (context.stop.stop_requested()) {
    throw Error(ExitCode::kInterrupted, "interrupted, nothing was written");
  }
}

}  // namespace gable
