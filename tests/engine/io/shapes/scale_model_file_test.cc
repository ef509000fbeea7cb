#include <gable/engine/error.h>
#include <gable/engine/io/shapes/scale_model_file.h>
#include <gable/engine/scales/train_forest.h>
#include <gable/grammar/random.h>
#include <gtest/gtest.h>

#include "engine/io/scratch.h"

namespace gable {
namespace {

ScaleModel small_model() {
  Random random(1);
  LabelledTrajectory trajectory;
  for (int i = 0; i < 60; ++i) {
    ScaleFeatures features;
    for (float& f : features) f = static_cast<float>(random.uniform(0.0, 1.0));
    trajectory.features.push_back(features);
    trajectory.labels.push_back(i / 15);
  }
  ForestTrainingOptions options;
  options.num_trees = 3;
  ScaleModel model;
  model.name = "garden sheds";
  model.gamma = 0.75;
  model.forest = train_forest({trajectory}, 3, options);
  return model;
}

TEST(ScaleModelFile, WhatIsWrittenIsReadBackEqual) {
  const ScratchFolder scratch;
  const ScaleModel model = small_model();
  const std::string path = scratch.path("sheds.scales");
  write_scale_model(model, path);
  EXPECT_EQ(read_scale_model(path), model);
  EXPECT_EQ(read_scale_model(path).num_scales(), 3);
  EXPECT_EQ(file_bytes(path), scale_model_bytes(model));
}

TEST(ScaleModelFile, BytesAreTheDocumentedOnes) {
  ScaleModel model;
  model.name = "x";
  model.gamma = 2.0;
  model.forest.num_labels = 2;
  model.forest.roots = {0};
  model.forest.nodes = {{1.0f, 17, 2}, {0.0f, -1, 0}, {0.0f, -1, 1}};
  model.forest.leaf_costs = {1, 2, 3, 255};
  const char expected[] =
      "gable scales 1\n"
      "\x01\x00x"                         // name
      "\x00\x00\x00\x00\x00\x00\x00\x40"  // gamma
      "\x02\x01\x00"                      // labels, trees
      "\x11\x00\x00\x80\x3f"              // feature 17 up to 1
      "\xff\x01\x02\xff\x03\xff";         // two leaves
  const std::string bytes = scale_model_bytes(model);
  EXPECT_EQ(bytes.substr(0, bytes.size() - 4), std::string(expected, sizeof(expected) - 1));
}

TEST(ScaleModelFile, EveryTruncationIsRefused) {
  const std::string bytes = scale_model_bytes(small_model());
  for (size_t size = 0; size < bytes.size(); ++size) {
    const Error error = error_of(
        [&] { scale_model_from_bytes(bytes.substr(0, size), "cut.scales"); }, "cut.scales");
    ASSERT_EQ(error.code(), ExitCode::kBadInput) << size;
  }
  error_of([&] { scale_model_from_bytes(bytes + "x", "long.scales"); }, "long.scales");
}

TEST(ScaleModelFile, EveryDamagedByteIsRefused) {
  const std::string bytes = scale_model_bytes(small_model());
  for (size_t i = 0; i < bytes.size(); ++i) {
    std::string damaged = bytes;
    damaged[i] ^= 0x10;
    const Error error =
        error_of([&] { scale_model_from_bytes(damaged, "bad.scales"); }, "bad.scales");
    ASSERT_EQ(error.code(), ExitCode::kBadInput) << i;
  }
}

TEST(ScaleModelFile, ForeignFilesAndOtherVersionsAreNamedAsSuch) {
  const ScratchFolder scratch;
  const std::string ply = scratch.write("scan.ply", "ply\nformat ascii 1.0\n");
  EXPECT_THAT(error_of([&] { read_scale_model(ply); }, ply).what(),
              testing::HasSubstr("is not a scale model; give a file that gable shapes train"));
  const std::string later = scratch.write("later.scales", "gable scales 2\nwho knows what");
  EXPECT_THAT(error_of([&] { read_scale_model(later); }, later).what(),
              testing::HasSubstr("another version"));
  EXPECT_EQ(error_of([&] { read_scale_model(scratch.path("none.scales")); }, "none.scales").code(),
            ExitCode::kNoInput);
}

}  // namespace
}  // namespace gable
