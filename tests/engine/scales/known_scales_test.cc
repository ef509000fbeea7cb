#include <gable/engine/scales/collapse.h>
#include <gable/engine/scales/known_scales.h>
#include <gable/grammar/random.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace gable {
namespace {

// Panoptic quality from its definition, pair by pair.
double slow_quality(const std::vector<int>& truth, const std::vector<int>& shape_of) {
  const std::set<int> planes = [&] {
    std::set<int> out(truth.begin(), truth.end());
    out.erase(-1);
    return out;
  }();
  std::set<int> shapes(shape_of.begin(), shape_of.end());
  shapes.erase(-1);
  double sum = 0.0;
  for (int plane : planes) {
    for (int shape : shapes) {
      double common = 0.0, either = 0.0;
      for (size_t i = 0; i < truth.size(); ++i) {
        if (truth[i] < 0) continue;
        common += truth[i] == plane && shape_of[i] == shape;
        either += truth[i] == plane || shape_of[i] == shape;
      }
      if (common > 0.5 * either) sum += common / either;
    }
  }
  return sum / (0.5 * static_cast<double>(planes.size() + shapes.size()));
}

struct Scene {
  FirstShapes first;
  Trajectory trajectory;
  std::vector<int> truth;
};

Scene random_scene(uint64_t seed) {
  Random random(seed);
  Scene scene;
  const int shapes = 12, elements = 300;
  scene.first.diagonal = 10.0;
  scene.first.moments.resize(shapes);
  for (int i = 0; i < elements; ++i) {
    const int shape = random.integer(-1, shapes - 1);
    scene.first.shape_of.push_back(shape);
    scene.truth.push_back(random.chance(0.1) ? -1 : (shape < 0 ? 0 : shape / 3));
    if (shape < 0) continue;
    scene.first.moments[shape].add({random.normal(1), random.normal(1), random.normal(0.2)});
  }
  for (int a = 0; a < shapes; ++a) {
    for (int b = a + 1; b < shapes; ++b) {
      if (random.chance(0.4)) scene.first.adjacent.push_back({a, b});
    }
  }
  scene.trajectory = collapse(scene.first);
  return scene;
}

TEST(KnownScales, AgreeAsTheDefinitionSaysAtEveryStep) {
  for (uint64_t seed = 1; seed <= 10; ++seed) {
    const Scene scene = random_scene(seed);
    const std::vector<double> agreement =
        agreement_with(scene.truth, scene.first, scene.trajectory);
    ASSERT_EQ(static_cast<int>(agreement.size()), scene.trajectory.num_configurations());
    for (int c = 0; c < scene.trajectory.num_configurations(); ++c) {
      const std::vector<int> shape_of_first = shapes_at(scene.trajectory, c);
      std::vector<int> shape_of = scene.first.shape_of;
      for (int& s : shape_of) s = s < 0 ? -1 : shape_of_first[s];
      EXPECT_NEAR(agreement[c], slow_quality(scene.truth, shape_of), 1e-12) << seed << " " << c;
    }
  }
}

TEST(KnownScales, AreTheBestOfAllOrderedChoices) {
  for (uint64_t seed = 1; seed <= 10; ++seed) {
    const Scene scene = random_scene(20 + seed);
    std::vector<int> coarse = scene.truth;
    for (int& plane : coarse) plane = plane < 0 ? -1 : plane / 2;
    const std::vector<double> fine = agreement_with(scene.truth, scene.first, scene.trajectory);
    const std::vector<double> rough = agreement_with(coarse, scene.first, scene.trajectory);
    double best = -1.0;
    for (size_t a = 0; a < fine.size(); ++a) {
      for (size_t b = a; b < rough.size(); ++b) best = std::max(best, fine[a] + rough[b]);
    }
    const ScaleLabels labels =
        known_scales({scene.truth, scene.truth, coarse}, scene.first, scene.trajectory);
    EXPECT_EQ(labels.first[0], 0);
    ASSERT_LE(labels.first[1], labels.first[2]);
    EXPECT_NEAR(fine[labels.first[1]] + rough[labels.first[2]], best, 1e-12) << seed;
  }
}

TEST(KnownScales, BeginWhereShapesAreTheKnownPlanes) {
  Scene scene = random_scene(99);
  const int at = scene.trajectory.num_configurations() / 2;
  const std::vector<int> shape_of_first = shapes_at(scene.trajectory, at);
  for (size_t i = 0; i < scene.truth.size(); ++i) {
    const int s = scene.first.shape_of[i];
    scene.truth[i] = s < 0 ? -1 : shape_of_first[s];
  }
  EXPECT_EQ(known_scales({scene.truth, scene.truth}, scene.first, scene.trajectory).first,
            (std::vector<int>{0, at}));
}

}  // namespace
}  // namespace gable
