#include <gable/engine/io/models/building_plan.h>
#include <gable/engine/reconstruct/building/building_fit.h>
#include <gable/engine/reconstruct/finding/height_crop.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <opencv2/imgproc.hpp>
#include <vector>

namespace gable {
namespace {

constexpr double kGood = 0.5;  // metres

// Where heights are means, the model is looked at in so many cells along a pixel's side, odd.
constexpr int kParts = 3;

/// Heights of the model in `parts` x `parts` cells per pixel, NaN where it does not stand; local
/// frame.
std::vector<double> model_heights(const HeightImage& image, const Building& building, int parts) {
  Grid grid;
  grid.gsd = image.gsd / parts;
  grid.rows = image.rows * parts;
  grid.cols = image.cols * parts;
  grid.north_west = image.first_center + 0.5 * image.gsd * Eigen::Vector2d(-1.0, 1.0);
  std::vector<double> heights(grid.size(), std::numeric_limits<double>::quiet_NaN());
  Building here = building;
  (here.house ? here.house->origin : here.origin).setZero();
  for_building_cells(here, grid, [&](int row, int col, double height) {
    heights[static_cast<size_t>(row) * grid.cols + col] = height;
  });
  return heights;
}

/// Weights of a mean over `width` cells, > 0, around the middle of one; those at the ends count by
/// their part of it.
cv::Mat weights_of_mean(double width) {
  const int reach = std::max(0, static_cast<int>(std::ceil(0.5 * (width - 1.0))));
  cv::Mat weights(1, 2 * reach + 1, CV_64F, cv::Scalar(1.0 / width));
  const double end = reach == 0 ? 1.0 : (0.5 * width - reach + 0.5) / width;
  weights.at<double>(0) = weights.at<double>(2 * reach) = end;
  return weights;
}

/// Model and terrain as the image sees them: means over its spread.
std::vector<double> mean_surface(const HeightImage& image, const Building& building) {
  const std::vector<double> model = model_heights(image, building, kParts);
  cv::Mat fine(image.rows * kParts, image.cols * kParts, CV_64F);
  for (int row = 0; row < fine.rows; ++row) {
    for (int col = 0; col < fine.cols; ++col) {
      const double height = model[static_cast<size_t>(row) * fine.cols + col];
      const float ground = image.ground[image.index(row / kParts, col / kParts)];
      fine.at<double>(row, col) = std::isnan(height) ? ground : height;
    }
  }
  const cv::Mat weights = weights_of_mean(image.spread / image.gsd * kParts);
  cv::sepFilter2D(fine, fine, CV_64F, weights, weights, {-1, -1}, 0.0, cv::BORDER_REPLICATE);
  std::vector<double> surface;
  for (int row = 0; row < image.rows; ++row) {
    for (int col = 0; col < image.cols; ++col) {
      surface.push_back(fine.at<double>(row * kParts + kParts / 2, col * kParts + kParts / 2));
    }
  }
  return surface;
}

}  // namespace

BuildingFit fit_of_building(const HeightImage& image, const Building& building) {
  const std::vector<double> model = model_heights(image, building, 1);
  std::vector<double> surface;
  if (image.spread > 0.0) surface = mean_surface(image, building);
  BuildingFit fit;
  double sum = 0.0, squares = 0.0, beyond = 0.0, intrusion = 0.0;
  int good = 0;
  for (size_t i = 0; i < image.size(); ++i) {
    const bool covered = !std::isnan(model[i]);
    if (!covered && !image.inside[i]) continue;
    fit.base = std::min(fit.base, static_cast<double>(image.ground[i]));
    if (!(image.weight[i] > 0.0f)) continue;
    const double expected = image.spread > 0.0 ? surface[i] : covered ? model[i] : image.ground[i];
    const double difference = std::abs(expected - image.height[i]);
    if (!image.inside[i]) {
      beyond += image.weight[i] * difference;
      if (is_taken(image, i)) intrusion += std::abs(model[i] - image.ground[i]);
      continue;
    }
    if (!is_evidence(image, i)) continue;
    ++fit.pixels;
    sum += difference;
    squares += difference * difference;
    good += difference < kGood;
  }
  if (fit.pixels > 0) {
    fit.mad = sum / fit.pixels;
    fit.rmse = std::sqrt(squares / fit.pixels);
    fit.good = static_cast<double>(good) / fit.pixels;
    fit.charge = (sum + beyond) / fit.pixels;
    fit.intrusion = intrusion / fit.pixels;
  }
  return fit;
}

void set_fit(const BuildingFit& fit, Building* building) {
  building->base = fit.base;
  building->quality.mad = fit.mad;
  building->quality.rmse = fit.rmse;
}

void mark_covered(const Building& building, HeightImage* image) {
  const std::vector<double> model = model_heights(*image, building, 1);
  for (size_t i = 0; i < image->size(); ++i) image->inside[i] = !std::isnan(model[i]);
}

}  // namespace gable
