#pragma once

#include <gable/grammar/height_field.h>
#include <gable/grammar/random.h>
#include <gable/residuals/height_image.h>

#include <cmath>
#include <vector>

#include "engine/house_image.h"

namespace gable {

// Gabled houses of 6 x 9 m in a row with party walls across house x, each in its own frame: origins
// in the middle of the houses, every third turned by a quarter turn in its own frame.
inline std::vector<House> row_of_houses(int count, double azimuth = 0.3) {
  std::vector<House> houses;
  for (int i = 0; i < count; ++i) {
    House house = make_house(Foundation::kI);
    house.origin = {1000.0 + 6.0 * i * std::cos(azimuth), 2000.0 + 6.0 * i * std::sin(azimuth),
                    0.1 * i};
    const bool turned = i % 3 == 2;
    house.azimuth[0] = azimuth + (turned ? 0.5 * M_PI : 0.0);
    house.footprints[0].values = {0.0, 0.0, turned ? 9.0 : 6.0, turned ? 6.0 : 9.0};
    house.roofs[0].values = {5.0 - house.origin.z(), 3.0};
    house.roofs[0].ridge = turned ? Axis::kY : Axis::kX;
    houses.push_back(house);
  }
  return houses;
}

// What each of the houses is fitted to where outlines are known: its own cells, ground around it,
// and next to no weight where a neighbour stands.
inline std::vector<HeightImage> images_of(const std::vector<House>& houses,
                                          const ViewOptions& options) {
  std::vector<HeightImage> images;
  for (size_t k = 0; k < houses.size(); ++k) {
    ViewOptions own = options;
    own.seed += k;
    HeightImage image = image_of(houses[k], own);
    for (int row = 0; row < image.rows; ++row) {
      for (int col = 0; col < image.cols; ++col) {
        for (size_t other = 0; other < houses.size(); ++other) {
          if (other == k) continue;
          const HeightField field(houses[other]);
          const Eigen::Vector2d p =
              image.center_of(row, col) + (houses[k].origin - houses[other].origin).head<2>();
          if (field.block_at_house(field.house_from_local(p)) < 0) continue;
          const size_t i = image.index(row, col);
          if (!image.inside[i]) image.weight[i] = 0.05f;
        }
      }
    }
    images.push_back(std::move(image));
  }
  return images;
}

}  // namespace gable
