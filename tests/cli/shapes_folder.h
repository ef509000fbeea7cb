#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "cli/run_program.h"
#include "engine/io/scratch.h"

namespace gable {

/// A folder with a small scan, scan.ply, and a model of three scales, tiny.scales, for one test.
class ShapesFolder : public ScratchFolder {
 public:
  ShapesFolder();

  std::string scan() const { return path("scan.ply"); }
  std::string model() const { return path("tiny.scales"); }
  std::string out() const { return path("out"); }

  /// gable shapes SCAN --model tiny.scales -o out MORE...
  ProgramRun shapes(const std::string& scan, const std::vector<std::string>& more = {}) const;

  /// The names of the files in a folder of it, sorted; hidden ones too.
  std::vector<std::string> files(const std::string& folder) const;
};

}  // namespace gable
