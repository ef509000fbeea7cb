#pragma once

#include <gable/engine/drawing/report_file.h>

#include <cstddef>
#include <functional>
#include <opencv2/core.hpp>
#include <string>
#include <vector>

namespace gable {

/// How sheets are laid out.
struct AnnotationSheetOptions {
  int columns = 2;  ///< buildings beside each other, [1, 16]
  int rows = 3;     ///< [1, 16]
};

/// Empty if the options are in range; otherwise names the violated bound.
std::string check(const AnnotationSheetOptions& options);

/// "sheet_001.png": the name of the sheet that shows building `index`, counted from 0.
std::string annotation_sheet_name(size_t index, const AnnotationSheetOptions& options);

/// Puts panels (all of `annotation_panel_size`) onto sheets in the order in which they come.
class AnnotationSheets {
 public:
  using Write = std::function<void(const std::string& name, const cv::Mat& sheet)>;

  /// `write` is called with every sheet that is full.
  AnnotationSheets(const AnnotationSheetOptions& options, Write write);
  void add(const cv::Mat& panel);
  /// Writes the last sheet where it is not full.
  void finish();

 private:
  void flush();

  const AnnotationSheetOptions options_;
  const Write write_;
  std::vector<cv::Mat> panels_;
  size_t written_ = 0;  ///< panels
};

}  // namespace gable
