#include <gable/engine/io/scans/scan_file.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "engine/io/scratch.h"

namespace gable {
namespace {

#ifdef GABLE_MAKE_SCANS

int make_scans(const std::string& arguments) {
  return std::system(
      (std::string("'") + GABLE_MAKE_SCANS + "' " + arguments + " >/dev/null 2>&1").c_str());
}

TEST(MakeScans, MakesTheSameScansOfEveryClassOnAnyNumberOfThreads) {
  const ScratchFolder folder;
  for (const std::string name : {"buildings", "indoor", "cars", "sofas"}) {
    const std::string made = folder.path("a/" + name + "-0002.ply");
    ASSERT_EQ(
        make_scans(name + " 3 --seed 5 --points 3000 -o '" + folder.path("a") + "' --threads 1"),
        0);
    // The second scan does not depend on how many follow.
    ASSERT_EQ(
        make_scans(name + " 2 --seed 5 --points 3000 -o '" + folder.path("b") + "' --threads 2"),
        0);
    EXPECT_TRUE(file_bytes(made) == file_bytes(folder.path("b/" + name + "-0002.ply")));
    const Scan scan = read_scan(made);
    EXPECT_EQ(scan.points.size(), 3000u);
    for (const char* scale : {"scale_1", "scale_2", "scale_3"}) {
      ASSERT_TRUE(scan.labels.contains(scale));
      EXPECT_GE(std::ranges::max(scan.labels.at(scale)), 2);
    }
  }
}

TEST(MakeScans, RefusesWhatItCannotMake) {
  const ScratchFolder folder;
  EXPECT_NE(make_scans("castles 1 -o '" + folder.path("a") + "'"), 0);
  EXPECT_NE(make_scans("cars 0 -o '" + folder.path("a") + "'"), 0);
  EXPECT_NE(make_scans("buildings 1 --cityjson /no/such/file -o '" + folder.path("a") + "'"), 0);
  EXPECT_EQ(folder.num_files(), 0);
}

#endif

}  // namespace
}  // namespace gable
