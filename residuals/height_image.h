#pragma once

#include <gable/grammar/raster.h>

#include <Eigen/Core>
#include <vector>

namespace gable {

/// A crop of heights around one building: what a house is fitted to. Local frame: world less
/// `origin`; heights in metres above origin.z().
struct HeightImage {
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();        ///< world
  Eigen::Vector2d first_center = Eigen::Vector2d::Zero();  ///< local centre of pixel (0, 0)
  double gsd = 0.5;                                        ///< metres; columns go east, rows south
  /// Width of the square that every height is a mean over, metres; 0: heights are those of first
  /// returns, each of one surface, as where a cell holds the highest of its points.
  double spread = 0.0;
  int rows = 0;
  int cols = 0;
  std::vector<float> height;  ///< surface, rows x cols
  std::vector<float> ground;  ///< terrain, rows x cols
  std::vector<float> weight;  ///< 0: left out (nodata, a neighbour's pixel); otherwise in (0, 1]
  std::vector<unsigned char> inside;  ///< 1: a pixel of the building (its mask or footprint)

  size_t size() const { return static_cast<size_t>(rows) * static_cast<size_t>(cols); }
  size_t index(int row, int col) const { return static_cast<size_t>(row) * cols + col; }
  Eigen::Vector2d center_of(int row, int col) const {
    return {first_center.x() + col * gsd, first_center.y() - row * gsd};
  }
};

/// Whether a pixel counts as a measurement; pixels of less weight only discourage blocks from
/// spreading over what is not known.
inline bool is_evidence(const HeightImage& image, size_t pixel) {
  return image.weight[pixel] >= 0.5f;
}

/// How many times its own error a pixel's height must be taken to have for all pixels to count as
/// independent: heights that are means over more than a cell share theirs with those around them.
inline double shared_error(const HeightImage& image) {
  return image.spread > image.gsd ? image.spread / image.gsd : 1.0;
}

/// Whole rasters (of one grid) as the image of one building whose local frame is at `origin`
/// (world): cells without a height or terrain have weight 0, cells more than 2 m over the terrain
/// are inside.
HeightImage height_image(const HeightRaster& dsm, const HeightRaster& dtm,
                         const Eigen::Vector3d& origin);

}  // namespace gable
