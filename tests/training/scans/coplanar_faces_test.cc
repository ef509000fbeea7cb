#include <gable/training/scans/coplanar_faces.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace gable {
namespace {

using testing::ElementsAre;

/// Strips of unit width side by side along x that rise by the given angles, all 1 m deep in y.
Solid strips(const std::vector<double>& slopes_deg) {
  Solid solid;
  Eigen::Vector3d at = Eigen::Vector3d::Zero();
  solid.vertices = {at, at + Eigen::Vector3d::UnitY()};
  for (const double slope : slopes_deg) {
    const double angle = slope * M_PI / 180.0;
    at += Eigen::Vector3d(std::cos(angle), 0.0, std::sin(angle));
    const int n = static_cast<int>(solid.vertices.size());
    solid.vertices.push_back(at);
    solid.vertices.push_back(at + Eigen::Vector3d::UnitY());
    solid.faces.push_back({{{n - 2, n, n + 1, n - 1}}, SurfaceType::kRoof});
  }
  return solid;
}

TEST(CoplanarFaces, JoinsTouchingFacesOfOnePlane) {
  EXPECT_THAT(coplanar_faces(strips({0, 0, 0.5, 30, 30})), ElementsAre(0, 0, 0, 1, 1));
}

TEST(CoplanarFaces, KeepsFacesApartThatDoNotTouch) {
  EXPECT_THAT(coplanar_faces(strips({0, 60, -60, 0})), ElementsAre(0, 1, 2, 3));
}

TEST(CoplanarFaces, ABentRowDoesNotDriftIntoOnePlane) {
  const std::vector<int> planes =
      coplanar_faces(strips({0, 0.8, 1.6, 2.4, 3.2, 4.0, 4.8, 5.6, 6.4, 7.2}));
  EXPECT_GE(planes.back(), 4);
}

TEST(CoplanarFaces, ComparesTheCornersWithTheLargestFacesPlane) {
  // Half a degree moves the far corner of a strip by 9 mm, that of the next one by 17, then 26.
  EXPECT_THAT(coplanar_faces(strips({0, 0.5, 0.5, 0.5})), ElementsAre(0, 0, 0, 1));
}

TEST(CoplanarFaces, AWideAngleTakesInStepsThatAreLowerThanTheOffset) {
  // A kerb of 2 cm between two flat strips, and one of 10 cm.
  Solid solid = strips({0, 90, 0, 90, 0});
  for (size_t i = 4; i < solid.vertices.size(); ++i) solid.vertices[i].z() *= 0.02;
  for (size_t i = 8; i < solid.vertices.size(); ++i) solid.vertices[i].z() += 0.08;
  CoplanarTolerance wide;
  wide.angle_deg = 90.0;
  wide.offset = 0.05;
  EXPECT_THAT(coplanar_faces(solid, wide), ElementsAre(0, 0, 0, 1, 2));
  wide.angle_deg = 1.0;
  EXPECT_THAT(coplanar_faces(solid, wide), ElementsAre(0, 1, 2, 3, 4));
}

}  // namespace
}  // namespace gable
