#include <gable/engine/io/shapes/scale_labels_file.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/io/scratch.h"

namespace gable {
namespace {

using ::testing::HasSubstr;

ScaleLabelsFile sample() {
  return {2, {{"scans/a \"b\".ply", {{3, 9}, 10}, true}, {"c.off", {{0, 7}, 7}, false}}};
}

TEST(ScaleLabelsFile, IsReadBackAsWritten) {
  const ScratchFolder scratch;
  const std::string path = scratch.path("labels.json");
  write_scale_labels(path, sample());
  const ScaleLabelsFile read = read_scale_labels(path);
  EXPECT_EQ(read.num_scales, 2);
  ASSERT_EQ(read.scans.size(), 2u);
  for (size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(read.scans[i].file, sample().scans[i].file);
    EXPECT_EQ(read.scans[i].labels.first, sample().scans[i].labels.first);
    EXPECT_EQ(read.scans[i].labels.num_configurations, sample().scans[i].labels.num_configurations);
    EXPECT_EQ(read.scans[i].known, sample().scans[i].known);
  }
}

TEST(ScaleLabelsFile, MistakesOfEditingAreNamedWithTheirScan) {
  const ScratchFolder scratch;
  const std::string good =
      R"({"format":"gable scale labels","version":1,"scales":2,"scans":[)"
      R"({"file":"c.off","configurations":7,"first":[0,7],"source":"proposed"}]})";
  scratch.write("good.json", good);
  EXPECT_EQ(read_scale_labels(scratch.path("good.json")).scans.size(), 1u);
  const std::pair<const char*, const char*> mistakes[] = {
      {"[0,7]", "[5,4]"},   {"[0,7]", "[0,8]"},    {"[0,7]", "[0]"},          {"[0,7]", "[-1,3]"},
      {"[0,7]", "[0.5,3]"}, {"[0,7]", "\"none\""}, {"\"proposed\"", "\"?\""}, {":7,", ":0,"}};
  for (const auto& [from, to] : mistakes) {
    std::string bad = good;
    bad.replace(bad.find(from), std::string(from).size(), to);
    const std::string path = scratch.write("bad.json", bad);
    const Error error = error_of([&] { read_scale_labels(path); }, path);
    EXPECT_EQ(error.code(), ExitCode::kBadInput);
    EXPECT_THAT(error.what(), HasSubstr("c.off")) << bad;
  }
  for (const std::string& text :
       {std::string(), good.substr(0, 60), std::string("[]"), std::string("{\"format\":\"x\"}")}) {
    const std::string path = scratch.write("bad.json", text);
    EXPECT_EQ(error_of([&] { read_scale_labels(path); }, path).code(), ExitCode::kBadInput);
  }
  const std::string none = scratch.path("none.json");
  EXPECT_EQ(error_of([&] { read_scale_labels(none); }, none).code(), ExitCode::kNoInput);
}

TEST(ScaleLabelsFile, NamesScansFromItsOwnFolder) {
  EXPECT_EQ(name_in_labels("data/scans/a.ply", "data/labels.json"), "scans/a.ply");
  EXPECT_EQ(name_in_labels("./a.ply", "labels.json"), "a.ply");
  EXPECT_EQ(name_in_labels("a.ply", "out/labels.json"), "../a.ply");
}

}  // namespace
}  // namespace gable
