#include <gable/engine/io/shapes/trajectory_json.h>

#include "engine/io/scratch.h"

namespace gable {
namespace {

/// Five first shapes that all merge but one.
TrajectoryFile sample() {
  TrajectoryFile file;
  FirstShapes& first = file.first_shapes;
  first.shape_of = {0, 1, 1, -1, 2, 3, 4, 4, -1};
  first.diagonal = 59.812836;
  for (int i = 0; i < 5; ++i) {
    PointMoments& moments = first.moments.emplace_back();
    moments.reference = {85062.75, 447412.1, 0.1};
    for (int k = 0; k < 4; ++k) moments.add({i + 85062.1, k / 3.0, i * k / 7.0}, 1.0 / (k + 3));
  }
  first.adjacent = {{0, 1}, {1, 2}, {3, 4}};
  file.trajectory.num_first = 5;
  file.trajectory.merges = {{0, 1, 0.1 / 3}, {3, 4, 0.05}, {2, 5, 1.0 / 7}};
  file.trajectory.features.resize(4);
  for (int i = 0; i < 4; ++i) file.trajectory.features[i].fill(1.0f / static_cast<float>(i + 3));
  file.scales.first = {1, 1, 3};
  file.scales.num_configurations = 4;
  return file;
}

std::string written() {
  const ScratchFolder scratch;
  write_trajectory_json(scratch.path("trajectory.json"), sample());
  return file_bytes(scratch.path("trajectory.json"));
}

TrajectoryFile read(const std::string& text) {
  const ScratchFolder scratch;
  return read_trajectory_json(scratch.write("trajectory.json", text));
}

void expect_refused(const std::string& from, const std::string& to, const std::string& words) {
  std::string text = written();
  const size_t at = text.find(from);
  ASSERT_NE(at, std::string::npos) << from;
  const Error error = error_of([&] { read(text.replace(at, from.size(), to)); }, "trajectory.json");
  EXPECT_EQ(error.code(), ExitCode::kBadInput);
  EXPECT_THAT(error.what(), testing::HasSubstr(words));
}

TEST(TrajectoryJson, GivesBackEveryBit) {
  const TrajectoryFile got = read(written()), want = sample();
  EXPECT_EQ(got.first_shapes.shape_of, want.first_shapes.shape_of);
  EXPECT_EQ(got.first_shapes.diagonal, want.first_shapes.diagonal);
  EXPECT_EQ(got.first_shapes.adjacent, want.first_shapes.adjacent);
  ASSERT_EQ(got.first_shapes.moments.size(), want.first_shapes.moments.size());
  for (size_t i = 0; i < got.first_shapes.moments.size(); ++i) {
    EXPECT_EQ(got.first_shapes.moments[i].reference, want.first_shapes.moments[i].reference);
    EXPECT_EQ(got.first_shapes.moments[i].weight, want.first_shapes.moments[i].weight);
    EXPECT_EQ(got.first_shapes.moments[i].sum, want.first_shapes.moments[i].sum);
    const Eigen::Matrix3d lower =
        want.first_shapes.moments[i].squares.triangularView<Eigen::Lower>();
    const Eigen::Matrix3d& squares = got.first_shapes.moments[i].squares;
    EXPECT_EQ(Eigen::Matrix3d(squares.triangularView<Eigen::Lower>()), lower);
    EXPECT_EQ(squares, squares.transpose());
  }
  EXPECT_EQ(got.trajectory.num_first, 5);
  EXPECT_EQ(got.trajectory.merges, want.trajectory.merges);
  EXPECT_EQ(got.trajectory.features, want.trajectory.features);
  EXPECT_EQ(got.scales.first, want.scales.first);
  EXPECT_EQ(got.scales.num_configurations, 4);
}

TEST(TrajectoryJson, RefusesWhatDoesNotFitTogether) {
  expect_refused("gable trajectory", "other", "format");
  expect_refused("\"version\":1", "\"version\":2", "version");
  expect_refused("[0,1,1,-1,2", "[0,1,1,-2,2", "shape_of");
  expect_refused("[0,1,1,-1,2", "[0,1,1,5,2", "shape_of");
  expect_refused("[0,1,1,-1,2", "[0,1,1,0.5,2", "shape_of");
  expect_refused("[[0,1],[1,2],[3,4]]", "[[0,1],[1,1]]", "adjacent");
  expect_refused("[2,5,", "[2,7,", "merges");
  expect_refused("[2,5,", "[2,4,", "twice");
  expect_refused("\"scales\":[1,1,3]", "\"scales\":[1,0,3]", "scales");
  expect_refused("\"scales\":[1,1,3]", "\"scales\":[1,1,5]", "scales");
  expect_refused("\"merges\"", "\"mergers\"", "no trajectory");
  expect_refused("\"diagonal\":5", "\"diagonal\":[5", "no trajectory");
  const std::string text = written();
  const ScratchFolder scratch;
  for (const size_t size : {size_t{0}, size_t{10}, text.size() / 2, text.size() - 3}) {
    const std::string path = scratch.write("cut.json", text.substr(0, size));
    EXPECT_EQ(error_of([&] { read_trajectory_json(path); }, path).code(), ExitCode::kBadInput);
  }
}

TEST(TrajectoryJson, SaysThatAFileIsMissing) {
  const ScratchFolder scratch;
  const std::string path = scratch.path("none.json");
  EXPECT_EQ(error_of([&] { read_trajectory_json(path); }, path).code(), ExitCode::kNoInput);
}

}  // namespace
}  // namespace gable
