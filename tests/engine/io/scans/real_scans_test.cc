#include <gable/engine/io/scans/scan_file.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cstdlib>
#include <filesystem>

namespace gable {
namespace {

struct Known {
  const char* name;
  size_t points, normals, facets, skipped_points;
  double diagonal;  ///< of the bounding box; measured by another program
};

class RealScans : public testing::TestWithParam<Known> {};

TEST_P(RealScans, HaveTheNumbersThatOtherProgramsFind) {
  const char* data = std::getenv("GABLE_DATA");
  const std::string folder =
      std::string(data ? data : GABLE_SOURCE_DIR "/../shared/data") + "/shapes/";
  const Known& known = GetParam();
  if (!std::filesystem::exists(folder + known.name)) {
    GTEST_SKIP() << "no real data at " << folder << known.name << "; set GABLE_DATA";
  }
  const ScanFile file = read_scan_file(folder + known.name);
  const Scan& scan = file.scan;
  EXPECT_EQ(scan.points.size(), known.points);
  EXPECT_EQ(scan.normals.size(), known.normals);
  EXPECT_EQ(scan.facets.size(), known.facets);
  EXPECT_EQ(file.skipped_points, known.skipped_points);
  EXPECT_EQ(file.skipped_facets, 0u);
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& p : scan.points) box.extend(p);
  EXPECT_NEAR(box.diagonal().norm(), known.diagonal, 1e-4 * known.diagonal);
  for (const auto& [name, values] : scan.labels) EXPECT_EQ(values.size(), scan.num_elements());
}

INSTANTIATE_TEST_SUITE_P(All, RealScans,
                         testing::Values(Known{"building.ply", 100000, 100000, 0, 0, 59.812836},
                                         Known{"b9_training.ply", 22300, 0, 0, 0, 146.137645},
                                         Known{"cube.pwn", 50000, 50000, 0, 0, 1.451155},
                                         Known{"urban.las", 13511, 0, 0, 0, 120.435655},
                                         Known{"mvs_building.off", 9708, 0, 19021, 0, 97.154860},
                                         Known{"car_beetle.off", 19887, 0, 38656, 0, 1.131057},
                                         Known{"indoor_office.obj", 14895, 0, 27364, 0, 9.033021},
                                         Known{"indoor_scan000.pcd", 310733, 0, 0, 13996,
                                               533.197673}),
                         [](const auto& test) {
                           std::string name = test.param.name;
                           for (char& c : name) {
                             if (c == '.') c = '_';
                           }
                           return name;
                         });

}  // namespace
}  // namespace gable
