#include <gable/engine/reconstruct/heights/pixel_regions.h>

#include <algorithm>
#include <opencv2/imgproc.hpp>

namespace gable {

std::vector<PixelRegion> connected_regions(const cv::Mat& mask) {
  cv::Mat labels;
  const int count = cv::connectedComponents(mask, labels, 8, CV_32S);
  std::vector<PixelRegion> regions(std::max(0, count - 1));
  for (int row = 0; row < mask.rows; ++row) {
    for (int col = 0; col < mask.cols; ++col) {
      const int label = labels.at<int>(row, col);
      if (label == 0) continue;
      PixelRegion& region = regions[label - 1];
      if (region.pixels.empty()) region.box = {row, row + 1, col, col + 1};
      region.pixels.push_back(static_cast<size_t>(row) * mask.cols + col);
      region.box.row0 = std::min(region.box.row0, row);
      region.box.row1 = std::max(region.box.row1, row + 1);
      region.box.col0 = std::min(region.box.col0, col);
      region.box.col1 = std::max(region.box.col1, col + 1);
    }
  }
  return regions;
}

std::vector<PixelRegion> largest_regions(const cv::Mat& mask) {
  std::vector<PixelRegion> regions = connected_regions(mask);
  std::stable_sort(regions.begin(), regions.end(), [](const PixelRegion& a, const PixelRegion& b) {
    return a.pixels.size() > b.pixels.size();
  });
  return regions;
}

}  // namespace gable
