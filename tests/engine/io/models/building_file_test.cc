#include <gable/engine/io/models/building_file.h>
#include <gable/engine/io/models/model_writer.h>

#include "engine/io/sample_building.h"
#include "engine/io/scratch.h"

namespace gable {
namespace {

/// A CityJSON file of the sample house in which one text is replaced by another.
std::string damaged(const ScratchFolder& scratch, const std::string& from, const std::string& to) {
  const std::string path = scratch.path("in.city.jsonl");
  const auto writer = open_model_writer(path, {});
  writer->append(sample_house("b7"), {});
  writer->close();
  std::string text = file_bytes(path);
  const size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return scratch.write("in.city.jsonl", text.replace(at, from.size(), to));
}

Error reading_error(const std::string& path) {
  return error_of([&] { read_buildings(path); }, path);
}

TEST(BuildingFile, MissingFileCannotBeOpened) {
  const ScratchFolder scratch;
  EXPECT_EQ(reading_error(scratch.path("no.city.json")).code(), ExitCode::kNoInput);
  EXPECT_EQ(reading_error(scratch.path("")).code(), ExitCode::kNoInput);
}

TEST(BuildingFile, MalformedJsonNamesTheLine) {
  const ScratchFolder scratch;
  const Error seq = reading_error(damaged(scratch, "\"vertices\":[]}\n{", "\"vertices\":[]}\n"));
  EXPECT_EQ(seq.code(), ExitCode::kBadInput);
  EXPECT_THAT(seq.what(), testing::HasSubstr("in.city.jsonl:2: is not valid JSON"));
  EXPECT_EQ(reading_error(scratch.write("a.city.json", "{\"type\":")).code(), ExitCode::kBadInput);
  EXPECT_EQ(reading_error(scratch.write("b.city.json", "")).code(), ExitCode::kBadInput);
}

TEST(BuildingFile, OtherJsonIsNotCityJson) {
  const ScratchFolder scratch;
  for (const char* text : {"[]", "3", "{\"type\":\"FeatureCollection\"}", "{\"type\":[]}",
                           "{\"type\":\"CityJSON\",\"CityObjects\":[]}"}) {
    const Error error = reading_error(scratch.write("a.city.json", text));
    EXPECT_EQ(error.code(), ExitCode::kBadInput);
    EXPECT_THAT(error.what(), testing::HasSubstr("is not CityJSON"));
  }
}

TEST(BuildingFile, ModelsOfOtherProgramsAreRefused) {
  const ScratchFolder scratch;
  const Error error = reading_error(scratch.write(
      "a.city.json", R"({"type":"CityJSON","CityObjects":{"x":{"type":"Building"}}})"));
  EXPECT_EQ(error.code(), ExitCode::kBadInput);
  EXPECT_THAT(error.what(),
              testing::HasSubstr("building \"x\": has no attribute gable_derivation"));
}

TEST(BuildingFile, FilesWithoutBuildingsAreRefused) {
  const ScratchFolder scratch;
  const std::string path =
      scratch.write("a.city.json", R"({"type":"CityJSON","CityObjects":{"t":{"type":"Road"}}})");
  EXPECT_THAT(reading_error(path).what(), testing::HasSubstr("holds no building"));
}

TEST(BuildingFile, DamagedDerivationsSayWhatIsWrong) {
  const std::pair<const char*, std::pair<const char*, const char*>> cases[] = {
      {"\"rule\":\"roof_hip\"", {"\"rule\":\"roof_onion\"", "no rule is called \"roof_onion\""}},
      {"\"foundation\":\"L\"", {"\"foundation\":\"X\"", "no foundation is called \"X\""}},
      {"\"foundation\":\"L\"", {"\"foundation\":\"I\"", "do not form a house of foundation I"}},
      {"\"hip_end\":0.25", {"\"hip_end\":null", "roof_hip.hip_end is not a number"}},
      {"\"hip_end\":0.25", {"\"hip\":0.25", "lacks \"hip_end\""}},
      {"\"component\":1", {"\"component\":9", "do not form a house"}},
      {"\"ridge\":\"y\"", {"\"ridge\":\"z\"", "a ridge is neither"}},
      {"\"rules\":[{",
       {"\"rules\":[{\"rule\":\"azimuth\",\"parameters\":{\"azimuth\":0}},{",
        "do not form a house"}},
  };
  for (const auto& [from, to] : cases) {
    const ScratchFolder scratch;
    const Error error = reading_error(damaged(scratch, from, to.first));
    EXPECT_EQ(error.code(), ExitCode::kBadInput);
    EXPECT_THAT(error.what(), testing::HasSubstr(to.second));
    EXPECT_THAT(error.what(), testing::HasSubstr("building \"b7\""));
  }
}

}  // namespace
}  // namespace gable
