#include <gable/engine/reconstruct/heights/mask_outline.h>

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

namespace gable {
namespace {

constexpr double kLeastHole = 4.0;  // square metres

// Each pixel becomes a square of this many, so that contours through the centres of the outermost
// ones lie within an eighth of a pixel of its edges.
constexpr int kScale = 4;

std::vector<Eigen::Vector2d> simplified(const std::vector<cv::Point>& contour,
                                        const HeightImage& image, double tolerance) {
  std::vector<cv::Point> kept;
  cv::approxPolyDP(contour, kept, tolerance / image.gsd * kScale, true);
  std::vector<Eigen::Vector2d> ring;
  for (const cv::Point& p : kept) {
    // Fine cell k of a pixel has its centre (k + 0.5) / kScale - 0.5 pixels from the pixel's.
    const Eigen::Vector2d cells((p.x + 0.5) / kScale - 0.5, (p.y + 0.5) / kScale - 0.5);
    ring.emplace_back(image.first_center.x() + cells.x() * image.gsd,
                      image.first_center.y() - cells.y() * image.gsd);
  }
  return ring;
}

}  // namespace

PlanPolygon outline_of_mask(const HeightImage& image, double tolerance) {
  // A frame of empty pixels would shift the contours; findContours takes the border as empty.
  cv::Mat mask(image.rows * kScale, image.cols * kScale, CV_8U);
  for (int row = 0; row < mask.rows; ++row) {
    for (int col = 0; col < mask.cols; ++col) {
      mask.at<unsigned char>(row, col) = image.inside[image.index(row / kScale, col / kScale)];
    }
  }
  std::vector<std::vector<cv::Point>> contours;
  std::vector<cv::Vec4i> tree;  // next, previous, first child, parent
  cv::findContours(mask, contours, tree, cv::RETR_CCOMP, cv::CHAIN_APPROX_SIMPLE);
  int largest = -1;
  double largest_area = -1.0;
  for (size_t i = 0; i < contours.size(); ++i) {
    const double area = cv::contourArea(contours[i]);
    if (tree[i][3] >= 0 || area <= largest_area) continue;
    largest = static_cast<int>(i);
    largest_area = area;
  }
  PlanPolygon polygon;
  if (largest < 0) return polygon;
  polygon.outer = simplified(contours[largest], image, tolerance);
  const double fine_cell = image.gsd * image.gsd / (kScale * kScale);
  for (int hole = tree[largest][2]; hole >= 0; hole = tree[hole][0]) {
    if (cv::contourArea(contours[hole]) * fine_cell < kLeastHole) continue;
    polygon.holes.push_back(simplified(contours[hole], image, tolerance));
    if (polygon.holes.back().size() < 3) polygon.holes.pop_back();
  }
  return polygon;
}

}  // namespace gable
