#include <gable/engine/io/windows/window_manifest.h>

#include "engine/io/scratch.h"

namespace gable {
namespace {

using ::testing::HasSubstr;

WindowManifest sample() {
  WindowManifest manifest;
  manifest.version = "1.2.3";
  manifest.inputs = {{"surface", "a.tif", 12, "00ff"}, {"terrain", "b \"x\".tif", 1, "0000"}};
  manifest.options = {{"--crs", "EPSG:28992"}, {"--window", "2048"}};
  manifest.windows.resize(3);
  manifest.windows[0].name = "0000_0000";
  manifest.windows[1] = {"0000_0001", true, {{"extrusion", 1}, {"grammar", 4}}, 5,     6,
                         7,           8,    "window_0000_0001.city.jsonl",      "abcd"};
  manifest.windows[2] = {"0000_0002", true, {}, 1, 0, 0, 0, "", ""};
  return manifest;
}

TEST(WindowManifest, IsReadBackAsItWas) {
  const ScratchFolder folder;
  const std::string text = manifest_text(sample());
  const WindowManifest back = read_manifest(folder.write("manifest.json", text));
  EXPECT_EQ(manifest_text(back), text);
  EXPECT_EQ(difference(back, sample()), "");
  EXPECT_EQ(num_buildings(back.windows[1]), 5u);
  EXPECT_FALSE(back.windows[0].done);
  EXPECT_EQ(back.windows[1].unexplained, 8);
  EXPECT_EQ(back.windows[1].hash, "abcd");
}

TEST(WindowManifest, WhatDiffersIsNamed) {
  WindowManifest other = sample();
  other.version = "2";
  EXPECT_THAT(difference(other, sample()), HasSubstr("gable is 2, but was 1.2.3"));
  other = sample();
  other.inputs[0].hash = "0";
  EXPECT_THAT(difference(other, sample()), HasSubstr("surface a.tif has changed"));
  other = sample();
  other.inputs.pop_back();
  EXPECT_THAT(difference(other, sample()), HasSubstr("terrain b \"x\".tif is missing"));
  EXPECT_THAT(difference(sample(), other), HasSubstr("is new"));
  other = sample();
  other.inputs[1].name = "c.tif";
  EXPECT_THAT(difference(other, sample()), HasSubstr("c.tif stands where"));
  other = sample();
  other.options[1].second = "64";
  EXPECT_THAT(difference(other, sample()), HasSubstr("--window is \"64\", but was \"2048\""));
  other.options.pop_back();
  EXPECT_EQ(difference(other, sample()), "the options are others");
  other = sample();
  other.windows[2].name = "0001_0000";
  EXPECT_EQ(difference(other, sample()), "the windows are others");
  other = sample();
  other.windows[0].done = true;
  EXPECT_EQ(difference(other, sample()), "");
}

TEST(WindowManifest, WhatIsNoneIsRefused) {
  const ScratchFolder folder;
  for (const std::string text : {"", "{}", "[]", "{\"kind\":\"x\"}", "text"}) {
    const std::string path = folder.write("manifest.json", text);
    EXPECT_EQ(error_of([&] { read_manifest(path); }, path).code(), ExitCode::kBadInput);
  }
  const std::string text = manifest_text(sample());
  for (size_t size = 0; size + 2 < text.size(); ++size) {
    const std::string path = folder.write("manifest.json", text.substr(0, size));
    EXPECT_EQ(error_of([&] { read_manifest(path); }, path).code(), ExitCode::kBadInput);
  }
}

}  // namespace
}  // namespace gable
