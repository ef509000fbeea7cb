#include <gable/engine/drawing/canvas.h>
#include <gable/engine/reconstruct/annotate/annotation_panel.h>
#include <gable/engine/reconstruct/annotate/annotation_sheets.h>
#include <glog/logging.h>

#include <algorithm>
#include <cstdio>
#include <utility>

namespace gable {
namespace {

size_t per_sheet(const AnnotationSheetOptions& options) {
  return static_cast<size_t>(options.columns) * static_cast<size_t>(options.rows);
}

}  // namespace

std::string check(const AnnotationSheetOptions& options) {
  if (options.columns < 1 || options.columns > 16) return "columns must lie in [1, 16]";
  if (options.rows < 1 || options.rows > 16) return "rows must lie in [1, 16]";
  return "";
}

std::string annotation_sheet_name(size_t index, const AnnotationSheetOptions& options) {
  char name[40];
  std::snprintf(name, sizeof(name), "sheet_%03zu.png", index / per_sheet(options) + 1);
  return name;
}

AnnotationSheets::AnnotationSheets(const AnnotationSheetOptions& options, Write write)
    : options_(options), write_(std::move(write)) {
  CHECK(check(options).empty()) << check(options);
}

void AnnotationSheets::add(const cv::Mat& panel) {
  CHECK(panel.size() == annotation_panel_size());
  panels_.push_back(panel);
  if (panels_.size() == per_sheet(options_)) flush();
}

void AnnotationSheets::finish() {
  if (!panels_.empty()) flush();
}

void AnnotationSheets::flush() {
  const cv::Size size = annotation_panel_size();
  const int count = static_cast<int>(panels_.size());
  const int columns = std::min(options_.columns, count);
  const int rows = (count + options_.columns - 1) / options_.columns;
  cv::Mat sheet(rows * size.height, columns * size.width, CV_8UC3, scalar(kPaperColor));
  for (int i = 0; i < count; ++i) {
    const cv::Point at((i % options_.columns) * size.width, (i / options_.columns) * size.height);
    panels_[static_cast<size_t>(i)].copyTo(sheet(cv::Rect(at, size)));
  }
  write_(annotation_sheet_name(written_, options_), sheet);
  written_ += panels_.size();
  panels_.clear();
}

}  // namespace gable
