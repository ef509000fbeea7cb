#include <gable/engine/evaluate/shape_evaluation.h>
#include <gable/engine/io/scans/scan_file.h>
#include <gable/engine/io/shapes/labelled_ply.h>
#include <gable/engine/io/shapes/scale_labels_file.h>
#include <gable/engine/io/shapes/scale_model_file.h>
#include <gable/engine/io/shapes/trajectory_json.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdio>
#include <filesystem>

#include "cli/sample_house.h"
#include "cli/shapes_folder.h"

namespace gable {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// Six scans of houses with known planes in scans/.
class ScansFolder : public ScratchFolder {
 public:
  explicit ScansFolder(bool with_truth = true) {
    std::filesystem::create_directory(scans());
    for (int i = 1; i <= 6; ++i) {
      Scan scan = sample_house(i);
      if (!with_truth) scan.labels.clear();
      write_scan_ply(scan_file(i), scan);
    }
  }
  std::string scans() const { return path("scans"); }
  std::string scan_file(int i) const { return scans() + "/house-" + std::to_string(i) + ".ply"; }
  std::string labels() const { return path("labels.json"); }

  ProgramRun annotate(const std::vector<std::string>& more = {}) const {
    return run({"shapes", "annotate", scans(), "-o", labels(), "--quiet"}, more);
  }
  ProgramRun train(const std::string& model, const std::vector<std::string>& more = {}) const {
    return run({"shapes", "train", scans(), "--labels", labels(), "-o", path(model), "--quiet"},
               more);
  }

 private:
  static ProgramRun run(std::vector<std::string> arguments, const std::vector<std::string>& more) {
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_gable(arguments);
  }
};

TEST(ShapesTraining, FromScansWithKnownPlanesToAModelThatFindsThem) {
  const ScansFolder folder;
  const ProgramRun annotated = folder.annotate();
  ASSERT_EQ(annotated.exit_code, 0) << annotated.err;
  const ScaleLabelsFile labels = read_scale_labels(folder.labels());
  EXPECT_EQ(labels.num_scales, 3);
  ASSERT_EQ(labels.scans.size(), 6u);
  EXPECT_EQ(labels.scans[0].file, "scans/house-1.ply");
  for (const ScanScaleLabels& scan : labels.scans) EXPECT_TRUE(scan.known);
  EXPECT_TRUE(std::filesystem::exists(folder.path("labels/scans-house-6.ply.png")));

  const ProgramRun trained = folder.train("houses");
  ASSERT_EQ(trained.exit_code, 0) << trained.err;
  EXPECT_THAT(trained.out, HasSubstr("training: "));
  EXPECT_THAT(trained.out, HasSubstr("of 4 trajectories"));
  EXPECT_THAT(file_bytes(folder.path("houses/houses.md")), HasSubstr(trained.out));
  EXPECT_EQ(read_scale_model(folder.path("houses/houses.scales")).name, "houses");

  const std::string out = folder.path("out");
  const ProgramRun found = run_gable(
      {"shapes", folder.scan_file(3), "--model", folder.path("houses/houses.scales"), "-o", out});
  ASSERT_EQ(found.exit_code, 0) << found.err;

  const ProgramRun evaluated =
      run_gable({"shapes", "evaluate", out, "--input", folder.scan_file(3)});
  ASSERT_EQ(evaluated.exit_code, 0) << evaluated.err;
  EXPECT_EQ(num_lines(evaluated.out), 4);
  // The printed figures are those of the library.
  const Scan scan = read_scan(folder.scan_file(3));
  std::string expected;
  for (int k = 1; k <= 3; ++k) {
    const std::string number = std::to_string(k);
    const std::vector<int> shape_of =
        read_scan(out + "/scale-" + number + ".ply").labels.at("shape");
    const ShapeEvaluation fit = evaluate_shapes(scan, shape_of);
    const double index = agreement_index(shape_of, scan.labels.at("scale_" + number));
    char line[160];
    std::snprintf(line, sizeof(line), "%5d  %6d  %10.2f  %7.5f  %11.5f  %10.4f\n", k, fit.planes,
                  100.0 * fit.coverage, 100.0 * fit.rms / fit.diagonal,
                  100.0 * fit.worst_rms / fit.diagonal, index);
    expected += line;
    EXPECT_GT(index, 0.6) << k;
  }
  EXPECT_THAT(evaluated.out, testing::EndsWith(expected));
}

TEST(ShapesTraining, TheSameBytesOnOneThreadAndOnTwo) {
  const ScansFolder folder;
  ASSERT_EQ(folder.annotate({"--threads", "1"}).exit_code, 0);
  const std::string labels = file_bytes(folder.labels());
  const std::string sheet = file_bytes(folder.path("labels/scans-house-2.ply.png"));
  std::filesystem::remove_all(folder.path("labels"));
  std::filesystem::remove(folder.labels());
  ASSERT_EQ(folder.annotate({"--threads", "2"}).exit_code, 0);
  EXPECT_EQ(file_bytes(folder.labels()), labels);
  EXPECT_TRUE(file_bytes(folder.path("labels/scans-house-2.ply.png")) == sheet);
  ASSERT_EQ(folder.train("one", {"--name", "m", "--threads", "1"}).exit_code, 0);
  ASSERT_EQ(folder.train("two", {"--name", "m", "--threads", "2"}).exit_code, 0);
  ASSERT_EQ(folder.train("other", {"--name", "m", "--seed", "2"}).exit_code, 0);
  for (const char* file : {"/m.scales", "/m.md"}) {
    const std::string bytes = file_bytes(folder.path("one") + file);
    EXPECT_GT(bytes.size(), 100u);
    EXPECT_TRUE(file_bytes(folder.path("two") + file) == bytes);
    EXPECT_FALSE(file_bytes(folder.path("other") + file) == bytes);
  }
}

TEST(ShapesTraining, MarksMadeByHandStay) {
  const ScansFolder folder(false);
  const ProgramRun run = folder.annotate({"--scales", "2"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  ScaleLabelsFile labels = read_scale_labels(folder.labels());
  ASSERT_EQ(labels.scans.size(), 6u);
  for (const ScanScaleLabels& scan : labels.scans) {
    EXPECT_FALSE(scan.known);
    EXPECT_LT(scan.labels.first[0], scan.labels.first[1]);
  }
  const ScaleLabels proposed = labels.scans[2].labels;
  labels.scans[1].labels.first = {0, 1};
  ++labels.scans[2].labels.num_configurations;  // another trajectory: not that of the scan
  labels.scans[2].labels.first = {0, 1};
  labels.scans.pop_back();
  labels.scans.push_back({"elsewhere.ply", {{3, 4}, 5}, false});
  write_scale_labels(folder.labels(), labels);
  ASSERT_EQ(folder.annotate().exit_code, 0);
  const ScaleLabelsFile after = read_scale_labels(folder.labels());
  ASSERT_EQ(after.scans.size(), 7u);
  EXPECT_THAT(after.scans[1].labels.first, ElementsAre(0, 1));
  EXPECT_EQ(after.scans[2].labels.first, proposed.first);
  EXPECT_EQ(after.scans[5].file, "elsewhere.ply");
  EXPECT_EQ(after.scans[6].file, "scans/house-6.ply");
  // Another number of scales is another file.
  const ProgramRun other = folder.annotate({"--scales", "3"});
  EXPECT_EQ(other.exit_code, 2);
  EXPECT_EQ(num_lines(other.err), 1);
}

TEST(ShapesTraining, AModelProposesWhereItFindsTheScales) {
  const ShapesFolder folder;
  Scan scan = sample_house(1);
  scan.labels.clear();
  write_scan_ply(folder.path("plain.ply"), scan);
  const std::string labels = folder.path("labels.json");
  ASSERT_EQ(run_gable({"shapes", "annotate", folder.path("plain.ply"), "-o", labels, "--model",
                       folder.model(), "--sheets", folder.path("sheets"), "--quiet"})
                .exit_code,
            0);
  const ScaleLabelsFile file = read_scale_labels(labels);
  ASSERT_EQ(file.scans.size(), 1u);
  EXPECT_FALSE(file.scans[0].known);
  EXPECT_THAT(folder.files("sheets"), ElementsAre("plain.ply.png"));
  ASSERT_EQ(folder.shapes(folder.path("plain.ply")).exit_code, 0);
  EXPECT_EQ(read_trajectory_json(folder.path("out/trajectory.json")).scales.first,
            file.scans[0].labels.first);
  // One of another number of scales cannot.
  const ProgramRun other =
      run_gable({"shapes", "annotate", folder.path("plain.ply"), "-o", folder.path("other.json"),
                 "--model", folder.model(), "--scales", "2", "--quiet"});
  EXPECT_EQ(other.exit_code, 2);
  EXPECT_THAT(other.err, HasSubstr("has 3 scales, not 2"));
}

TEST(ShapesTraining, AScanGivenTwiceCountsOnce) {
  const ScansFolder folder;
  ASSERT_EQ(folder.annotate({folder.scan_file(2), folder.scans() + "//house-3.ply"}).exit_code, 0);
  EXPECT_EQ(read_scale_labels(folder.labels()).scans.size(), 6u);
}

TEST(ShapesTraining, TrainRefusesLabelsThatDoNotFit) {
  const ScansFolder folder;
  const auto expect_refused = [&](const ProgramRun& run, int code, const std::string& said) {
    EXPECT_EQ(run.exit_code, code) << run.err;
    EXPECT_EQ(num_lines(run.err), 1) << run.err;
    EXPECT_THAT(run.err, HasSubstr(said));
    EXPECT_FALSE(std::filesystem::exists(folder.path("model")));
  };
  expect_refused(folder.train("model"), 3, "labels.json");
  ASSERT_EQ(folder.annotate().exit_code, 0);
  const ScaleLabelsFile labels = read_scale_labels(folder.labels());
  ScaleLabelsFile wrong = labels;
  ++wrong.scans[3].labels.num_configurations;
  write_scale_labels(folder.labels(), wrong);
  expect_refused(folder.train("model"), 4, "house-4.ply");
  wrong = labels;
  for (ScanScaleLabels& scan : wrong.scans) scan.file = "x" + scan.file;
  write_scale_labels(folder.labels(), wrong);
  expect_refused(folder.train("model"), 4, "names none of the scans");
  write_scale_labels(folder.labels(), labels);
  expect_refused(folder.train("model", {"--name", "a/b"}), 2, "--name");
  expect_refused(folder.train("model", {"--training-share", "0"}), 2, "--training-share");
}

TEST(ShapesTraining, ScansWithoutLabelsOrShapesAreLeftOutWithALine) {
  const ScansFolder folder;
  Scan point;
  point.points = {{1, 2, 3}};
  write_scan_ply(folder.scans() + "/point.ply", point);
  const ProgramRun annotated =
      run_gable({"shapes", "annotate", folder.scans(), "-o", folder.labels()});
  ASSERT_EQ(annotated.exit_code, 0) << annotated.err;
  EXPECT_THAT(annotated.err, HasSubstr("point.ply: left out"));
  EXPECT_EQ(read_scale_labels(folder.labels()).scans.size(), 6u);
  const ProgramRun trained = run_gable(
      {"shapes", "train", folder.scans(), "--labels", folder.labels(), "-o", folder.path("model")});
  ASSERT_EQ(trained.exit_code, 0) << trained.err;
  EXPECT_THAT(trained.err, HasSubstr("point.ply: left out"));
}

TEST(ShapesTraining, AnnotateLeavesNothingWhereItFails) {
  const ScansFolder folder;
  std::ofstream(folder.scans() + "/broken.ply") << "ply\n";
  const ProgramRun run = folder.annotate();
  EXPECT_EQ(run.exit_code, 4);
  EXPECT_EQ(num_lines(run.err), 1) << run.err;
  EXPECT_EQ(folder.num_files(), 1);
}

}  // namespace
}  // namespace gable
