#include <gable/grammar/block.h>
#include <gable/grammar/synthesis/houses/built_shape.h>
#include <gable/grammar/synthesis/houses/plan_union.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace gable {
namespace {

constexpr double kOutside = -std::numeric_limits<double>::infinity();
constexpr int kCircleCorners = 24;

bool is_round(const BuiltPart& part) {
  return part.form == PartForm::kCone || part.form == PartForm::kDome;
}

/// 0 in the middle, 1 on the rim of a regular polygon (or circle) of inner radius `radius`.
double share_of_radius(const BuiltPart& part, double u, double v) {
  if (part.count == 0) return std::hypot(u, v) / part.half_length;
  const double step = 2.0 * M_PI / part.count;
  const double angle = std::atan2(v, u);
  const double off_middle = angle - step * std::round(angle / step);
  return std::hypot(u, v) * std::cos(off_middle) / part.half_length;
}

double gable_share(const BuiltPart& part, double u, double v) {
  double share = 1.0 - std::abs(v) / part.half_width;
  if (part.start_run > 0.0) share = std::min(share, (u + part.half_length) / part.start_run);
  if (part.end_run > 0.0) share = std::min(share, (part.half_length - u) / part.end_run);
  return share;
}

double mansard_rise(const BuiltPart& part, double u, double v) {
  const double inside = std::min(part.half_length - std::abs(u), part.half_width - std::abs(v));
  if (inside < part.kink) return part.kink_rise * inside / part.kink;
  const double upper_run = std::min(part.half_length, part.half_width) - part.kink;
  return part.kink_rise + (part.rise - part.kink_rise) * (inside - part.kink) / upper_run;
}

}  // namespace

double BuiltPart::at(const Eigen::Vector2d& point) const {
  const Eigen::Vector2d d = point - center;
  const double u = along.dot(d);
  const double v = along.x() * d.y() - along.y() * d.x();
  if (is_round(*this)) {
    const double share = share_of_radius(*this, u, v);
    if (share >= 1.0) return kOutside;
    return eaves + rise * (form == PartForm::kCone ? 1.0 - share : std::sqrt(1.0 - share * share));
  }
  if (std::abs(u) > half_length || std::abs(v) > half_width) return kOutside;
  switch (form) {
    case PartForm::kGable:
      return eaves + rise * gable_share(*this, u, v);
    case PartForm::kMono:
      return eaves + rise * (v + half_width) / (2.0 * half_width);
    case PartForm::kMansard:
      return eaves + mansard_rise(*this, u, v);
    case PartForm::kBarrel:
      return eaves + rise * (1.0 - v * v / (half_width * half_width));
    case PartForm::kSawtooth: {
      const double teeth = (u + half_length) / (2.0 * half_length) * count;
      return eaves + rise * (teeth - std::floor(teeth));
    }
    default:
      return eaves;
  }
}

std::vector<Eigen::Vector2d> BuiltPart::ring() const {
  const Eigen::Vector2d across(-along.y(), along.x());
  std::vector<Eigen::Vector2d> corners;
  if (is_round(*this)) {
    const int n = count > 0 ? count : kCircleCorners;
    const double outer = radius();
    for (int i = 0; i < n; ++i) {
      const double angle = 2.0 * M_PI * (i + 0.5) / n;
      corners.push_back(center + outer * (std::cos(angle) * along + std::sin(angle) * across));
    }
    return corners;
  }
  constexpr double kSigns[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
  for (const auto& sign : kSigns) {
    corners.push_back(center + sign[0] * half_length * along + sign[1] * half_width * across);
  }
  return corners;
}

double BuiltPart::radius() const {
  if (is_round(*this)) return count > 0 ? half_length / std::cos(M_PI / count) : half_length;
  return std::hypot(half_length, half_width);
}

double BuiltShape::at(const Eigen::Vector2d& point) const {
  double height = kOutside;
  for (const BuiltPart& part : parts) height = std::max(height, part.at(point));
  if (height == kOutside) return height;
  for (const BuiltPart& lift : lifts) {
    const double by = lift.at(point);
    if (by != kOutside) height += by;
  }
  return height;
}

void BuiltShape::move(const Eigen::Vector3d& by) {
  for (BuiltPart& part : parts) {
    part.center += by.head<2>();
    part.eaves += by.z();
  }
  for (BuiltPart& lift : lifts) lift.center += by.head<2>();
}

void BuiltShape::append(const BuiltShape& other) {
  parts.insert(parts.end(), other.parts.begin(), other.parts.end());
  lifts.insert(lifts.end(), other.lifts.begin(), other.lifts.end());
}

BuiltShape shape_of(const House& house) {
  using namespace block_value;
  const Eigen::Vector2d x(std::cos(house.azimuth[0]), std::sin(house.azimuth[0]));
  const Eigen::Vector2d y(-x.y(), x.x());
  BuiltShape shape;
  for (const Block<double>& block : expand_blocks(house)) {
    const bool along_x = block.flat || block.ridge == Axis::kX;
    const double size_x = block[kX1] - block[kX0];
    const double size_y = block[kY1] - block[kY0];
    BuiltPart part;
    part.center = house.origin.head<2>() + 0.5 * (block[kX0] + block[kX1]) * x +
                  0.5 * (block[kY0] + block[kY1]) * y;
    part.along = along_x ? x : y;
    part.half_length = 0.5 * (along_x ? size_x : size_y);
    part.half_width = 0.5 * (along_x ? size_y : size_x);
    part.eaves = house.origin.z() + block[kEaves];
    if (!block.flat) {
      part.form = PartForm::kGable;
      part.rise = block[kRise];
      part.start_run = 2.0 * part.half_length * block[kHipStart];
      part.end_run = 2.0 * part.half_length * block[kHipEnd];
    }
    shape.parts.push_back(part);
  }
  return shape;
}

PlanPolygon outline_of(const BuiltShape& shape) {
  std::vector<std::vector<Eigen::Vector2d>> rings;
  for (const BuiltPart& part : shape.parts) rings.push_back(part.ring());
  return union_of_convex(rings);
}

}  // namespace gable
