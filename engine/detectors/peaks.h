#pragma once

#include <Eigen/Core>
#include <span>
#include <string>
#include <vector>

namespace gable {

struct PeakOptions {
  double threshold = 0.5;  ///< least value, (0, 1] (NPR section 4.1)
  int radius = 2;          ///< no higher value within so many rows and columns, pixels, [1, 16]
  int at_most = 16;        ///< the highest are kept, >= 1
};

/// Empty if the options are in range; otherwise names the violated bound.
std::string check(const PeakOptions& options);

/// A peak of a heat map.
struct Peak {
  Eigen::Vector2d crop = Eigen::Vector2d::Zero();  ///< crop pixels, see HouseCrop
  double value = 0.0;                              ///< of the map at the highest pixel
};

/// The peaks of a 64 x 64 map, highest first: pixels that reach the threshold and that no other
/// within the radius exceeds; of equal ones the first in reading order. Positions are sharpened by
/// parabolas through the neighbours in x and in y, by half a pixel at most; at the map's border
/// they stay at the pixel's centre across it.
std::vector<Peak> find_peaks(std::span<const float> map, const PeakOptions& options = {});

}  // namespace gable
