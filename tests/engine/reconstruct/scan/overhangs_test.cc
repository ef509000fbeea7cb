#include <gable/engine/reconstruct/scan/overhangs.h>
#include <gtest/gtest.h>

#include <vector>

namespace gable {
namespace {

// A wall along y = 0 from x = 0 to 10, 3 m high, with its outside where y is negative.
WallTrace wall() {
  WallTrace trace;
  trace.line.normal = {0, -1};
  trace.line.offset = 0.0;
  trace.line.begin = 0.0;  // the direction is x
  trace.line.end = 10.0;
  trace.high = 3.0;
  return trace;
}

// A level roof of shape 0 over y in [from, 6), at a height.
void add_roof(double from, double height, std::vector<SurfaceSample>* samples) {
  for (double y = from + 0.05; y < 6.0; y += 0.1) {
    for (double x = 0.25; x < 10; x += 0.5) samples->push_back({{x, y, height}, 1.0, 0});
  }
}

TEST(Overhangs, RoofBeyondItsWallIsOne) {
  std::vector<SurfaceSample> samples;
  add_roof(-0.8, 3.1, &samples);
  samples.push_back({{5, -0.5, 0.5}, 1.0, 0});   // the ground below
  samples.push_back({{5, -0.5, 3.0}, 1.0, 1});   // a wall's
  samples.push_back({{5, -0.5, 3.0}, 1.0, -1});  // nobody's
  const auto overhangs = find_overhangs(samples, {true, false}, {wall()}, 1.0);
  for (size_t i = 0; i < samples.size(); ++i) {
    const SurfaceSample& s = samples[i];
    EXPECT_EQ(overhangs[i], s.point.y() < 0.0 && s.point.z() > 2.0 && s.shape == 0) << i;
  }
}

TEST(Overhangs, RoofAroundTheCornerOfTwoWallsIsOne) {
  WallTrace side = wall();  // along x = 0, its outside where x is negative
  side.line.normal = {-1, 0};
  side.line.begin = -6.0;  // the direction is -y
  side.line.end = 0.0;
  std::vector<SurfaceSample> samples;
  for (double y = -0.75; y < 6; y += 0.5) {
    for (double x = -0.75; x < 10; x += 0.5) samples.push_back({{x, y, 3.1}, 1.0, 0});
  }
  const auto overhangs = find_overhangs(samples, {true}, {wall(), side}, 1.0);
  for (size_t i = 0; i < samples.size(); ++i) {
    EXPECT_EQ(overhangs[i], samples[i].point.x() < 0 || samples[i].point.y() < 0) << i;
  }
}

TEST(Overhangs, RoofOverAWallInFrontOfAnotherIsNone) {
  std::vector<SurfaceSample> samples;
  add_roof(-0.8, 3.1, &samples);
  for (double x = 0.05; x < 10; x += 0.1) {
    for (double z = 0.05; z < 3; z += 0.1) {
      samples.push_back({{x, 0, z}, 1.0, 1});
      samples.push_back({{x, -0.8, z}, 1.0, 1});
    }
  }
  for (const bool overhang : find_overhangs(samples, {true, false}, {wall()}, 1.0)) {
    EXPECT_FALSE(overhang);
  }
}

TEST(Overhangs, WhatGoesOnBeyondAWallIsNone) {
  std::vector<SurfaceSample> samples;
  add_roof(-6.0, 3.1, &samples);  // a wall between two halves
  for (const bool overhang : find_overhangs(samples, {true}, {wall()}, 1.0)) {
    EXPECT_FALSE(overhang);
  }
  samples.clear();
  add_roof(-0.8, 8.0, &samples);
  for (const bool overhang : find_overhangs(samples, {true}, {}, 1.0)) EXPECT_FALSE(overhang);
}

}  // namespace
}  // namespace gable
