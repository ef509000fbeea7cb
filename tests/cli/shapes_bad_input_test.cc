#include <gable/engine/error.h>
#include <gable/engine/io/shapes/labelled_ply.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "cli/sample_house.h"
#include "cli/shapes_folder.h"

namespace gable {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

class ShapesBadInput : public testing::Test {
 protected:
  /// One line that says what is wrong, the exit code, and nothing written.
  void expect_refused(const ProgramRun& run, ExitCode code, const std::string& said) {
    EXPECT_EQ(run.exit_code, static_cast<int>(code)) << run.err;
    EXPECT_EQ(run.out, "");
    EXPECT_THAT(run.err, StartsWith("gable: "));
    EXPECT_THAT(run.err, HasSubstr(said));
    EXPECT_EQ(num_lines(run.err), 1) << run.err;
    EXPECT_FALSE(std::filesystem::exists(folder_.out()));
  }

  std::string ply(const std::string& name, const std::vector<Eigen::Vector3d>& points) {
    Scan scan;
    scan.points = points;
    write_scan_ply(folder_.path(name), scan);
    return folder_.path(name);
  }

  const ShapesFolder folder_;
};

TEST_F(ShapesBadInput, GoodInputPasses) {
  const ProgramRun run = folder_.shapes(folder_.scan());
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_TRUE(std::filesystem::exists(folder_.out()));
}

TEST_F(ShapesBadInput, WrongUsage) {
  expect_refused(run_gable({"shapes"}), ExitCode::kUsage, "SCAN");
  expect_refused(run_gable({"shapes", folder_.scan()}), ExitCode::kUsage, "--output");
  expect_refused(folder_.shapes(folder_.scan(), {"--frobnicate"}), ExitCode::kUsage, "frobnicate");
  expect_refused(folder_.shapes(folder_.scan(), {"--scales", "4"}), ExitCode::kUsage, "[1, 3]");
  expect_refused(folder_.shapes(folder_.scan(), {"--scales", "0"}), ExitCode::kUsage, "--scales");
  expect_refused(folder_.shapes(folder_.scan(), {"--epsilon", "11"}), ExitCode::kUsage,
                 "--epsilon");
  expect_refused(folder_.shapes(folder_.scan(), {"--epsilon", "0"}), ExitCode::kUsage, "meshes");
  expect_refused(run_gable({"shapes", "-o", folder_.out(), "evaluate", folder_.out(), "--input",
                            folder_.scan()}),
                 ExitCode::kUsage, "evaluate");
}

TEST_F(ShapesBadInput, FilesThatAreNoScans) {
  const std::string none = folder_.path("none.ply");
  expect_refused(folder_.shapes(none), ExitCode::kNoInput, none);
  for (const char* name : {"empty.ply", "empty.xyz", "empty.las", "empty.off", "empty.obj",
                           "empty.pcd", "empty.pwn"}) {
    const std::string empty = folder_.write(name, "");
    expect_refused(folder_.shapes(empty), ExitCode::kBadInput, empty);
  }
  const std::string text = folder_.write("text.ply", "no scan at all\n");
  expect_refused(folder_.shapes(text), ExitCode::kBadInput, text);
  const std::string other = folder_.write("scan.docx", "1 2 3\n");
  expect_refused(folder_.shapes(other), ExitCode::kBadInput, "extension");
}

TEST_F(ShapesBadInput, TruncatedFilesAndLyingHeaders) {
  const std::string bytes = file_bytes(folder_.scan());
  const std::string cut = folder_.write("cut.ply", bytes.substr(0, bytes.size() - 1000));
  expect_refused(folder_.shapes(cut), ExitCode::kBadInput, cut);
  for (const char* count : {"2147483647", "99999999999999999999", "-5", "6001"}) {
    std::string lie = bytes;
    lie.replace(lie.find("6000"), 4, count);
    const std::string path = folder_.write("lie.ply", lie);
    expect_refused(folder_.shapes(path), ExitCode::kBadInput, path);
  }
}

TEST_F(ShapesBadInput, ScansWithoutPlanarShapes) {
  const Eigen::Vector3d far(84000.0, 447000.0, 3.0);
  std::vector<Eigen::Vector3d> line;
  for (int i = 0; i < 500; ++i) line.push_back(far + 0.01 * i * Eigen::Vector3d(1.0, 2.0, 0.5));
  expect_refused(folder_.shapes(ply("one.ply", {far})), ExitCode::kBadInput, "1 point,");
  expect_refused(folder_.shapes(ply("equal.ply", std::vector<Eigen::Vector3d>(500, far))),
                 ExitCode::kBadInput, "at one place");
  expect_refused(folder_.shapes(ply("line.ply", line)), ExitCode::kBadInput, "on a line");
  expect_refused(folder_.shapes(folder_.write("nan.xyz", "nan nan nan\nnan 1 2\n")),
                 ExitCode::kBadInput, "nan.xyz");
  Scan mesh;
  mesh.points = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 5, 0}};
  mesh.facets.add(std::vector<int>{0, 1, 2});
  mesh.facets.add(std::vector<int>{0, 1, 1});
  write_scan_ply(folder_.path("flat.ply"), mesh);
  expect_refused(folder_.shapes(folder_.path("flat.ply")), ExitCode::kBadInput, "no planar shapes");
}

TEST_F(ShapesBadInput, ModelsThatAreNone) {
  const auto with_model = [&](const std::string& model) {
    return run_gable({"shapes", folder_.scan(), "--model", model, "-o", folder_.out()});
  };
  expect_refused(with_model("castles"), ExitCode::kNoInput, "castles: no such model");
  const std::string none = folder_.path("none.scales");
  expect_refused(with_model(none), ExitCode::kNoInput, none);
  std::string bytes = file_bytes(folder_.model());
  bytes[bytes.size() / 2] ^= 4;
  const std::string damaged = folder_.write("damaged.scales", bytes);
  expect_refused(with_model(damaged), ExitCode::kBadInput, damaged);
  const std::string cut = folder_.write("cut.scales", bytes.substr(0, 40));
  expect_refused(with_model(cut), ExitCode::kBadInput, cut);
  expect_refused(with_model(folder_.write("foreign.scales", "x")), ExitCode::kBadInput, "foreign");
}

TEST_F(ShapesBadInput, OutputsThatCannotBeWritten) {
  const auto to = [&](const std::string& out, const std::vector<std::string>& more = {}) {
    std::vector<std::string> arguments = {"shapes",        folder_.scan(), "--model",
                                          folder_.model(), "-o",           out};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_gable(arguments);
  };
  expect_refused(to("/dev/null/out"), ExitCode::kCannotWrite, "/dev/null/out");
  expect_refused(to(folder_.scan()), ExitCode::kCannotWrite, folder_.scan());
  expect_refused(to(folder_.out(), {"--report", "/dev/null/report"}), ExitCode::kCannotWrite,
                 "/dev/null/report");
}

TEST_F(ShapesBadInput, EvaluateWantsTheScanThatTheShapesAreOf) {
  ASSERT_EQ(folder_.shapes(folder_.scan()).exit_code, 0);
  const auto evaluate = [&](const std::string& shapes, const std::string& input,
                            const std::vector<std::string>& more = {}) {
    std::vector<std::string> arguments = {"shapes", "evaluate", shapes, "--input", input};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const ProgramRun run = run_gable(arguments);
    EXPECT_EQ(run.out, "");
    EXPECT_EQ(num_lines(run.err), 1) << run.err;
    return run;
  };
  const std::string other = ply("other.ply", sample_house(2).points);
  EXPECT_THAT(evaluate(folder_.out(), other).err, HasSubstr("another scan"));
  const std::string fewer = ply("fewer.ply", sample_house(1, 100).points);
  EXPECT_EQ(evaluate(folder_.out(), fewer).exit_code, 4);
  EXPECT_EQ(evaluate(folder_.path("none"), folder_.scan()).exit_code, 3);
  EXPECT_THAT(evaluate(folder_.path(""), folder_.scan()).err, HasSubstr("scale-1.ply"));
  EXPECT_THAT(evaluate(folder_.out(), folder_.scan(), {"--truth", "none"}).err,
              HasSubstr("it has scale_1 scale_2 scale_3"));
}

}  // namespace
}  // namespace gable
