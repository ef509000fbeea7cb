#pragma once

#include <gable/engine/detectors/crop_foundation.h>
#include <gable/engine/detectors/crop_tasks.h>
#include <gable/engine/detectors/detector_nets.h>
#include <gable/engine/detectors/foundation_corners.h>
#include <gable/engine/detectors/house_crop.h>
#include <gable/grammar/block.h>
#include <gable/grammar/synthesis/houses/prior.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "engine/house_image.h"

namespace gable {

/// A random house, its image, the crop of it at a quarter turn of its azimuth, and what ideal
/// detectors would say.
struct DrawnHouse {
  House house;
  HeightImage image;
  HouseCrop crop;
  std::vector<CropCorner> corners;

  DrawnHouse(Foundation foundation, uint64_t seed, const PriorOptions& prior) {
    Random random(seed);
    house = random_house(foundation, &random, prior);
    ViewOptions view;
    view.gsd = 0.25;
    view.size = 160;
    image = image_of(house, view);
    crop = make_house_crop(image, house.azimuth[0] + random.integer(0, 3) * 0.5 * M_PI);
    corners = foundation_corners(house, crop, image.origin);
  }

  static PriorOptions bare() {
    PriorOptions prior;
    prior.dormer_share = prior.chimney_share = prior.garage_share = 0.0;
    return prior;
  }

  /// The first map of the house's corners.
  int first_map() const { return 4 * static_cast<int>(house.foundation); }

  /// Whether a point of the crop lies in one of the house's components.
  bool covers(const Eigen::Vector2d& point) const {
    for (const CropRectangle& r : rectangles()) {
      if (point.x() >= r.x0 && point.x() < r.x1 && point.y() >= r.y0 && point.y() < r.y1) {
        return true;
      }
    }
    return false;
  }

  /// The rectangles of the components in the crop.
  std::vector<CropRectangle> rectangles() const {
    using namespace block_value;
    std::vector<CropRectangle> out;
    const std::vector<Block<double>> blocks = expand_blocks(house);
    for (int i = 0; i < house.num_components(); ++i) {
      const Block<double>& b = blocks[i];
      const Eigen::Vector2d p = crop_from_own_frame(house, {b[kX0], b[kY0]}, crop, image.origin);
      const Eigen::Vector2d q = crop_from_own_frame(house, {b[kX1], b[kY1]}, crop, image.origin);
      out.push_back({std::min(p.x(), q.x()), std::max(p.x(), q.x()), std::min(p.y(), q.y()),
                     std::max(p.y(), q.y())});
    }
    return out;
  }
};

/// Raises a map to a bump of height 1 as the training draws them.
inline void draw_bump(const Eigen::Vector2d& point, float* map, double height = 1.0) {
  constexpr double kSigma = 1.3;
  for (int row = 0; row < kCropSize; ++row) {
    for (int col = 0; col < kCropSize; ++col) {
      const double d2 = (Eigen::Vector2d(col + 0.5, row + 0.5) - point).squaredNorm();
      float& value = map[row * kCropSize + col];
      value = std::max(value, static_cast<float>(height * std::exp(-0.5 * d2 / (kSigma * kSigma))));
    }
  }
}

/// What ideal detectors say of a house whose corners are those given.
inline CropAnswer ideal_answer(const DrawnHouse& drawn, const std::vector<CropCorner>& corners) {
  CropAnswer answer;
  answer.foundation.fill(0.01f);
  answer.foundation[static_cast<size_t>(drawn.house.foundation)] = 0.95f;
  answer.maps.assign(static_cast<size_t>(kNumCropMaps) * kCropPixels, 0.0f);
  for (const CropCorner& corner : corners) {
    draw_bump(corner.crop, answer.maps.data() + (drawn.first_map() + corner.type) * kCropPixels);
  }
  return answer;
}

/// The peaks of a house's corners, from its drawn maps.
inline CornerPeaks drawn_peaks(const DrawnHouse& drawn, const std::vector<CropCorner>& corners) {
  const CropAnswer answer = ideal_answer(drawn, corners);
  CornerPeaks peaks;
  for (int type = 0; type < 4; ++type) {
    peaks[type] = find_peaks(answer.map(drawn.first_map() + type));
  }
  return peaks;
}

/// Intersection over union of the rectangles with the house's components, from 400 x 400 points.
inline double iou_with_truth(const std::vector<CropRectangle>& rectangles,
                             const DrawnHouse& drawn) {
  const std::vector<CropRectangle> truth = drawn.rectangles();
  const auto covers = [](const std::vector<CropRectangle>& all, double x, double y) {
    return std::any_of(all.begin(), all.end(), [&](const CropRectangle& r) {
      return x >= r.x0 && x < r.x1 && y >= r.y0 && y < r.y1;
    });
  };
  int both = 0, either = 0;
  for (int i = 0; i < 400; ++i) {
    for (int j = 0; j < 400; ++j) {
      const double x = (i + 0.5) * kCropSize / 400.0, y = (j + 0.5) * kCropSize / 400.0;
      const bool a = covers(truth, x, y), b = covers(rectangles, x, y);
      both += a && b;
      either += a || b;
    }
  }
  return either > 0 ? static_cast<double>(both) / either : 0.0;
}

/// A house's corners with the given ones left out.
inline std::vector<CropCorner> without(std::vector<CropCorner> corners, std::vector<int> left_out) {
  std::sort(left_out.begin(), left_out.end(), std::greater<>());
  for (const int i : left_out) corners.erase(corners.begin() + i);
  return corners;
}

}  // namespace gable
