#include <gable/engine/dataset/npy.h>
#include <gable/engine/dataset/shard.h>

#include <algorithm>
#include <cstdio>
#include <limits>

namespace gable {
namespace {

constexpr size_t kDormers = 8, kChimneys = 4, kComponents = 3, kCorners = 12;
constexpr float kNone = std::numeric_limits<float>::quiet_NaN();

void append_bits(const std::array<uint8_t, kCropPixels>& pixels, std::vector<unsigned char>* bits) {
  for (size_t i = 0; i < kCropPixels; i += 8) {
    unsigned char byte = 0;
    for (size_t k = 0; k < 8; ++k)
      byte = static_cast<unsigned char>(byte << 1 | (pixels[i + k] != 0));
    bits->push_back(byte);
  }
}

void append_points(const std::vector<Eigen::Vector2d>& points, size_t room,
                   std::vector<float>* values) {
  for (size_t i = 0; i < room; ++i) {
    for (int k = 0; k < 2; ++k) {
      values->push_back(i < points.size() ? static_cast<float>(points[i][k]) : kNone);
    }
  }
}

}  // namespace

std::vector<ShardFile> shard_files(int number, const std::vector<TrainingSample>& samples) {
  const size_t n = samples.size();
  std::vector<unsigned char> crops, turned, masks, garages, foundation, known;
  std::vector<signed char> roofs;
  std::vector<float> azimuth, components, corners, dormers, chimneys;
  crops.reserve(n * kCropChannels * kCropPixels);
  turned.reserve(n * kCropChannels * kCropPixels);
  for (const TrainingSample& sample : samples) {
    crops.insert(crops.end(), sample.crop.channels.begin(), sample.crop.channels.end());
    turned.insert(turned.end(), sample.turned.channels.begin(), sample.turned.channels.end());
    append_bits(sample.crop.mask, &masks);
    append_bits(sample.garages, &garages);
    foundation.push_back(static_cast<unsigned char>(sample.foundation));
    known.push_back(sample.details_known && sample.dormers.size() <= kDormers &&
                    sample.chimneys.size() <= kChimneys);
    azimuth.push_back(static_cast<float>(sample.azimuth));
    for (size_t i = 0; i < kComponents; ++i) {
      roofs.push_back(i < sample.roofs.size() ? static_cast<signed char>(sample.roofs[i]) : -1);
      for (size_t k = 0; k < 4; ++k) {
        for (int axis = 0; axis < 2; ++axis) {
          components.push_back(i < sample.components.size()
                                   ? static_cast<float>(sample.components[i][k][axis])
                                   : kNone);
        }
      }
    }
    for (size_t i = 0; i < kCorners; ++i) {
      const bool is_one = i < sample.corners.size();
      corners.push_back(is_one ? static_cast<float>(sample.corners[i].type) : kNone);
      corners.push_back(is_one ? static_cast<float>(sample.corners[i].crop.x()) : kNone);
      corners.push_back(is_one ? static_cast<float>(sample.corners[i].crop.y()) : kNone);
    }
    append_points(sample.dormers, kDormers, &dormers);
    append_points(sample.chimneys, kChimneys, &chimneys);
  }
  char suffix[32];
  std::snprintf(suffix, sizeof(suffix), "_%04d.npy", number);
  const size_t channels = kCropChannels, size = kCropSize;
  const auto named = [&](const char* name) { return name + std::string(suffix); };
  return {{named("crops"), npy_file(crops, {n, channels, size, size})},
          {named("turned"), npy_file(turned, {n, channels, size, size})},
          {named("masks"), npy_file(masks, {n, kCropPixels / 8})},
          {named("garages"), npy_file(garages, {n, kCropPixels / 8})},
          {named("foundation"), npy_file(foundation, {n})},
          {named("details_known"), npy_file(known, {n})},
          {named("azimuth"), npy_file(azimuth, {n})},
          {named("roofs"), npy_file(roofs, {n, kComponents})},
          {named("components"), npy_file(components, {n, kComponents, 4, 2})},
          {named("corners"), npy_file(corners, {n, kCorners, 3})},
          {named("dormers"), npy_file(dormers, {n, kDormers, 2})},
          {named("chimneys"), npy_file(chimneys, {n, kChimneys, 2})}};
}

}  // namespace gable
