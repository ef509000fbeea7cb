#include <gable/engine/reconstruct/first_values/azimuth.h>

#include <cmath>
#include <complex>
#include <opencv2/imgproc.hpp>

namespace gable {
namespace {

// Directions modulo a quarter turn add up as unit vectors at four times the angle.
struct QuarterTurnSum {
  std::complex<double> sum;
  double weight = 0.0;

  void add(double gradient_x, double gradient_y, double w) {
    if (w <= 0.0) return;
    sum += w * std::polar(1.0, 4.0 * std::atan2(gradient_y, gradient_x));
    weight += w;
  }
  AzimuthCandidate candidate() const {
    double angle = std::arg(sum) / 4.0;
    if (angle < 0.0) angle += 0.5 * M_PI;
    if (angle >= 0.5 * M_PI) angle = 0.0;  // a sum that rounding has brought to the full turn
    return {angle, weight > 0.0 ? std::abs(sum) / weight : 0.0};
  }
};

double quarter_turn_distance(double a, double b) {
  const double d = std::fmod(std::abs(a - b), 0.5 * M_PI);
  return std::min(d, 0.5 * M_PI - d);
}

}  // namespace

std::vector<AzimuthCandidate> azimuth_candidates(const HeightImage& image, double separation) {
  cv::Mat mask(image.rows, image.cols, CV_32F), height(image.rows, image.cols, CV_32F);
  for (int row = 0; row < image.rows; ++row) {
    for (int col = 0; col < image.cols; ++col) {
      const size_t i = image.index(row, col);
      mask.at<float>(row, col) = image.inside[i] ? 1.0f : 0.0f;
      height.at<float>(row, col) = image.inside[i] ? image.height[i] : 0.0f;
    }
  }
  const double sigma = std::max(0.7, 1.0 / image.gsd * 0.7);
  cv::Mat smooth_mask, smooth_height;
  cv::GaussianBlur(mask, smooth_mask, cv::Size(), sigma);
  cv::GaussianBlur(height, smooth_height, cv::Size(), sigma);
  cv::Mat core;  // inside, away from the outline
  const int reach = std::max(1, static_cast<int>(std::lround(1.0 / image.gsd)));
  cv::erode(mask, core, cv::Mat::ones(2 * reach + 1, 2 * reach + 1, CV_8U));

  QuarterTurnSum outline, roof;
  for (int row = 1; row + 1 < image.rows; ++row) {
    for (int col = 1; col + 1 < image.cols; ++col) {
      const auto gradient = [&](const cv::Mat& m) -> Eigen::Vector2d {
        return Eigen::Vector2d(m.at<float>(row, col + 1) - m.at<float>(row, col - 1),
                               m.at<float>(row - 1, col) - m.at<float>(row + 1, col)) /
               (2.0 * image.gsd);
      };
      const Eigen::Vector2d edge = gradient(smooth_mask);
      outline.add(edge.x(), edge.y(), edge.squaredNorm());
      if (core.at<float>(row, col) > 0.5f) {
        const Eigen::Vector2d slope = gradient(smooth_height);
        // Steeper than a roof is a step, not a slope; flatter has no direction.
        if (slope.norm() > 0.2 && slope.norm() < 2.0) roof.add(slope.x(), slope.y(), 1.0);
      }
    }
  }
  std::vector<AzimuthCandidate> out;
  QuarterTurnSum both;
  const AzimuthCandidate by_outline = outline.candidate(), by_roof = roof.candidate();
  if (outline.weight > 0.0) both.sum += outline.sum / outline.weight;
  if (roof.weight > 0.0) both.sum += roof.sum / roof.weight;
  both.weight = (outline.weight > 0.0 ? 1.0 : 0.0) + (roof.weight > 0.0 ? 1.0 : 0.0);
  out.push_back(both.candidate());
  for (const AzimuthCandidate& c : {by_outline, by_roof}) {
    bool known = c.strength < 0.1;
    for (const AzimuthCandidate& o : out) {
      known = known || quarter_turn_distance(c.azimuth, o.azimuth) < separation;
    }
    if (!known) out.push_back(c);
  }
  return out;
}

}  // namespace gable
