#include <gable/engine/io/shapes/labelled_ply.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>
#include <utility>

#include "cli/sample_house.h"
#include "cli/shapes_folder.h"

namespace gable {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// How often each edge of an OBJ file's facets is run through, one way and the other.
bool is_closed(const std::string& obj) {
  std::map<std::pair<int, int>, int> balance;
  std::istringstream lines(obj);
  for (std::string line; std::getline(lines, line);) {
    if (line.rfind("f ", 0) != 0) continue;
    std::istringstream words(line.substr(2));
    std::vector<int> corners;
    for (std::string word; words >> word;) corners.push_back(std::stoi(word));
    for (size_t i = 0; i < corners.size(); ++i) {
      const int a = corners[i], b = corners[(i + 1) % corners.size()];
      balance[std::minmax(a, b)] += a < b ? 1 : -1;
    }
  }
  for (const auto& [edge, sum] : balance) {
    if (sum != 0) return false;
  }
  return !balance.empty();
}

TEST(ShapesSolids, EveryScaleIsAClosedModelWithItsFigures) {
  const ShapesFolder folder;
  const ProgramRun run = folder.shapes(folder.scan(), {"--solids", folder.path("solids")});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(run.err, "");
  EXPECT_EQ(num_lines(run.out), 8) << run.out;
  EXPECT_THAT(folder.files("solids"),
              ElementsAre("solid-1.obj", "solid-2.obj", "solid-3.obj", "solids.json"));
  const auto json = nlohmann::json::parse(file_bytes(folder.path("solids/solids.json")));
  ASSERT_EQ(json["solids"].size(), 3u);
  double rms = 0.0;
  int facets = 1000;
  for (int k = 0; k < 3; ++k) {
    const auto& solid = json["solids"][k];
    EXPECT_EQ(solid["scale"], k + 1);
    EXPECT_EQ(solid["file"], "solid-" + std::to_string(k + 1) + ".obj");
    EXPECT_GE(solid["planes"].get<int>(), 1);
    // Farther from the scan and smaller from scale to scale.
    EXPECT_GE(solid["rms"].get<double>(), rms);
    EXPECT_LE(solid["facets"].get<int>(), facets);
    rms = solid["rms"];
    facets = solid["facets"];
    EXPECT_LT(solid["mean"].get<double>(), rms);
    EXPECT_TRUE(is_closed(file_bytes(folder.path("solids/" + solid["file"].get<std::string>()))));
  }
}

TEST(ShapesSolids, WhatCannotBeClosedIsRefusedAndNothingIsWritten) {
  const ShapesFolder folder;
  // A house of millimetres is none.
  Scan scan = sample_house(1);
  for (Eigen::Vector3d& p : scan.points) p *= 0.01;
  write_scan_ply(folder.path("small.ply"), scan);
  const ProgramRun run =
      folder.shapes(folder.path("small.ply"), {"--solids", folder.path("solids")});
  EXPECT_EQ(run.exit_code, 4);
  EXPECT_EQ(num_lines(run.err), 1) << run.err;
  EXPECT_THAT(run.err, HasSubstr("small.ply: no scale can be closed into a solid"));
  EXPECT_THAT(run.err, HasSubstr("not the size of a building in metres"));
  EXPECT_FALSE(std::filesystem::exists(folder.path("solids")));
  EXPECT_FALSE(std::filesystem::exists(folder.out()));
}

}  // namespace
}  // namespace gable
