#pragma once

#include <opencv2/core.hpp>
#include <string>

namespace gable {

/// A file of a report.
struct ReportFile {
  std::string name;  ///< relative to the report's folder, safe in a link
  std::string bytes;
};

/// A picture (8-bit BGR) as PNG.
std::string png_bytes(const cv::Mat& picture);

}  // namespace gable
