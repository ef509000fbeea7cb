#include <gable/engine/detectors/house_crop.h>
#include <glog/logging.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <vector>

namespace gable {
namespace {

constexpr double kBuildingHeight = 2.0;  // NPR section 5.1, metres over the terrain
constexpr double kMargin = 0.2;          // of the square's side, on every side
constexpr double kLeastTop = 2.5;        // depth of flat ground is not stretched, metres
constexpr double kLeastSide = 2.0;       // of the square, metres

/// Heights over the terrain, holes of the building filled, and where the building stands.
struct Surface {
  const HeightImage& image;
  std::vector<float> height;
  std::vector<unsigned char> building;
};

/// Gives every inside pixel without a measurement the height of the nearest with one, counted in
/// steps over edges, those of earlier rows first.
void fill_holes(const HeightImage& image, std::vector<float>* height) {
  constexpr int kSteps[4][2] = {{-1, 0}, {0, -1}, {0, 1}, {1, 0}};
  std::vector<unsigned char> known(image.size());
  std::vector<size_t> front;
  for (size_t i = 0; i < image.size(); ++i) {
    known[i] = !image.inside[i] || is_evidence(image, i);
    if (image.inside[i] && known[i]) front.push_back(i);
  }
  for (size_t next = 0; next < front.size(); ++next) {
    const int row = static_cast<int>(front[next] / image.cols);
    const int col = static_cast<int>(front[next] % image.cols);
    for (const auto& step : kSteps) {
      const int r = row + step[0], c = col + step[1];
      if (r < 0 || r >= image.rows || c < 0 || c >= image.cols) continue;
      const size_t i = image.index(r, c);
      if (known[i]) continue;
      known[i] = 1;
      (*height)[i] = (*height)[front[next]];
      front.push_back(i);
    }
  }
}

Surface make_surface(const HeightImage& image) {
  Surface surface{image, {}, {}};
  surface.height.resize(image.size());
  for (size_t i = 0; i < image.size(); ++i) surface.height[i] = image.height[i] - image.ground[i];
  fill_holes(image, &surface.height);
  surface.building.resize(image.size());
  bool any = false;
  for (size_t i = 0; i < image.size(); ++i) {
    surface.building[i] = image.inside[i] && surface.height[i] > kBuildingHeight;
    any |= surface.building[i] != 0;
  }
  if (!any) surface.building = image.inside;
  return surface;
}

/// Bilinear height at a local point; bare ground beyond the image.
double height_at(const Surface& surface, const Eigen::Vector2d& local) {
  const HeightImage& image = surface.image;
  const double x = (local.x() - image.first_center.x()) / image.gsd;
  const double y = (image.first_center.y() - local.y()) / image.gsd;
  const int col = static_cast<int>(std::floor(x)), row = static_cast<int>(std::floor(y));
  const double u = x - col, v = y - row;
  const auto value = [&](int r, int c) -> double {
    if (r < 0 || r >= image.rows || c < 0 || c >= image.cols) return 0.0;
    return surface.height[image.index(r, c)];
  };
  return (1.0 - v) * ((1.0 - u) * value(row, col) + u * value(row, col + 1)) +
         v * ((1.0 - u) * value(row + 1, col) + u * value(row + 1, col + 1));
}

bool building_at(const Surface& surface, const Eigen::Vector2d& local) {
  const HeightImage& image = surface.image;
  const auto col = std::lround((local.x() - image.first_center.x()) / image.gsd);
  const auto row = std::lround((image.first_center.y() - local.y()) / image.gsd);
  if (row < 0 || row >= image.rows || col < 0 || col >= image.cols) return false;
  return surface.building[image.index(static_cast<int>(row), static_cast<int>(col))] != 0;
}

uint8_t byte(double share) {
  return static_cast<uint8_t>(std::lround(255.0 * std::clamp(share, 0.0, 1.0)));
}

/// The third highest: one bird or wire does not flatten the picture.
double highest_of_many(std::vector<float>* heights) {
  if (heights->empty()) return 0.0;
  const auto third = heights->begin() + std::min<size_t>(2, heights->size() - 1);
  std::nth_element(heights->begin(), third, heights->end(), std::greater<>());
  return *third;
}

struct Box {
  double x0 = std::numeric_limits<double>::infinity(), y0 = x0, x1 = -x0, y1 = -x0;
  void add(double x, double y, double half) {
    x0 = std::min(x0, x - half);
    x1 = std::max(x1, x + half);
    y0 = std::min(y0, y - half);
    y1 = std::max(y1, y + half);
  }
};

}  // namespace

HouseCrop make_house_crop(const HeightImage& image, double azimuth) {
  CHECK(image.size() > 0 && image.gsd > 0.0);
  const Surface surface = make_surface(image);
  const double cosine = std::cos(azimuth), sine = std::sin(azimuth);
  Box box, whole;
  std::vector<float> heights;
  for (int row = 0; row < image.rows; ++row) {
    for (int col = 0; col < image.cols; ++col) {
      const size_t i = image.index(row, col);
      const Eigen::Vector2d p = image.center_of(row, col);
      const double x = cosine * p.x() + sine * p.y(), y = -sine * p.x() + cosine * p.y();
      whole.add(x, y, 0.5 * image.gsd);
      if (!surface.building[i]) continue;
      box.add(x, y, 0.5 * image.gsd);
      heights.push_back(surface.height[i]);
    }
  }
  if (box.x0 > box.x1) box = whole;

  HouseCrop crop;
  const double tight = std::max({box.x1 - box.x0, box.y1 - box.y0, kLeastSide});
  const double side = (1.0 + 2.0 * kMargin) * tight;
  crop.azimuth = azimuth;
  crop.pixel = side / kCropSize;
  crop.top = std::max(kLeastTop, highest_of_many(&heights));
  crop.north_west = {0.5 * (box.x0 + box.x1) - 0.5 * side, 0.5 * (box.y0 + box.y1) + 0.5 * side};

  // One ring more than the crop, so that normals are central differences up to its edge.
  constexpr int kRing = kCropSize + 2;
  std::vector<double> height(static_cast<size_t>(kRing) * kRing);
  const auto local_of = [&](int row, int col) -> Eigen::Vector2d {
    const Eigen::Vector2d house = crop.house_from_crop({col + 0.5, row + 0.5});
    return {cosine * house.x() - sine * house.y(), sine * house.x() + cosine * house.y()};
  };
  for (int row = -1; row <= kCropSize; ++row) {
    for (int col = -1; col <= kCropSize; ++col) {
      height[static_cast<size_t>(row + 1) * kRing + col + 1] =
          height_at(surface, local_of(row, col));
    }
  }
  for (int row = 0; row < kCropSize; ++row) {
    for (int col = 0; col < kCropSize; ++col) {
      const size_t center = static_cast<size_t>(row + 1) * kRing + col + 1;
      const double slope_x = (height[center + 1] - height[center - 1]) / (2.0 * crop.pixel);
      const double slope_y = (height[center - kRing] - height[center + kRing]) / (2.0 * crop.pixel);
      const double nz = 1.0 / std::sqrt(1.0 + slope_x * slope_x + slope_y * slope_y);
      const size_t pixel = static_cast<size_t>(row) * kCropSize + col;
      crop.channels[pixel] = byte(0.5 - 0.5 * slope_x * nz);
      crop.channels[kCropPixels + pixel] = byte(0.5 - 0.5 * slope_y * nz);
      crop.channels[2 * kCropPixels + pixel] = byte(nz);
      crop.channels[3 * kCropPixels + pixel] = byte(height[center] / crop.top);
      crop.mask[pixel] = building_at(surface, local_of(row, col));
    }
  }
  return crop;
}

}  // namespace gable
