#include <gable/engine/drawing/report_file.h>
#include <glog/logging.h>

#include <cstdint>
#include <opencv2/imgcodecs.hpp>
#include <vector>

namespace gable {

std::string png_bytes(const cv::Mat& picture) {
  std::vector<uint8_t> png;
  CHECK(cv::imencode(".png", picture, png, {cv::IMWRITE_PNG_COMPRESSION, 6}));
  return {png.begin(), png.end()};
}

}  // namespace gable
