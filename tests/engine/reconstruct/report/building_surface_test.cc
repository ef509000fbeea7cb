#include <gable/engine/reconstruct/report/building_surface.h>
#include <gtest/gtest.h>

namespace gable {
namespace {

TEST(BuildingSurface, AnExtrusionsHeightIsItsMeanOverTheSupportTerrainIncluded) {
  Building box;
  box.status = BuildingStatus::kExtrusion;
  box.height = 5.0;
  box.outline = {{{-4.0, -3.0}, {4.0, -3.0}, {4.0, 3.0}, {-4.0, 3.0}}, {}};
  const BuildingSurface surface(box, Eigen::Vector3d(0.0, 0.0, 10.0));
  EXPECT_NEAR(surface.height({0.0, 0.0}, 2.0, -10.5), -5.0, 1e-12);
  EXPECT_NEAR(surface.height({4.0, 0.0}, 2.0, -11.0), -8.0, 1e-12) << "half 5 m, half -1 m";
  EXPECT_NEAR(surface.height({4.0, 3.0}, 2.0, -10.0), -8.75, 1e-12) << "a quarter";
  EXPECT_NEAR(surface.height({6.0, 0.0}, 2.0, -10.0), -10.0, 1e-12);
}

}  // namespace
}  // namespace gable
