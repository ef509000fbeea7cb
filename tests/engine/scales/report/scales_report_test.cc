#include <gable/engine/scales/report/contact_sheet.h>
#include <gable/engine/scales/report/lasting_numbers.h>
#include <gable/engine/scales/report/scales_report.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <opencv2/imgcodecs.hpp>
#include <string>
#include <vector>

#include "engine/scales/report/sample_trajectory.h"

namespace gable {
namespace {

using testing::HasSubstr;
using testing::Not;

std::vector<ScaleShapes> scales_of(const SampleTrajectory& sample) {
  const LastingNumbers numbers(sample.trajectory, sample.first_shapes);
  std::vector<ScaleShapes> scales;
  for (const int first : sample.labels.first) {
    ScaleShapes& scale = scales.emplace_back();
    scale.configuration = first;
    const std::vector<int> at = numbers.at(first);
    for (const int shape : sample.first_shapes.shape_of) {
      scale.shape_of.push_back(shape < 0 ? -1 : at[shape]);
    }
    scale.shapes.resize(sample.trajectory.num_shapes(first));
    scale.coverage = 0.875;
    scale.rms = 0.0123;
  }
  return scales;
}

const ReportFile& file_of(const std::vector<ReportFile>& files, const std::string& name) {
  const auto is_it = [&name](const ReportFile& file) { return file.name == name; };
  const auto at = std::find_if(files.begin(), files.end(), is_it);
  EXPECT_NE(at, files.end()) << name;
  return at == files.end() ? files.front() : *at;
}

cv::Mat decoded(const ReportFile& file) {
  return cv::imdecode(std::vector<uint8_t>(file.bytes.begin(), file.bytes.end()), cv::IMREAD_COLOR);
}

TEST(ScalesReport, ShowsEveryScaleWithItsFiguresAndThePageComesLast) {
  const SampleTrajectory sample(40);
  const std::vector<ScaleShapes> scales = scales_of(sample);
  const std::vector<ReportFile> files =
      scales_report({.title = "a <scan> & more",
                     .scan = sample.scan,
                     .first_shapes = sample.first_shapes,
                     .trajectory = sample.trajectory,
                     .labels = sample.labels,
                     .scales = scales,
                     .names = {"detail", "roofs", "hull"},
                     .angles = {{1.5, 0.25}, {2.5, 0.5}, {3, 0}}});
  ASSERT_EQ(files.size(), 6u);
  EXPECT_EQ(files.back().name, "index.html");
  const std::string& page = files.back().bytes;
  EXPECT_THAT(page, HasSubstr("a &lt;scan&gt; &amp; more"));
  EXPECT_THAT(page, Not(HasSubstr("<scan>")));
  for (const char* name : {"Scale 1: detail", "Scale 2: roofs", "Scale 3: hull"}) {
    EXPECT_THAT(page, HasSubstr(name));
  }
  for (const ScaleShapes& scale : scales) {
    EXPECT_THAT(page, HasSubstr(std::to_string(scale.shapes.size()) + " planes, coverage 87.5 %"));
  }
  EXPECT_THAT(page, HasSubstr("RMS 0.012 m"));
  EXPECT_THAT(page, HasSubstr(">2.50</td>"));
  EXPECT_THAT(page, HasSubstr(">0.25</td>"));
  for (const ReportFile& file : files) {
    if (file.name == "index.html") continue;
    EXPECT_THAT(page, HasSubstr("src=\"" + file.name + "\""));
    EXPECT_FALSE(decoded(file).empty()) << file.name;
  }
  EXPECT_THAT(page, Not(HasSubstr("http")));
}

TEST(ScalesReport, LeavesOutAnglesThatAreNotKnown) {
  const SampleTrajectory sample(40);
  const std::vector<ScaleShapes> scales = scales_of(sample);
  const std::vector<ReportFile> files = scales_report({.title = "scan",
                                                       .scan = sample.scan,
                                                       .first_shapes = sample.first_shapes,
                                                       .trajectory = sample.trajectory,
                                                       .labels = sample.labels,
                                                       .scales = scales});
  EXPECT_THAT(files.back().bytes, Not(HasSubstr("refit")));
  EXPECT_THAT(files.back().bytes, HasSubstr("Scale 3<"));
}

TEST(ScalesReport, TakesAScanWithoutShapes) {
  Scan scan;
  scan.points = {{1, 2, 3}};
  const FirstShapes first_shapes{.shape_of = {-1}, .moments = {}, .adjacent = {}, .diagonal = 0.0};
  const Trajectory trajectory;
  const ScaleLabels labels{.first = {0, 1}, .num_configurations = 1};
  const std::vector<ScaleShapes> scales{{.configuration = 0, .shape_of = {-1}, .shapes = {}},
                                        {.configuration = 1, .shape_of = {-1}, .shapes = {}}};
  const std::vector<ReportFile> files = scales_report({.title = "a point",
                                                       .scan = scan,
                                                       .first_shapes = first_shapes,
                                                       .trajectory = trajectory,
                                                       .labels = labels,
                                                       .scales = scales});
  EXPECT_THAT(files.back().bytes, HasSubstr("0 planes"));
  EXPECT_THAT(files.back().bytes, Not(HasSubstr("nan")));
  const cv::Mat sheet = draw_contact_sheet(scan, first_shapes, trajectory, labels, "a point");
  EXPECT_GT(sheet.rows, 200);
}

TEST(ScalesReport, DrawsPolygonsWhereThereAreSome) {
  const SampleTrajectory sample(40);
  std::vector<ScaleShapes> scales = scales_of(sample);
  const auto pictures = [&] {
    return scales_report({.title = "scan",
                          .scan = sample.scan,
                          .first_shapes = sample.first_shapes,
                          .trajectory = sample.trajectory,
                          .labels = sample.labels,
                          .scales = scales});
  };
  const std::vector<ReportFile> points = pictures();
  for (PlanarShape& shape : scales[2].shapes) {
    shape.polygons.push_back({{{0, 0, 0}, {40, 0, 0}, {40, 10, 0}, {0, 10, 0}}, {}});
  }
  const std::vector<ReportFile> polygons = pictures();
  EXPECT_EQ(file_of(points, "scale-1.png").bytes, file_of(polygons, "scale-1.png").bytes);
  EXPECT_NE(file_of(points, "scale-3.png").bytes, file_of(polygons, "scale-3.png").bytes);
}

}  // namespace
}  // namespace gable
