#include <gable/engine/detectors/foundation_corners.h>
#include <gable/grammar/block.h>
#include <glog/logging.h>

#include <cmath>

namespace gable {
namespace {

struct RoleAt {
  int role;
  double x, y;  ///< own frame of the house
};

std::vector<RoleAt> l_corners(const Rule& p) {
  using namespace param::l_polygon;
  using namespace crop_map;
  const double x0 = p[kCornerX], y0 = p[kCornerY];
  const double x2 = x0 + p[kWingXLength], y2 = y0 + p[kWingYLength];
  const double x1 = x0 + p[kWingYWidth], y1 = y0 + p[kWingXWidth];
  return {{kOuter, x0, y0},   {kOuterEnd, x2, y0}, {kInnerEnd, x2, y1},
          {kConcave, x1, y1}, {kInnerEnd, x1, y2}, {kOuterEnd, x0, y2}};
}

std::vector<RoleAt> u_corners(const Rule& p) {
  using namespace param::u_polygon;
  using namespace crop_map;
  const double x0 = p[kCornerX], y0 = p[kCornerY];
  const double x3 = x0 + p[kBaseLength], y1 = y0 + p[kBaseWidth];
  const double x1 = x0 + p[kLeftWidth], x2 = x3 - p[kRightWidth];
  const double left = y0 + p[kLeftLength], right = y0 + p[kRightLength];
  return {{kOuter, x0, y0},   {kOuter, x3, y0},   {kOuterEnd, x3, right}, {kInnerEnd, x2, right},
          {kConcave, x2, y1}, {kConcave, x1, y1}, {kInnerEnd, x1, left},  {kOuterEnd, x0, left}};
}

}  // namespace

Eigen::Vector2d crop_from_own_frame(const House& house, const Eigen::Vector2d& point,
                                    const HouseCrop& crop, const Eigen::Vector3d& image_origin) {
  const double own_c = std::cos(house.azimuth[0]), own_s = std::sin(house.azimuth[0]);
  const Eigen::Vector2d local =
      (house.origin - image_origin).head<2>() +
      Eigen::Vector2d(own_c * point.x() - own_s * point.y(), own_s * point.x() + own_c * point.y());
  return crop.crop_from_local(local);
}

std::array<Eigen::Vector2d, 4> component_corners(const House& house, int component,
                                                 const HouseCrop& crop,
                                                 const Eigen::Vector3d& image_origin) {
  using namespace block_value;
  CHECK(component >= 0 && component < house.num_components());
  const Block<double> block = expand_blocks(house)[component];
  std::array<Eigen::Vector2d, 4> corners;
  Eigen::Vector2d middle = Eigen::Vector2d::Zero();
  for (int i = 0; i < 4; ++i) {
    corners[i] = crop_from_own_frame(
        house, {block[i % 2 == 0 ? kX0 : kX1], block[i < 2 ? kY0 : kY1]}, crop, image_origin);
    middle += 0.25 * corners[i];
  }
  // A turn of the rectangle by less than 45 degrees leaves one corner in each quadrant along its
  // own axes, stretched to a square: order by the axes that lie nearest to the crop's.
  Eigen::Vector2d right = corners[1] - corners[0], down = corners[2] - corners[0];
  if (std::abs(right.x()) * down.norm() < std::abs(down.x()) * right.norm()) std::swap(right, down);
  if (right.x() < 0.0) right = -right;
  if (down.y() < 0.0) down = -down;
  return {middle - 0.5 * right - 0.5 * down, middle + 0.5 * right - 0.5 * down,
          middle - 0.5 * right + 0.5 * down, middle + 0.5 * right + 0.5 * down};
}

std::vector<CropCorner> foundation_corners(const House& house, const HouseCrop& crop,
                                           const Eigen::Vector3d& image_origin) {
  std::vector<CropCorner> corners;
  if (house.foundation == Foundation::kL || house.foundation == Foundation::kU) {
    const Rule& footprint = house.footprints[0];
    for (const RoleAt& c :
         house.foundation == Foundation::kL ? l_corners(footprint) : u_corners(footprint)) {
      corners.push_back({c.role, crop_from_own_frame(house, {c.x, c.y}, crop, image_origin)});
    }
    return corners;
  }
  for (int i = 0; i < house.num_components(); ++i) {
    const auto rectangle = component_corners(house, i, crop, image_origin);
    for (int type = 0; type < 4; ++type) corners.push_back({type, rectangle[type]});
  }
  return corners;
}

}  // namespace gable
