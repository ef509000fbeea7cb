#pragma once

#include <gtest/gtest.h>

#include <string>

#include "cli/run_program.h"
#include "engine/io/scratch.h"

namespace gable {

/// A folder with a small village that `gable synthesize` made, for one test.
class VillageFolder : public ScratchFolder {
 public:
  explicit VillageFolder(int count = 4) {
    const ProgramRun run = run_gable({"synthesize", "--count", std::to_string(count), "--seed", "7",
                                      "--quiet", "-o", path("v")});
    EXPECT_EQ(run.exit_code, 0) << run.err;
  }

  std::string dsm() const { return path("v/dsm.tif"); }
  std::string dtm() const { return path("v/dtm.tif"); }
  std::string footprints() const { return path("v/footprints.gpkg"); }
  std::string truth() const { return path("v/truth.city.jsonl"); }
};

}  // namespace gable
