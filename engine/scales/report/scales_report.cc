#include <gable/engine/scales/report/configuration_picture.h>
#include <gable/engine/scales/report/lasting_numbers.h>
#include <gable/engine/scales/report/scales_page.h>
#include <gable/engine/scales/report/scales_report.h>
#include <gable/engine/scales/report/shape_colors.h>
#include <gable/engine/scales/report/trajectory_strip.h>
#include <glog/logging.h>

#include <algorithm>
#include <cstdio>
#include <utility>

namespace gable {
namespace {

constexpr int kWidth = 960, kHeight = 720;  ///< of a picture, pixels

std::string hex(const Color& color) {
  char text[8];
  std::snprintf(text, sizeof(text), "#%02x%02x%02x", color.red, color.green, color.blue);
  return text;
}

/// Per shape of a scale, the lasting number of the shape of the trajectory that it comes from.
std::vector<int> numbers_of(const ScaleShapes& scale, const FirstShapes& first_shapes,
                            const LastingNumbers& numbers) {
  std::vector<int> out(scale.shapes.size(), -1);
  if (out.empty()) return out;  // such as a scale that the trajectory does not reach
  const std::vector<int> at = numbers.at(scale.configuration);
  int unused = at.empty() ? 0 : *std::max_element(at.begin(), at.end()) + 1;
  for (size_t e = 0; e < scale.shape_of.size(); ++e) {
    const int shape = scale.shape_of[e], first = first_shapes.shape_of[e];
    if (shape >= 0 && first >= 0 && out[shape] < 0) out[shape] = at[first];
  }
  for (int& number : out) {
    if (number < 0) number = unused++;
  }
  return out;
}

cv::Mat picture_of(const ScalesReport& report, const ScaleShapes& scale,
                   const std::vector<int>& numbers, const AxonometricView& view) {
  const bool outlined = std::any_of(scale.shapes.begin(), scale.shapes.end(),
                                    [](const PlanarShape& s) { return !s.polygons.empty(); });
  if (outlined) return draw_shapes(scale.shapes, view, numbers);
  std::vector<int> number_of = scale.shape_of;
  for (int& shape : number_of) {
    if (shape >= 0) shape = numbers[shape];
  }
  return draw_elements(report.scan, number_of, view);
}

ScaleEntry entry_of(const ScalesReport& report, size_t index) {
  const ScaleShapes& scale = report.scales[index];
  const std::string number = std::to_string(index + 1);
  ScaleEntry entry;
  entry.name = "Scale " + number;
  if (!report.names.empty()) entry.name += ": " + report.names[index];
  entry.color = hex(label_color(static_cast<int>(index) + 1));
  entry.picture = "scale-" + number + ".png";
  entry.configuration = scale.configuration;
  entry.num_shapes = static_cast<int>(scale.shapes.size());
  entry.coverage = scale.coverage;
  entry.rms = scale.rms;
  const double diagonal = report.first_shapes.diagonal;
  entry.rms_share = diagonal > 0.0 ? scale.rms / diagonal : 0.0;
  if (!report.angles.empty()) {
    entry.angle_before = report.angles[index].before;
    entry.angle_after = report.angles[index].after;
  }
  return entry;
}

}  // namespace

std::vector<ReportFile> scales_report(const ScalesReport& report) {
  CHECK(report.names.empty() || report.names.size() == report.scales.size());
  CHECK(report.angles.empty() || report.angles.size() == report.scales.size());
  const Scan& scan = report.scan;
  ScalesSummary summary;
  summary.title = report.title;
  summary.elements = std::to_string(scan.num_elements()) + (scan.is_mesh() ? " facets" : " points");
  summary.diagonal = report.first_shapes.diagonal;
  summary.num_first_shapes = report.trajectory.num_first;
  summary.picture = "input.png";
  summary.strip = "trajectory.png";

  const AxonometricView view = view_of(scan.points, kWidth, kHeight);
  std::vector<ReportFile> files;
  files.push_back({summary.picture, png_bytes(draw_scan(scan, view))});
  const LastingNumbers numbers(report.trajectory, report.first_shapes);
  std::vector<ScaleEntry> entries;
  for (size_t i = 0; i < report.scales.size(); ++i) {
    const ScaleEntry& entry = entries.emplace_back(entry_of(report, i));
    const std::vector<int> shape_numbers =
        numbers_of(report.scales[i], report.first_shapes, numbers);
    files.push_back(
        {entry.picture, png_bytes(picture_of(report, report.scales[i], shape_numbers, view))});
  }
  files.push_back(
      {summary.strip, png_bytes(draw_trajectory_strip(report.trajectory, report.labels).image)});
  files.push_back({"index.html", scales_page(summary, entries)});
  return files;
}

}  // namespace gable
