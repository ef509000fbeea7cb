#include <gable/engine/io/answers/annotations_file.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "engine/io/scratch.h"

namespace gable {
namespace {

using ::testing::HasSubstr;

AnnotatedTile sample() {
  AnnotatedHouse pair;
  pair.id = "b1 \"two\"";
  pair.center = {401700.05, 201000.0};
  pair.azimuth = 0.25;
  pair.foundation = Foundation::kII;
  pair.components = {
      {{{401690.0, 201010.0}, {401700.0, 201010.0}, {401690.0, 200990.0}, {401700.0, 200990.0}}},
      {{{401700.0, 201010.0}, {401710.1, 201010.0}, {401700.0, 200990.0}, {401710.1, 200990.0}}}};
  pair.outline = {
      {401690.0, 200990.0}, {401710.1, 200990.0}, {401710.1, 201010.0}, {401690.0, 201010.0}};
  pair.roofs = {RoofType::kGable, RoofType::kHip};
  pair.dormers = {{401695.0, 201000.0}};
  pair.chimneys = {{401696.0, 201001.0}, {401699.0, 201001.0}};
  pair.garages = {{{401680.0, 201000.0}, {401685.0, 201000.0}, {401685.0, 201005.0}}};
  pair.confidence = Confidence::kMedium;
  AnnotatedHouse tree;
  tree.id = "b2";
  tree.foundation = Foundation::kC;
  tree.outline = {{0.0, 0.0}, {4.0, 0.0}, {0.0, 4.0}};
  tree.confidence = Confidence::kHigh;
  return {{"town/dsm.tif", "town/dtm.tif", "town/f.gpkg", "EPSG:27700", 0.5}, {pair, tree}};
}

void expect_equal(const std::vector<Eigen::Vector2d>& a, const std::vector<Eigen::Vector2d>& b,
                  double tolerance) {
  ASSERT_EQ(a.size(), b.size());
  for (size_t i = 0; i < a.size(); ++i) EXPECT_LT((a[i] - b[i]).norm(), tolerance);
}

TEST(AnnotationsFile, IsReadBackAsWritten) {
  const ScratchFolder scratch;
  const std::string path = scratch.path("v.json");
  const AnnotatedTile written = sample();
  write_annotations(path, written);
  const AnnotatedTile read = read_annotations(path);
  EXPECT_EQ(read.source.tile, written.source.tile);
  EXPECT_EQ(read.source.dtm, written.source.dtm);
  EXPECT_EQ(read.source.footprints, written.source.footprints);
  EXPECT_EQ(read.source.crs, written.source.crs);
  EXPECT_EQ(read.source.gsd, written.source.gsd);
  ASSERT_EQ(read.houses.size(), 2u);
  for (size_t i = 0; i < 2; ++i) {
    const AnnotatedHouse& a = read.houses[i];
    const AnnotatedHouse& b = written.houses[i];
    EXPECT_EQ(a.id, b.id);
    EXPECT_EQ(a.azimuth, b.azimuth);
    EXPECT_EQ(a.foundation, b.foundation);
    EXPECT_EQ(a.roofs, b.roofs);
    EXPECT_EQ(a.confidence, b.confidence);
    expect_equal({a.center}, {b.center}, 1e-6);
    expect_equal(a.outline, b.outline, 1e-6);
    expect_equal(a.dormers, b.dormers, 1e-6);
    expect_equal(a.chimneys, b.chimneys, 1e-6);
    ASSERT_EQ(a.components.size(), b.components.size());
    for (size_t k = 0; k < a.components.size(); ++k) {
      for (size_t c = 0; c < 4; ++c) {
        EXPECT_LT((a.components[k][c] - b.components[k][c]).norm(), 1e-6);
      }
    }
    ASSERT_EQ(a.garages.size(), b.garages.size());
    for (size_t k = 0; k < a.garages.size(); ++k) expect_equal(a.garages[k], b.garages[k], 1e-6);
  }
}

TEST(AnnotationsFile, CoordinatesAreRoundedToFiveCentimetres) {
  const ScratchFolder scratch;
  AnnotatedTile tile = sample();
  tile.houses[0].chimneys = {{401696.024, 201001.076}};
  write_annotations(scratch.path("v.json"), tile);
  const Eigen::Vector2d read = read_annotations(scratch.path("v.json")).houses[0].chimneys[0];
  EXPECT_NEAR(read.x(), 401696.0, 1e-6);
  EXPECT_NEAR(read.y(), 201001.1, 1e-6);
}

TEST(AnnotationsFile, MistakesOfEditingAreNamedWithTheirHouse) {
  const ScratchFolder scratch;
  write_annotations(scratch.path("good.json"), sample());
  const std::string good = file_bytes(scratch.path("good.json"));
  const std::pair<const char*, const char*> mistakes[] = {
      {"\"II\"", "\"III\""},
      {"\"II\"", "\"IV\""},
      {"\"II\"", "\"N\""},
      {"[\"gable\",\"hip\"]", "[]"},
      {"\"hip\"", "\"dome\""},
      {"\"azimuth\":0.25", "\"azimuth\":1.6"},
      {"\"medium\"", "\"certain\""},
      {"\"outline\":", "\"line\":"},
      {"[401696,201001]", "[401696]"},
      {"\"center\":[401700.05,201000]", "\"center\":7"}};
  for (const auto& [from, to] : mistakes) {
    std::string bad = good;
    ASSERT_NE(bad.find(from), std::string::npos) << from;
    bad.replace(bad.find(from), std::string(from).size(), to);
    const std::string path = scratch.write("bad.json", bad);
    const Error error = error_of([&] { read_annotations(path); }, path);
    EXPECT_EQ(error.code(), ExitCode::kBadInput);
    EXPECT_THAT(error.what(), HasSubstr("b1")) << bad;
  }
  for (const std::string& text :
       {std::string(), good.substr(0, 90), std::string("[]"), std::string("{\"format\":\"x\"}")}) {
    const std::string path = scratch.write("bad.json", text);
    EXPECT_EQ(error_of([&] { read_annotations(path); }, path).code(), ExitCode::kBadInput);
  }
  const std::string none = scratch.path("none.json");
  EXPECT_EQ(error_of([&] { read_annotations(none); }, none).code(), ExitCode::kNoInput);
}

TEST(AnnotationsFile, AHouseTwiceIsRefused) {
  const ScratchFolder scratch;
  AnnotatedTile tile = sample();
  tile.houses[1].id = tile.houses[0].id;
  write_annotations(scratch.path("v.json"), tile);
  const std::string path = scratch.path("v.json");
  EXPECT_THAT(error_of([&] { read_annotations(path); }, path).what(), HasSubstr("twice"));
}

TEST(AnnotationsFile, TheValidationSetsCanBeReadAndLieWhereTheySay) {
  const std::filesystem::path folder = std::string(GABLE_SOURCE_DIR) + "/training/validation";
  size_t houses = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() != ".json") continue;
    const AnnotatedTile tile = read_annotations(entry.path().string());
    houses += tile.houses.size();
    for (const AnnotatedHouse& house : tile.houses) {
      double farthest = 0.0;
      for (const Eigen::Vector2d& p : house.outline) {
        farthest = std::max(farthest, (p - house.center).norm());
      }
      EXPECT_GT(farthest, 0.5) << house.id;
      EXPECT_LT(farthest, 200.0) << house.id;
    }
  }
  EXPECT_GE(houses, 150u);
}

}  // namespace
}  // namespace gable
