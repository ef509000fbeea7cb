#include <gable/engine/io/answers/answers_file.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/io/scratch.h"

namespace gable {
namespace {

using ::testing::HasSubstr;

HouseAnswers sample() {
  HouseAnswer house;
  house.id = "b1";
  house.sheet = "sheet_001.png";
  house.frame = {0.1234567890123, {401574.33743129, 201345.7285}, 0.30682942};
  house.proposed = "U";
  house.foundation = Foundation::kI;
  house.rectangles = {{10.0, 50.0, 12.5, 40.1}};
  house.roofs = {RoofType::kHip};
  house.chimneys = {{20.0, 21.0}};
  house.garages = {{{1.0, 2.0}, {3.0, 2.0}, {3.0, 4.0}}};
  house.confidence = Confidence::kHigh;
  house.reviewed = true;
  HouseAnswer open;
  open.id = "b2";
  open.foundation = Foundation::kC;
  open.polygon = {{1.0, 1.0}, {9.0, 1.0}, {5.0, 8.0}};
  return {{"town/dsm.tif", "", "", "EPSG:27700", 1.0}, {house, open}};
}

TEST(AnswersFile, IsReadBackAsWritten) {
  const ScratchFolder scratch;
  const HouseAnswers written = sample();
  write_answers(scratch.path("a.json"), written);
  const HouseAnswers read = read_answers(scratch.path("a.json"));
  EXPECT_EQ(read.source.tile, written.source.tile);
  EXPECT_EQ(read.source.dtm, written.source.dtm);
  EXPECT_EQ(read.source.footprints, written.source.footprints);
  EXPECT_EQ(read.source.crs, written.source.crs);
  EXPECT_EQ(read.source.gsd, written.source.gsd);
  ASSERT_EQ(read.houses.size(), 2u);
  const HouseAnswer& a = read.houses[0];
  const HouseAnswer& b = written.houses[0];
  EXPECT_EQ(a.id, b.id);
  EXPECT_EQ(a.sheet, b.sheet);
  EXPECT_EQ(a.frame.azimuth, b.frame.azimuth);
  EXPECT_EQ(a.frame.north_west, b.frame.north_west);
  EXPECT_EQ(a.frame.pixel, b.frame.pixel);
  EXPECT_EQ(a.proposed, b.proposed);
  EXPECT_EQ(a.foundation, b.foundation);
  ASSERT_EQ(a.rectangles.size(), 1u);
  EXPECT_EQ(a.rectangles[0].y0, 12.5);
  EXPECT_EQ(a.rectangles[0].y1, 40.1);
  EXPECT_EQ(a.roofs, b.roofs);
  EXPECT_EQ(a.chimneys, b.chimneys);
  EXPECT_EQ(a.garages, b.garages);
  EXPECT_EQ(a.confidence, b.confidence);
  EXPECT_TRUE(a.reviewed);
  EXPECT_EQ(read.houses[1].polygon, written.houses[1].polygon);
  EXPECT_FALSE(read.houses[1].confidence.has_value());
  EXPECT_FALSE(read.houses[1].reviewed);
}

TEST(AnswersFile, MistakesOfEditingAreNamedWithTheirHouse) {
  const ScratchFolder scratch;
  write_answers(scratch.path("good.json"), sample());
  const std::string good = file_bytes(scratch.path("good.json"));
  const std::pair<const char*, const char*> mistakes[] = {
      {"[10,12.5,50,40.1]", "[10,12.5,50]"},
      {"\"I\"", "\"J\""},
      {"[\"hip\"]", "[\"hipped\"]"},
      {"\"high\"", "\"sure\""},
      {"true", "\"yes\""},
      {"[[20,21]]", "[[20,\"21\"]]"},
      {"\"pixel\":0.30682942", "\"pixel\":0"},
      {"\"garages\"", "\"garage\""},
      {"[[[1,2],[3,2],[3,4]]]", "[[[1,2],[3,2]]]"}};
  for (const auto& [from, to] : mistakes) {
    std::string bad = good;
    ASSERT_NE(bad.find(from), std::string::npos) << from;
    bad.replace(bad.find(from), std::string(from).size(), to);
    const std::string path = scratch.write("bad.json", bad);
    const Error error = error_of([&] { read_answers(path); }, path);
    EXPECT_EQ(error.code(), ExitCode::kBadInput);
    EXPECT_THAT(error.what(), HasSubstr("b1")) << to;
  }
  const std::string cut = scratch.write("cut.json", good.substr(0, good.size() / 2));
  EXPECT_EQ(error_of([&] { read_answers(cut); }, cut).code(), ExitCode::kBadInput);
  const std::string none = scratch.path("none.json");
  EXPECT_EQ(error_of([&] { read_answers(none); }, none).code(), ExitCode::kNoInput);
}

}  // namespace
}  // namespace gable
