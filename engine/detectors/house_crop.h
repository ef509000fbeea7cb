#pragma once

#include <gable/residuals/height_image.h>

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace gable {

/// Pixels a side of what the detectors see (NPR section 4).
inline constexpr int kCropSize = 64;
inline constexpr size_t kCropPixels = static_cast<size_t>(kCropSize) * kCropSize;

/// The channels of a crop, in this order.
enum class CropChannel { kNormalX, kNormalY, kNormalZ, kDepth };
inline constexpr int kCropChannels = 4;

/// One building as the detectors see it (NPR section 5.1): heights and normals of a square around
/// it, 64 x 64, in [0, 255]. Training and inference make crops with `make_house_crop` alone.
///
/// Frames. `house`: local turned by `azimuth` about its origin. `crop`: pixels, x along house x, y
/// against house y, (0, 0) the outer corner of the first pixel, whose centre is (0.5, 0.5).
struct HouseCrop {
  double azimuth = 0.0;  ///< radians, from local x to house x, anticlockwise
  Eigen::Vector2d north_west = Eigen::Vector2d::Zero();  ///< house point of crop (0, 0), metres
  double pixel = 0.5;                                    ///< metres
  double top = 0.0;  ///< height over the terrain that depth 255 stands for, metres, > 0
  /// Rows of pixels, channel after channel. Normals are of unit length in the house frame; x and y
  /// map [-1, 1] to [0, 255], z maps [0, 1]. Depth maps heights over the terrain in [0, top], the
  /// third highest of the building.
  std::array<uint8_t, kCropChannels * kCropPixels> channels{};
  /// 1: the building stands here, higher than 2 m over the terrain.
  std::array<uint8_t, kCropPixels> mask{};

  uint8_t at(CropChannel channel, int row, int col) const {
    return channels[static_cast<size_t>(channel) * kCropPixels +
                    static_cast<size_t>(row) * kCropSize + col];
  }
  Eigen::Vector2d house_from_crop(const Eigen::Vector2d& crop) const {
    return {north_west.x() + pixel * crop.x(), north_west.y() - pixel * crop.y()};
  }
  Eigen::Vector2d crop_from_house(const Eigen::Vector2d& house) const {
    return {(house.x() - north_west.x()) / pixel, (north_west.y() - house.y()) / pixel};
  }
  Eigen::Vector2d crop_from_local(const Eigen::Vector2d& local) const {
    const double c = std::cos(azimuth), s = std::sin(azimuth);
    return crop_from_house({c * local.x() + s * local.y(), -s * local.x() + c * local.y()});
  }
};

/// The crop of a building's heights: the tight rectangle around its inside pixels that stand higher
/// than 2 m, along the axes of `azimuth`, made square with its centre kept, with a fifth of its
/// side added all around. Heights are sampled bilinearly; inside pixels without a measurement take
/// that of the nearest one with; what lies beyond the image is bare ground. An image without such
/// pixels is cut around all inside pixels, or whole.
HouseCrop make_house_crop(const HeightImage& image, double azimuth);

}  // namespace gable
