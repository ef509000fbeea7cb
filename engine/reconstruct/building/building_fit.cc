#include <gable/engine/io/models/building_plan.h>
#include <gable/engine/reconstruct/building/building_fit.h>
#include <gable/engine/reconstruct/finding/height_crop.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace gable {
namespace {

constexpr double kGood = 0.5;  // metres

/// Heights of the model at the pixels, NaN where it does not stand; local frame.
std::vector<double> model_heights(const HeightImage& image, const Building& building) {
  std::vector<double> heights(image.size(), std::numeric_limits<double>::quiet_NaN());
  Grid grid;
  grid.gsd = image.gsd;
  grid.rows = image.rows;
  grid.cols = image.cols;
  grid.north_west = image.first_center + 0.5 * image.gsd * Eigen::Vector2d(-1.0, 1.0);
  Building here = building;
  (here.house ? here.house->origin : here.origin).setZero();
  for_building_cells(here, grid, [&](int row, int col, double height) {
    heights[image.index(row, col)] = height;
  });
  return heights;
}

}  // namespace

BuildingFit fit_of_building(const HeightImage& image, const Building& building) {
  const std::vector<double> model = model_heights(image, building);
  BuildingFit fit;
  double sum = 0.0, squares = 0.0, beyond = 0.0, intrusion = 0.0;
  int good = 0;
  for (size_t i = 0; i < image.size(); ++i) {
    const bool covered = !std::isnan(model[i]);
    if (!covered && !image.inside[i]) continue;
    fit.base = std::min(fit.base, static_cast<double>(image.ground[i]));
    if (!(image.weight[i] > 0.0f)) continue;
    const double difference = std::abs((covered ? model[i] : image.ground[i]) - image.height[i]);
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
  const std::vector<double> model = model_heights(*image, building);
  for (size_t i = 0; i < image->size(); ++i) image->inside[i] = !std::isnan(model[i]);
}

}  // namespace gable
