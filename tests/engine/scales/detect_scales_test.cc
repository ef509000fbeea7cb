#include <gable/engine/scales/detect_scales.h>
#include <gable/engine/scales/train_scales.h>
#include <gtest/gtest.h>

#include <numeric>

#include "engine/scales/plane_samples.h"

namespace gable {
namespace {

// A box with a chest on its top, twice as fine: 11 faces, of which the chest's are details.
Scan box_with_chest(double noise, uint64_t seed) {
  Scan scan = box_cloud(6000, noise, seed);
  Random random(seed + 100);
  const Eigen::Vector3d o(4.0, 2.5, 4.0), x(1.2, 0, 0), y(0, 1.0, 0), z(0, 0, 0.8);
  add_patch(o + z, x, y, 900, noise, 6, &random, &scan);
  add_patch(o, x, z, 700, noise, 7, &random, &scan);
  add_patch(o + y, x, z, 700, noise, 8, &random, &scan);
  add_patch(o, y, z, 700, noise, 9, &random, &scan);
  add_patch(o + x, y, z, 700, noise, 10, &random, &scan);
  return scan;
}

// Two scales: all faces, and six of them.
ScaleModel chest_model() {
  std::vector<std::vector<ScaleFeatures>> trajectories;
  std::vector<ScaleLabels> known;
  for (uint64_t seed = 1; seed <= 6; ++seed) {
    const CollapsedScan collapsed = collapse_scan(box_with_chest(0.005, seed), {});
    ScaleLabels labels;
    labels.num_configurations = collapsed.trajectory.num_configurations();
    labels.first = {0, std::max(0, collapsed.trajectory.num_first - 6)};
    trajectories.push_back(collapsed.trajectory.features);
    known.push_back(labels);
  }
  ScaleTrainingOptions options;
  options.training_share = 1.0;
  return train_scales("chests", trajectories, known, options).model;
}

TEST(DetectScales, FindsTheScalesThatItsModelKnows) {
  const Scan scan = box_with_chest(0.005, 50);
  const DetectedScales found = detect_scales(scan, chest_model(), {});
  ASSERT_EQ(found.scales.size(), 2u);
  EXPECT_NEAR(static_cast<double>(found.scales[1].shapes.size()), 6.0, 1.0);
  EXPECT_GE(found.scales[0].shapes.size(), 11u);
  for (const ScaleShapes& scale : found.scales) {
    EXPECT_EQ(scale.shape_of.size(), scan.points.size());
    EXPECT_EQ(scale.coverage, found.scales[0].coverage);  // merging loses nothing
    for (const PlanarShape& shape : scale.shapes) EXPECT_GT(shape.area, 0.0);
  }
}

TEST(DetectScales, MeasuresAreasAndPlanesOfTheBox) {
  const DetectedScales found = detect_scales(box_cloud(6000, 0.01, 7), chest_model(), {});
  const ScaleShapes& coarse = found.scales.back();
  double largest = 0.0;
  for (const PlanarShape& shape : coarse.shapes) largest = std::max(largest, shape.area);
  EXPECT_NEAR(largest, 60.0, 3.0);  // 10 x 6 m
}

TEST(DetectScales, KeepsAsManyScalesAsAskedFor) {
  const ScaleModel model = chest_model();
  DetectScalesOptions options;
  options.num_scales = 1;
  const DetectedScales one = detect_scales(box_with_chest(0.005, 51), model, options);
  ASSERT_EQ(one.scales.size(), 1u);
  EXPECT_GT(one.labels.first[0], 0);  // the beginning of the coarse scale changes the shapes
  options.num_scales = 3;
  EXPECT_NE(check(options, model).find("[0, 2]"), std::string::npos);
}

TEST(DetectScales, OfAScanWithoutShapesHaveNone) {
  Scan scan;
  scan.points.assign(40, {1.0, 2.0, 3.0});
  const DetectedScales found = detect_scales(scan, chest_model(), {});
  ASSERT_EQ(found.scales.size(), 2u);
  for (const ScaleShapes& scale : found.scales) {
    EXPECT_TRUE(scale.shapes.empty());
    EXPECT_EQ(scale.shape_of, std::vector<int>(40, -1));
    EXPECT_EQ(scale.configuration, 0);
  }
}

}  // namespace
}  // namespace gable
