#include <gable/engine/reconstruct/first_values/plane_blocks.h>
#include <glog/logging.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace gable {
namespace {

// Share of a plane's pixels beyond its extent on either side.
constexpr double kTrimmed = 0.02;

// A plane falls along an axis where its direction is within 25 degrees of it.
constexpr double kAlongAxis = 0.906;

// Two halves of a ridge's width that differ by less are one width seen twice, metres; of others the
// narrower is hidden under another block.
constexpr double kSameHalf = 0.8;

// A hip lies within its block and ends where it ends.
constexpr double kShareWithin = 0.7;
constexpr double kSameEnd = 1.5;

// The paper's common ratio where no hip is seen: a ratio of 0 has no derivative.
constexpr double kCommonHip = 0.1;

// A slope is half a gable where the building goes on beyond its ridge over this share of its
// pixels.
constexpr double kShareBeyond = 0.3;

// What lies so far within a block that has a roof is something on it.
constexpr double kShareOnRoof = 0.6;

struct Extent {
  double low = 0.0, high = 0.0;
  double length() const { return high - low; }
  double overlap(const Extent& other) const {
    return std::min(high, other.high) - std::max(low, other.low);
  }
};

// A roof plane in the house frame.
struct Slope {
  std::vector<int> planes;
  std::vector<Eigen::Vector2d> points;
  Eigen::Vector2d gradient = Eigen::Vector2d::Zero();
  double constant = 0.0;
  bool flat = false;
  int axis = 0;   // that it falls along
  int falls = 0;  // to +1 or -1 of it; 0: diagonally
  bool used = false;
  Extent extents[2];

  double at(const Eigen::Vector2d& p) const { return gradient.dot(p) + constant; }
  double slope() const { return gradient.norm(); }
  Eigen::Vector2d middle() const {
    return {0.5 * (extents[0].low + extents[0].high), 0.5 * (extents[1].low + extents[1].high)};
  }
};

Extent extent_of(const std::vector<Eigen::Vector2d>& points, int axis, double half_cell) {
  std::vector<double> values;
  for (const Eigen::Vector2d& p : points) values.push_back(p[axis]);
  const auto trim = static_cast<std::ptrdiff_t>(kTrimmed * static_cast<double>(values.size()));
  std::nth_element(values.begin(), values.begin() + trim, values.end());
  const double low = values[trim];
  const auto top = static_cast<std::ptrdiff_t>(values.size()) - 1 - trim;
  std::nth_element(values.begin(), values.begin() + top, values.end());
  return {low - half_cell, values[top] + half_cell};
}

std::string named(const std::vector<int>& planes) {
  std::string text = planes.size() == 1 ? "plane" : "planes";
  for (size_t i = 0; i < planes.size(); ++i) {
    text += (i == 0 ? " " : ", ") + std::to_string(planes[i] + 1);
  }
  return text;
}

class BlockReader {
 public:
  BlockReader(const HeightImage& image, const HouseScale& scale, double cell, double azimuth,
              const PlaneBlockOptions& options)
      : options_(options), cell_(cell) {
    const Eigen::Matrix2d house_from_local = Eigen::Rotation2Dd(-azimuth).toRotationMatrix();
    for (size_t i = 0; i < scale.planes.size(); ++i) {
      const HousePlane& plane = scale.planes[i];
      Slope side;
      side.planes = {static_cast<int>(i)};
      side.gradient = house_from_local * Eigen::Vector2d(plane.plane.a, plane.plane.b);
      side.constant = plane.plane.c;
      double above = 0.0;
      for (int pixel : plane.pixels) {
        side.points.push_back(house_from_local *
                              image.center_of(pixel / image.cols, pixel % image.cols));
        above += image.height[pixel] - image.ground[pixel];
      }
      if (above < options.least_height * static_cast<double>(side.points.size())) continue;
      side.flat = side.slope() < options.flat_slope;
      if (!side.flat) {
        const Eigen::Vector2d fall = -side.gradient / side.slope();
        side.axis = std::abs(fall.x()) > std::abs(fall.y()) ? 0 : 1;
        if (std::abs(fall[side.axis]) > kAlongAxis) side.falls = fall[side.axis] > 0.0 ? 1 : -1;
      }
      sides_.push_back(std::move(side));
    }
    unite_coplanar();
    for (Slope& side : sides_) measure(&side);
  }

  std::vector<PlaneBlock> read() {
    while (std::optional<PlaneBlock> block = next_gable()) blocks_.push_back(std::move(*block));
    add_flat_ones();
    std::erase_if(blocks_, [&](const PlaneBlock& block) {
      return block.pixels * cell_ * cell_ < options_.least_area;
    });
    std::stable_sort(blocks_.begin(), blocks_.end(),
                     [](const PlaneBlock& a, const PlaneBlock& b) { return a.pixels > b.pixels; });
    return std::move(blocks_);
  }

 private:
  void measure(Slope* side) const {
    for (int axis = 0; axis < 2; ++axis) {
      side->extents[axis] = extent_of(side->points, axis, 0.5 * cell_);
    }
  }

  // Slopes that a dormer or a step in the eaves has cut into several.
  void unite_coplanar() {
    for (size_t i = 0; i < sides_.size(); ++i) {
      for (size_t j = i + 1; j < sides_.size();) {
        Slope& a = sides_[i];
        Slope& b = sides_[j];
        const Eigen::Vector2d in_a = mean(a), in_b = mean(b);
        const bool one = a.falls != 0 && a.falls == b.falls && a.axis == b.axis &&
                         std::abs(a.at(in_a) - b.at(in_a)) < options_.coplanar &&
                         std::abs(a.at(in_b) - b.at(in_b)) < options_.coplanar &&
                         nearly_one_slope(a, b);
        if (!one) {
          ++j;
          continue;
        }
        const auto n = static_cast<double>(a.points.size()),
                   m = static_cast<double>(b.points.size());
        a.gradient = (n * a.gradient + m * b.gradient) / (n + m);
        a.constant = (n * a.constant + m * b.constant) / (n + m);
        a.points.insert(a.points.end(), b.points.begin(), b.points.end());
        a.planes.insert(a.planes.end(), b.planes.begin(), b.planes.end());
        sides_.erase(sides_.begin() + static_cast<std::ptrdiff_t>(j));
      }
    }
  }

  static Eigen::Vector2d mean(const Slope& side) {
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    for (const Eigen::Vector2d& p : side.points) sum += p;
    return sum / static_cast<double>(side.points.size());
  }

  bool nearly_one_slope(const Slope& a, const Slope& b) const {
    const double steeper = std::max(a.slope(), b.slope());
    return std::abs(a.slope() - b.slope()) < std::max(0.1, options_.slope_ratio * steeper);
  }

  // Where the two slopes of a pair meet: across their axis, and how high.
  struct Ridge {
    Slope* up = nullptr;    // falls to +
    Slope* down = nullptr;  // falls to -
    double across = 0.0, height = 0.0;
    size_t pixels = 0;
  };

  std::optional<Ridge> ridge_of(Slope* up, Slope* down) const {
    const int axis = up->axis, along = 1 - axis;
    if (!nearly_one_slope(*up, *down)) return std::nullopt;
    const Extent& a = up->extents[along];
    const Extent& b = down->extents[along];
    if (a.overlap(b) < 0.4 * std::min(a.length(), b.length())) return std::nullopt;
    Eigen::Vector2d p = Eigen::Vector2d::Zero();
    p[along] = 0.5 * (std::max(a.low, b.low) + std::min(a.high, b.high));
    Ridge ridge{up, down, 0.0, 0.0, up->points.size() + down->points.size()};
    ridge.across = (up->at(p) - down->at(p)) / (down->gradient[axis] - up->gradient[axis]);
    p[axis] = ridge.across;
    ridge.height = up->at(p);
    const bool between = up->extents[axis].low > ridge.across - options_.ridge_gap &&
                         up->extents[axis].low < ridge.across + options_.ridge_gap &&
                         down->extents[axis].high > ridge.across - options_.ridge_gap &&
                         down->extents[axis].high < ridge.across + options_.ridge_gap;
    if (!between) return std::nullopt;
    return ridge;
  }

  std::optional<PlaneBlock> next_gable() {
    std::optional<Ridge> best;
    for (Slope& up : sides_) {
      if (up.used || up.falls != 1) continue;
      for (Slope& down : sides_) {
        if (down.used || down.falls != -1 || down.axis != up.axis) continue;
        const std::optional<Ridge> ridge = ridge_of(&up, &down);
        if (ridge && (!best || ridge->pixels > best->pixels)) best = ridge;
      }
    }
    if (!best) return std::nullopt;
    return gable_of(*best);
  }

  PlaneBlock gable_of(const Ridge& ridge) {
    const int axis = ridge.up->axis, along = 1 - axis;
    ridge.up->used = ridge.down->used = true;
    const double high = ridge.up->extents[axis].high, low = ridge.down->extents[axis].low;
    double half = std::max(high - ridge.across, ridge.across - low), across = ridge.across;
    if (std::abs(high + low - 2.0 * ridge.across) < kSameHalf) {
      half = 0.5 * (high - low);
      across = 0.5 * (high + low);
    }
    Extent length = {std::min(ridge.up->extents[along].low, ridge.down->extents[along].low),
                     std::max(ridge.up->extents[along].high, ridge.down->extents[along].high)};
    const auto n = static_cast<double>(ridge.up->points.size());
    const auto m = static_cast<double>(ridge.down->points.size());
    const double slope = (n * ridge.up->slope() + m * ridge.down->slope()) / (n + m);

    PlaneBlock block;
    block.planes = ridge.up->planes;
    block.planes.insert(block.planes.end(), ridge.down->planes.begin(), ridge.down->planes.end());
    block.pixels = static_cast<int>(ridge.pixels);
    block.roof_origin = "crease of " + named(block.planes);

    // Hips: first who they are, since they lengthen the block.
    Slope* ends[2] = {nullptr, nullptr};  // at the low and at the high end
    double ridge_ends[2] = {0.0, 0.0};
    for (Slope& hip : sides_) {
      if (hip.used || hip.falls == 0 || hip.axis != along) continue;
      Eigen::Vector2d p = Eigen::Vector2d::Zero();
      p[axis] = ridge.across;
      const double end = (ridge.height - hip.at(p)) / hip.gradient[along];
      const int which = hip.falls > 0 ? 1 : 0;
      const double limit = which == 1 ? length.high : length.low;
      const double outer = which == 1 ? hip.extents[along].high : hip.extents[along].low;
      const double within = static_cast<double>(
          std::count_if(hip.points.begin(), hip.points.end(), [&](const Eigen::Vector2d& q) {
            return std::abs(q[axis] - across) < half + 0.5 * cell_;
          }));
      const double middle = 0.5 * (length.low + length.high);
      if (within < kShareWithin * static_cast<double>(hip.points.size())) continue;
      if (hip.falls * (outer - limit) < -kSameEnd) continue;
      if (hip.falls * (end - middle) < -kSameEnd || hip.falls * (outer - end) < 0.0) continue;
      if (ends[which] != nullptr && ends[which]->points.size() >= hip.points.size()) continue;
      ends[which] = &hip;
      ridge_ends[which] = end;
    }
    double ratios[2] = {0.0, 0.0};
    for (int which = 0; which < 2; ++which) {
      if (ends[which] == nullptr) continue;
      ends[which]->used = true;
      const Extent& reach = ends[which]->extents[along];
      if (which == 0) length.low = std::min(length.low, reach.low);
      if (which == 1) length.high = std::max(length.high, reach.high);
      block.pixels += static_cast<int>(ends[which]->points.size());
      block.planes.insert(block.planes.end(), ends[which]->planes.begin(),
                          ends[which]->planes.end());
      block.roof_origin += ", hip by " + named(ends[which]->planes);
    }
    if (ends[0] != nullptr) ratios[0] = (ridge_ends[0] - length.low) / length.length();
    if (ends[1] != nullptr) ratios[1] = (length.high - ridge_ends[1]) / length.length();

    Rule roof = make_rule(RuleKind::kRoofHip);
    roof.ridge = axis == 0 ? Axis::kY : Axis::kX;
    roof[param::roof::kRise] = slope * half;
    roof[param::roof::kEaves] = std::max(1.0, ridge.height - slope * half);
    roof[param::roof::kHipStart] = std::clamp(ratios[0], kCommonHip, 0.48);
    roof[param::roof::kHipEnd] = std::clamp(ratios[1], kCommonHip, 0.48);
    const Extent width = {across - half, across + half};
    const Extent& x = axis == 0 ? width : length;
    const Extent& y = axis == 0 ? length : width;
    block.roofed = {x.low, x.high, y.low, y.high, roof};
    block.footprint_origin = "extents of " + named(block.planes);
    return block;
  }

  bool is_within(const Eigen::Vector2d& p, const RoofedRectangle& r) const {
    return p.x() > r.x0 && p.x() < r.x1 && p.y() > r.y0 && p.y() < r.y1;
  }

  void add_flat_ones() {
    const size_t num_gables = blocks_.size();
    for (Slope& side : sides_) {
      if (side.used) continue;
      if (!side.flat && side.falls == 0) continue;
      bool on_roof = false;
      for (size_t g = 0; g < num_gables; ++g) {
        const auto within = std::count_if(
            side.points.begin(), side.points.end(),
            [&](const Eigen::Vector2d& p) { return is_within(p, blocks_[g].roofed); });
        on_roof = on_roof || static_cast<double>(within) >
                                 kShareOnRoof * static_cast<double>(side.points.size());
      }
      if (on_roof) continue;
      side.used = true;
      if (is_half_a_gable(side)) {
        add_mirrored(side);
      } else {
        add_flat(side, side.points, 2);
      }
    }
  }

  // The ridge of a slope whose other side is hidden under something: its upper edge.
  static double upper_edge(const Slope& side) {
    const Extent& across = side.extents[side.axis];
    return side.falls > 0 ? across.low : across.high;
  }

  // Whether a slope that has no counterpart is steep enough for a roof, and the building goes on
  // beyond its upper edge.
  bool is_half_a_gable(const Slope& side) const {
    if (side.flat || side.slope() < options_.least_half_slope) return false;
    const double ridge = upper_edge(side), half = side.extents[side.axis].length();
    const Extent& along = side.extents[1 - side.axis];
    size_t beyond = 0;
    for (const Slope& other : sides_) {
      for (const Eigen::Vector2d& p : other.points) {
        const double past = side.falls * (ridge - p[side.axis]);
        beyond += past > 0.0 && past < half && p[1 - side.axis] > along.low &&
                  p[1 - side.axis] < along.high;
      }
    }
    return static_cast<double>(beyond) > kShareBeyond * static_cast<double>(side.points.size());
  }

  // A gable of a slope and its mirror image.
  void add_mirrored(const Slope& side) {
    const double ridge = upper_edge(side), half = side.extents[side.axis].length();
    const Extent width = {ridge - half, ridge + half};
    Eigen::Vector2d p = side.middle();
    p[side.axis] = ridge;
    Rule roof = make_rule(RuleKind::kRoofHip);
    roof.ridge = side.axis == 0 ? Axis::kY : Axis::kX;
    roof[param::roof::kRise] = side.slope() * half;
    roof[param::roof::kEaves] = std::max(1.0, side.at(p) - side.slope() * half);
    roof[param::roof::kHipStart] = roof[param::roof::kHipEnd] = kCommonHip;
    const Extent& along = side.extents[1 - side.axis];
    const Extent& x = side.axis == 0 ? width : along;
    const Extent& y = side.axis == 0 ? along : width;
    PlaneBlock block;
    block.roofed = {x.low, x.high, y.low, y.high, roof};
    block.planes = side.planes;
    block.pixels = static_cast<int>(side.points.size());
    block.footprint_origin = "extent of " + named(side.planes) + " and its mirror image";
    block.roof_origin = "slope of " + named(side.planes) + ", its counterpart hidden";
    blocks_.push_back(std::move(block));
  }

  // One rectangle, or two where one is filled badly.
  void add_flat(const Slope& side, const std::vector<Eigen::Vector2d>& points, int splits) {
    if (points.empty()) return;
    const Extent x = extent_of(points, 0, 0.5 * cell_), y = extent_of(points, 1, 0.5 * cell_);
    const double area = static_cast<double>(points.size()) * cell_ * cell_;
    if (splits > 0 && area < options_.least_fill * x.length() * y.length()) {
      if (const auto parts = best_split(points, x, y)) {
        add_flat(side, parts->first, splits - 1);
        add_flat(side, parts->second, splits - 1);
        return;
      }
    }
    Rule roof = make_rule(RuleKind::kRoofFlat);
    const Eigen::Vector2d middle(0.5 * (x.low + x.high), 0.5 * (y.low + y.high));
    roof[param::roof::kEaves] = std::max(1.0, side.at(middle));
    PlaneBlock block;
    block.roofed = {x.low, x.high, y.low, y.high, roof};
    block.planes = side.planes;
    block.pixels = static_cast<int>(points.size());
    block.footprint_origin = "extents of " + named(side.planes);
    block.roof_origin = "height of " + named(side.planes);
    blocks_.push_back(std::move(block));
  }

  using Points = std::vector<Eigen::Vector2d>;

  // The cut along an axis that leaves two rectangles of the least area, if that is clearly less
  // than the one's.
  std::optional<std::pair<Points, Points>> best_split(const Points& points, const Extent& x,
                                                      const Extent& y) const {
    double least = 0.9 * x.length() * y.length();
    std::optional<std::pair<Points, Points>> best;
    const double shortest = std::max(2.0, 2.0 * cell_);
    for (int axis = 0; axis < 2; ++axis) {
      const Extent& range = axis == 0 ? x : y;
      for (double cut = range.low + shortest; cut < range.high - shortest; cut += cell_) {
        std::pair<Points, Points> parts;
        for (const Eigen::Vector2d& p : points) {
          (p[axis] < cut ? parts.first : parts.second).push_back(p);
        }
        if (parts.first.empty() || parts.second.empty()) continue;
        double area = 0.0;
        for (const Points* part : {&parts.first, &parts.second}) {
          area +=
              extent_of(*part, 0, 0.5 * cell_).length() * extent_of(*part, 1, 0.5 * cell_).length();
        }
        if (area < least) {
          least = area;
          best = std::move(parts);
        }
      }
    }
    return best;
  }

  const PlaneBlockOptions& options_;
  const double cell_;
  std::vector<Slope> sides_;
  std::vector<PlaneBlock> blocks_;
};

}  // namespace

std::string check(const PlaneBlockOptions& options) {
  if (!(options.flat_slope > 0.0)) return "flat_slope must be positive";
  if (!(options.least_area > 0.0)) return "least_area must be positive";
  if (!(options.least_height >= 0.0)) return "least_height must not be negative";
  if (!(options.ridge_gap > 0.0)) return "ridge_gap must be positive";
  if (!(options.slope_ratio > 0.0 && options.slope_ratio < 1.0)) {
    return "slope_ratio must lie in (0, 1)";
  }
  if (!(options.least_half_slope > 0.0)) return "least_half_slope must be positive";
  if (!(options.coplanar > 0.0)) return "coplanar must be positive";
  if (!(options.least_fill > 0.0 && options.least_fill < 1.0)) {
    return "least_fill must lie in (0, 1)";
  }
  return "";
}

std::vector<PlaneBlock> plane_blocks(const HeightImage& image, const HouseScale& scale, double cell,
                                     double azimuth, const PlaneBlockOptions& options) {
  CHECK(check(options).empty()) << check(options);
  return BlockReader(image, scale, cell, azimuth, options).read();
}

}  // namespace gable
