#include <gable/engine/reconstruct/first_values/azimuth.h>
#include <gable/engine/reconstruct/first_values/plane_azimuth.h>
#include <gable/engine/reconstruct/first_values/scale_values.h>
#include <gable/grammar/wing_polygons.h>
#include <glog/logging.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace gable {
namespace {

// Directions nearer than this are one, radians; only the first is of interest here.
constexpr double kSeparation = 0.1;

// Wings of an L or a U stand out of each other by at least this, metres.
constexpr double kLeastWing = 1.5;

// A base along x and a wing along y that share an outer corner: which one, and how far apart the
// two have it.
struct SharedCorner {
  Side corner;
  double distance = 0.0;
};

std::optional<SharedCorner> shared_corner(const RoofedRectangle& along_x,
                                          const RoofedRectangle& along_y, double same) {
  std::optional<SharedCorner> best;
  for (const double sx : {-1.0, 1.0}) {
    for (const double sy : {-1.0, 1.0}) {
      const double dx = sx < 0.0 ? along_x.x0 - along_y.x0 : along_x.x1 - along_y.x1;
      const double dy = sy < 0.0 ? along_x.y0 - along_y.y0 : along_x.y1 - along_y.y1;
      // How far the wings reach beyond each other at their other ends.
      const double reach_x = sx < 0.0 ? along_x.x1 - along_y.x1 : along_y.x0 - along_x.x0;
      const double reach_y = sy < 0.0 ? along_y.y1 - along_x.y1 : along_x.y0 - along_y.y0;
      const double distance = std::max(std::abs(dx), std::abs(dy));
      if (distance > same || reach_x < kLeastWing || reach_y < kLeastWing) continue;
      if (!best || distance < best->distance) best = {Side(sx, sy), distance};
    }
  }
  return best;
}

class HouseMaker {
 public:
  HouseMaker(const HeightImage& image, std::vector<PlaneBlock> blocks, double azimuth,
             std::string azimuth_origin, const ScaleValuesOptions& options)
      : origin_(image.origin),
        blocks_(std::move(blocks)),
        azimuth_(azimuth),
        azimuth_origin_(std::move(azimuth_origin)),
        options_(options) {}

  std::vector<FirstValue> make() {
    const auto n = static_cast<int>(std::min<size_t>(3, blocks_.size()));
    if (n == 3) add_u();
    if (n >= 2) add_ls(n);
    for (int count = n; count >= 1; --count) {
      std::vector<RoofedRectangle> rectangles;
      std::vector<int> used;
      for (int i = 0; i < count; ++i) {
        rectangles.push_back(blocks_[i].roofed);
        used.push_back(i);
      }
      add(blocks_house(rectangles, azimuth_), used);
    }
    return std::move(values_);
  }

 private:
  void add(House house, const std::vector<int>& used) {
    if (static_cast<int>(values_.size()) >= options_.most_houses) return;
    house.origin = origin_;
    FirstValue value;
    value.source = ValueSource::kScales;
    value.origins = {azimuth_origin_};
    // An L's or U's polygon is of all its wings.
    if (house.footprints.size() == 1) {
      std::string all;
      for (int i : used) all += (all.empty() ? "" : "; ") + blocks_[i].footprint_origin;
      value.origins.push_back(all);
    } else {
      for (int i : used) value.origins.push_back(blocks_[i].footprint_origin);
    }
    for (int i : used) value.origins.push_back(blocks_[i].roof_origin);
    value.house = std::move(house);
    values_.push_back(std::move(value));
  }

  const RoofedRectangle& block(int i) const { return blocks_[i].roofed; }

  // The L of the pair that shares its corner best.
  void add_ls(int n) {
    int best_x = -1, best_y = -1;
    std::optional<SharedCorner> best;
    for (int x = 0; x < n; ++x) {
      for (int y = 0; y < n; ++y) {
        if (x == y) continue;
        const auto corner = shared_corner(block(x), block(y), options_.same_corner);
        if (!corner || (best && best->distance <= corner->distance)) continue;
        best = corner;
        best_x = x;
        best_y = y;
      }
    }
    if (!best) return;
    // Turned by l_house, wing x may become wing y, and its roof the second.
    House house = l_house(block(best_x), block(best_y), best->corner, azimuth_);
    const bool swapped = best->corner.x() * best->corner.y() < 0.0;
    add(std::move(house),
        swapped ? std::vector<int>{best_y, best_x} : std::vector<int>{best_x, best_y});
  }

  void add_u() {
    for (int base = 0; base < 3; ++base) {
      const int a = (base + 1) % 3, b = (base + 2) % 3;
      for (const bool base_along_x : {true, false}) {
        const auto corner_with = [&](int wing) {
          return base_along_x ? shared_corner(block(base), block(wing), options_.same_corner)
                              : shared_corner(block(wing), block(base), options_.same_corner);
        };
        const auto p = corner_with(a), q = corner_with(b);
        if (!p || !q) continue;
        // Both stand to the same side of the base, at its two ends.
        const int across = base_along_x ? 1 : 0;
        if (p->corner[across] != q->corner[across] ||
            p->corner[1 - across] == q->corner[1 - across]) {
          continue;
        }
        Side open = Side::Zero();
        open[across] = -p->corner[across];
        House house = u_house(block(base), block(a), block(b), open, azimuth_);
        // u_house orders its wings along the base.
        QuarterTurn turn(open);
        const bool a_first = turn.x_of(block(a)) < turn.x_of(block(b));
        add(std::move(house),
            a_first ? std::vector<int>{base, a, b} : std::vector<int>{base, b, a});
        return;
      }
    }
  }

  // Where rectangles come to lie along the base once `open` has been turned to +y.
  struct QuarterTurn {
    explicit QuarterTurn(const Side& open) : base(open.y(), -open.x()) {}
    double x_of(const RoofedRectangle& r) const {
      return base.dot(Eigen::Vector2d(0.5 * (r.x0 + r.x1), 0.5 * (r.y0 + r.y1)));
    }
    Eigen::Vector2d base;
  };

  const Eigen::Vector3d origin_;
  const std::vector<PlaneBlock> blocks_;
  const double azimuth_;
  const std::string azimuth_origin_;
  const ScaleValuesOptions& options_;
  std::vector<FirstValue> values_;
};

}  // namespace

std::string check(const ScaleValuesOptions& options) {
  if (const std::string error = check(options.blocks); !error.empty()) return error;
  if (!(options.least_share >= 0.0 && options.least_share <= 1.0)) {
    return "least_share must lie in [0, 1]";
  }
  if (!(options.same_corner > 0.0)) return "same_corner must be positive";
  if (options.most_houses < 1 || options.most_houses > 10) return "most_houses must lie in [1, 10]";
  return "";
}

std::vector<FirstValue> scale_values(const HeightImage& image, const HouseScales& scales,
                                     const ScaleValuesOptions& options) {
  CHECK(check(options).empty()) << check(options);
  if (scales.roofs().planes.empty()) return {};
  double azimuth = 0.0;
  std::string azimuth_origin;
  if (const auto by_planes = plane_azimuth(scales.roofs())) {
    azimuth = by_planes->azimuth;
    azimuth_origin = std::to_string(by_planes->planes) +
                     (by_planes->planes == 1 ? " plane's normal" : " planes' normals");
  } else {
    azimuth = azimuth_candidates(image, kSeparation).front().azimuth;
    azimuth_origin = "outline, since the planes have no direction";
  }
  const double cell = image.gsd * scales.stride;
  std::vector<PlaneBlock> blocks =
      plane_blocks(image, scales.roofs(), cell, azimuth, options.blocks);
  if (blocks.empty()) {
    PlaneBlockOptions any_slope = options.blocks;
    any_slope.flat_slope = std::numeric_limits<double>::infinity();
    blocks = plane_blocks(image, scales.blocks(), cell, azimuth, any_slope);
  }
  double all = 0.0;
  for (const PlaneBlock& block : blocks) all += block.pixels;
  std::erase_if(blocks, [&](const PlaneBlock& b) { return b.pixels < options.least_share * all; });
  if (blocks.empty()) return {};
  return HouseMaker(image, std::move(blocks), azimuth, azimuth_origin, options).make();
}

}  // namespace gable
