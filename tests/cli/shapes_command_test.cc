#include <gable/engine/io/scans/scan_file.h>
#include <gable/engine/io/shapes/labelled_ply.h>
#include <gable/engine/io/shapes/trajectory_json.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>

#include "cli/sample_house.h"
#include "cli/shapes_folder.h"

namespace gable {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

TEST(ShapesCommand, WritesAllFilesOfEveryScaleAndTheTrajectory) {
  const ShapesFolder folder;
  const ProgramRun run = folder.shapes(folder.scan(), {"--report", folder.path("report")});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(run.err, "");
  EXPECT_EQ(num_lines(run.out), 4) << run.out;
  EXPECT_THAT(
      folder.files("out"),
      ElementsAre("scale-1.json", "scale-1.obj", "scale-1.ply", "scale-2.json", "scale-2.obj",
                  "scale-2.ply", "scale-3.json", "scale-3.obj", "scale-3.ply", "trajectory.json"));
  EXPECT_THAT(folder.files("report"), testing::Contains("index.html"));
}

TEST(ShapesCommand, FilesOfAScaleAgreeWithEachOtherAndTheTrajectory) {
  const ShapesFolder folder;
  ASSERT_EQ(folder.shapes(folder.scan()).exit_code, 0);
  const Scan scan = read_scan(folder.scan());
  const TrajectoryFile trajectory = read_trajectory_json(folder.path("out/trajectory.json"));
  ASSERT_EQ(trajectory.scales.num_scales(), 3);
  for (int k = 1; k <= 3; ++k) {
    const std::string stem = folder.path("out/scale-" + std::to_string(k));
    const Scan labelled = read_scan(stem + ".ply");
    EXPECT_EQ(labelled.points, scan.points);
    const std::vector<int>& shape_of = labelled.labels.at("shape");
    const auto json = nlohmann::json::parse(file_bytes(stem + ".json"));
    EXPECT_EQ(json["configuration"], trajectory.scales.first[k - 1]);
    EXPECT_EQ(static_cast<int>(json["shapes"].size()),
              trajectory.trajectory.num_shapes(trajectory.scales.first[k - 1]));
    for (const auto& shape : json["shapes"]) {
      EXPECT_EQ(std::count(shape_of.begin(), shape_of.end(), shape["shape"].get<int>()),
                shape["inliers"].get<int>());
      EXPECT_FALSE(shape["polygons"].empty());
    }
    EXPECT_THAT(file_bytes(stem + ".obj"), HasSubstr("shape_0"));
  }
}

TEST(ShapesCommand, AHouseHasItsFacesAtTheScaleOfItsStructure) {
  const ShapesFolder folder;
  ASSERT_EQ(folder.shapes(folder.scan()).exit_code, 0);
  const Scan scan = read_scan(folder.scan());
  const std::vector<int> shape_of = read_scan(folder.path("out/scale-1.ply")).labels.at("shape");
  // The walls and slopes, planes 0 to 5, each lie for the most part in a shape of their own.
  std::set<int> shapes;
  for (int plane = 0; plane < 6; ++plane) {
    std::map<int, int> count;
    int all = 0;
    for (size_t i = 0; i < shape_of.size(); ++i) {
      if (scan.labels.at("scale_1")[i] == plane) ++all, ++count[shape_of[i]];
    }
    const auto most = std::max_element(count.begin(), count.end(),
                                       [](auto& a, auto& b) { return a.second < b.second; });
    EXPECT_GT(most->second, 0.8 * all) << plane;
    EXPECT_TRUE(shapes.insert(most->first).second) << plane;
  }
}

TEST(ShapesCommand, TheSameBytesOnOneThreadAndOnTwo) {
  const ShapesFolder folder;
  std::vector<std::string> bytes[2];
  std::vector<std::string> names[2];
  for (const int threads : {1, 2}) {
    ASSERT_EQ(folder
                  .shapes(folder.scan(), {"--threads", std::to_string(threads), "--report",
                                          folder.out() + "/report"})
                  .exit_code,
              0);
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder.out())) {
      if (entry.is_regular_file()) names[threads - 1].push_back(entry.path().string());
    }
    std::sort(names[threads - 1].begin(), names[threads - 1].end());
    for (const std::string& name : names[threads - 1]) {
      bytes[threads - 1].push_back(file_bytes(name));
    }
    std::filesystem::remove_all(folder.out());
  }
  EXPECT_EQ(names[0], names[1]);
  EXPECT_GT(names[0].size(), 10u);
  EXPECT_TRUE(bytes[0] == bytes[1]);
}

TEST(ShapesCommand, FewerScalesReplaceMore) {
  const ShapesFolder folder;
  folder.write("note.txt", "kept");
  std::filesystem::create_directory(folder.out());
  std::filesystem::copy(folder.path("note.txt"), folder.out());
  ASSERT_EQ(folder.shapes(folder.scan()).exit_code, 0);
  const ProgramRun run = folder.shapes(folder.scan(), {"--scales", "1", "--no-refit"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(num_lines(run.out), 2);
  EXPECT_THAT(folder.files("out"), ElementsAre("note.txt", "scale-1.json", "scale-1.obj",
                                               "scale-1.ply", "trajectory.json"));
}

TEST(ShapesCommand, PointsThatAreNotFiniteAreSaidAndLeftOut) {
  const ShapesFolder folder;
  const Scan scan = sample_house(1);
  std::string text;
  for (size_t i = 0; i < scan.points.size(); ++i) {
    if (i % 100 == 0) text += i % 200 == 0 ? "nan 1 2\n" : "1 inf 2\n";
    for (int k = 0; k < 3; ++k) text += std::to_string(scan.points[i][k]) + (k < 2 ? " " : "\n");
  }
  const ProgramRun run = folder.shapes(folder.write("nan.xyz", text));
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(num_lines(run.err), 1) << run.err;
  EXPECT_THAT(run.err, HasSubstr("skipped 60 points"));
  EXPECT_EQ(read_scan(folder.path("out/scale-1.ply")).points.size(), scan.points.size());
  const ProgramRun quiet = folder.shapes(folder.path("nan.xyz"), {"--quiet"});
  EXPECT_EQ(quiet.err, "");
  EXPECT_EQ(quiet.out, run.out);
}

TEST(ShapesCommand, PointsThatAreThereTwiceChangeLittle) {
  const ShapesFolder folder;
  Scan scan = sample_house(1);
  for (auto& [name, values] : scan.labels)
    values.insert(values.end(), values.begin(), values.end());
  std::vector<Eigen::Vector3d> twice = scan.points;
  twice.insert(twice.end(), scan.points.begin(), scan.points.end());
  scan.points = twice;
  write_scan_ply(folder.path("twice.ply"), scan);
  const ProgramRun run = folder.shapes(folder.path("twice.ply"));
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const auto json = nlohmann::json::parse(file_bytes(folder.path("out/scale-1.json")));
  EXPECT_GT(json["coverage"].get<double>(), 0.8);
  EXPECT_LT(json["rms"].get<double>(), 0.1);
  EXPECT_GE(json["shapes"].size(), 4u);
}

TEST(ShapesCommand, MeshesMayHaveFacetsWithoutAreaAndEdgesOfManyFacets) {
  const ShapesFolder folder;
  Scan mesh;
  mesh.points = {{0, 0, 0}, {4, 0, 0}, {4, 3, 0},  {0, 3, 0}, {0, 0, 2},
                 {4, 0, 2}, {2, 0, 0}, {0, -3, 1}, {4, -3, 1}};
  for (const auto& facet : std::vector<std::vector<int>>{{0, 1, 2, 3},
                                                         {0, 1, 5, 4},
                                                         {0, 1, 8, 7},  // a third one on the edge
                                                         {0, 6, 1},     // collinear
                                                         {2, 2, 3},     // a corner twice
                                                         {5, 5, 5}}) {
    mesh.facets.add(facet);
  }
  write_scan_ply(folder.path("mesh.ply"), mesh);
  const ProgramRun run = folder.shapes(folder.path("mesh.ply"), {"--epsilon", "0"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(num_lines(run.out), 4);
  const ProgramRun grown = folder.shapes(folder.path("mesh.ply"));
  EXPECT_EQ(grown.exit_code, 0) << grown.err;
  EXPECT_THAT(
      run_gable({"shapes", "evaluate", folder.out(), "--input", folder.path("mesh.ply")}).out,
      HasSubstr("100.00"));
}

TEST(ShapesCommand, AScanMayBeNamedLikeASubcommand) {
  const ShapesFolder folder;
  const std::string name = folder.path("train");
  // Without an extension it is refused as a scan, but as one.
  std::filesystem::copy(folder.scan(), name);
  const ProgramRun run = folder.shapes(name);
  EXPECT_EQ(run.exit_code, 4);
  EXPECT_THAT(run.err, HasSubstr("has no known extension"));
}

}  // namespace
}  // namespace gable
