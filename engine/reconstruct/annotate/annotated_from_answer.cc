#include <gable/engine/detectors/house_crop.h>
#include <gable/engine/error.h>
#include <gable/engine/reconstruct/annotate/annotated_from_answer.h>
#include <gable/grammar/plan_outline.h>
#include <gable/grammar/wing_polygons.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace gable {
namespace {

// Corners of L and U may be off a straight edge by this much, crop pixels.
constexpr double kStraight = 1.0;

// Points may lie this far outside of the crop, pixels: proposals reach a little beyond it.
constexpr double kBeyond = 32.0;

// What make_house_crop adds around a building, as a share of its side.
constexpr double kMargin = 0.2;

class Check {
 public:
  explicit Check(std::string where) : where_(std::move(where)) {}
  void require(bool holds, const std::string& problem) const {
    if (!holds) throw Error(ExitCode::kBadInput, where_ + ": " + problem);
  }

 private:
  std::string where_;
};

House house_of_rectangles(const std::vector<CropRectangle>& rectangles) {
  std::vector<RoofedRectangle> blocks;
  for (const CropRectangle& r : rectangles) {
    blocks.push_back({r.x0, r.x1, r.y0, r.y1, make_rule(RuleKind::kRoofFlat)});
  }
  return blocks_house(blocks, 0.0);
}

/// Pulls the edges of a polygon onto the axes: every second edge along x. False where a corner
/// would move by more than kStraight.
bool straighten(std::vector<Eigen::Vector2d>* ring) {
  const size_t n = ring->size();
  const Eigen::Vector2d first = (*ring)[1] - (*ring)[0];
  const int first_axis = std::abs(first.x()) >= std::abs(first.y()) ? 0 : 1;
  for (size_t i = 0; i < n; ++i) {
    Eigen::Vector2d& a = (*ring)[i];
    Eigen::Vector2d& b = (*ring)[(i + 1) % n];
    const int across = (i % 2 == 0) == (first_axis == 0) ? 1 : 0;
    if (std::abs(a[across] - b[across]) > kStraight) return false;
    if (std::abs(a[1 - across] - b[1 - across]) <= kStraight) return false;
    a[across] = b[across] = 0.5 * (a[across] + b[across]);
  }
  return true;
}

/// Which corners of a polygon turn against the rest of it.
std::vector<size_t> concave_corners(const std::vector<Eigen::Vector2d>& ring) {
  const size_t n = ring.size();
  std::vector<size_t> left, right;
  double area = 0.0;
  for (size_t i = 0; i < n; ++i) {
    const Eigen::Vector2d& a = ring[(i + n - 1) % n];
    const Eigen::Vector2d& b = ring[i];
    const Eigen::Vector2d& c = ring[(i + 1) % n];
    const Eigen::Vector2d in = b - a, out = c - b;
    (in.x() * out.y() - in.y() * out.x() > 0.0 ? left : right).push_back(i);
    area += b.x() * c.y() - b.y() * c.x();
  }
  return area > 0.0 ? right : left;
}

bool is_wing_polygon(const std::vector<Eigen::Vector2d>& ring) {
  const std::vector<size_t> concave = concave_corners(ring);
  if (ring.size() == 6) return concave.size() == 1;
  if (concave.size() != 2) return false;
  const size_t apart = concave[1] - concave[0];  // of a U they are neighbours
  return apart == 1 || apart == ring.size() - 1;
}

void check_places(const HouseAnswer& answer, const Check& check) {
  std::vector<std::vector<Eigen::Vector2d>> all = answer.garages;
  all.push_back(answer.polygon);
  all.push_back(answer.dormers);
  all.push_back(answer.chimneys);
  for (const CropRectangle& r : answer.rectangles) all.push_back({{r.x0, r.y0}, {r.x1, r.y1}});
  for (const auto& points : all) {
    for (const Eigen::Vector2d& p : points) {
      check.require(p.minCoeff() >= -kBeyond && p.maxCoeff() <= kCropSize + kBeyond,
                    "a point lies far outside of the crop; its pixels go from 0 to 64");
    }
  }
}

Eigen::AlignedBox2d box_of(const std::vector<Eigen::Vector2d>& points) {
  Eigen::AlignedBox2d box;
  for (const Eigen::Vector2d& p : points) box.extend(p);
  return box;
}

std::vector<Eigen::Vector2d> in_world(const std::vector<Eigen::Vector2d>& points,
                                      const CropFrame& frame) {
  std::vector<Eigen::Vector2d> world;
  for (const Eigen::Vector2d& p : points) world.push_back(frame.world_from_crop(p));
  return world;
}

std::vector<Eigen::Vector2d> in_crop(const std::vector<Eigen::Vector2d>& points,
                                     const CropFrame& frame) {
  std::vector<Eigen::Vector2d> crop;
  for (const Eigen::Vector2d& p : points) crop.push_back(frame.crop_from_world(p));
  return crop;
}

}  // namespace

std::vector<Eigen::Vector2d> outline_of_answer(const HouseAnswer& answer) {
  if (!answer.polygon.empty() || answer.rectangles.empty()) return answer.polygon;
  const std::vector<PlanPolygon> pieces = plan_outline(house_of_rectangles(answer.rectangles));
  return pieces.size() == 1 ? pieces.front().outer : std::vector<Eigen::Vector2d>();
}

AnnotatedHouse annotated_from_answer(const HouseAnswer& answer, const std::string& where) {
  const Check check(where + ": " + answer.id);
  const std::string name(foundation_name(answer.foundation));
  const size_t rectangles = static_cast<size_t>(num_annotated_rectangles(answer.foundation));
  const size_t roofs = static_cast<size_t>(num_annotated_roofs(answer.foundation));
  const size_t corners = static_cast<size_t>(num_annotated_corners(answer.foundation));
  check.require(answer.confidence.has_value(), "give its \"confidence\": high, medium or low");
  check.require(answer.rectangles.size() == rectangles,
                "foundation " + name + " wants " + std::to_string(rectangles) +
                    " rectangles, not " + std::to_string(answer.rectangles.size()));
  check.require(answer.roofs.size() == roofs, "foundation " + name + " wants " +
                                                  std::to_string(roofs) + " roofs, not " +
                                                  std::to_string(answer.roofs.size()));
  for (const CropRectangle& r : answer.rectangles) {
    check.require(r.x1 - r.x0 >= 1.0 && r.y1 - r.y0 >= 1.0,
                  "a rectangle is not [x0, y0, x1, y1] with x0 < x1 and y0 < y1");
  }
  check_places(answer, check);
  std::vector<Eigen::Vector2d> outline = outline_of_answer(answer);
  if (corners > 0) {
    check.require(outline.size() == corners, "foundation " + name + " wants a polygon of " +
                                                 std::to_string(corners) + " corners, not " +
                                                 std::to_string(outline.size()));
    check.require(straighten(&outline), "the edges of the polygon are not along x and y in turns");
    check.require(is_wing_polygon(outline), "the polygon is no " + name);
  }
  check.require(!outline.empty() || answer.rectangles.empty(), "the rectangles do not touch");
  check.require(outline.size() >= 3, "the polygon has fewer than 3 corners");

  AnnotatedHouse house;
  house.id = answer.id;
  house.azimuth = answer.frame.azimuth;
  house.center = answer.frame.world_from_crop(box_of(outline).center());
  house.foundation = answer.foundation;
  for (const CropRectangle& r : answer.rectangles) {
    const auto at = [&](double x, double y) { return answer.frame.world_from_crop({x, y}); };
    house.components.push_back({at(r.x0, r.y0), at(r.x1, r.y0), at(r.x0, r.y1), at(r.x1, r.y1)});
  }
  house.outline = in_world(outline, answer.frame);
  house.roofs = answer.roofs;
  house.dormers = in_world(answer.dormers, answer.frame);
  house.chimneys = in_world(answer.chimneys, answer.frame);
  for (const auto& ring : answer.garages) house.garages.push_back(in_world(ring, answer.frame));
  house.confidence = *answer.confidence;
  return house;
}

HouseAnswer answer_from_annotated(const AnnotatedHouse& house) {
  HouseAnswer answer;
  answer.id = house.id;
  answer.proposed = foundation_name(house.foundation);
  answer.foundation = house.foundation;
  answer.roofs = house.roofs;
  answer.confidence = house.confidence;
  answer.reviewed = true;

  CropFrame& frame = answer.frame;
  frame.azimuth = house.azimuth;
  frame.pixel = 1.0;
  const Eigen::AlignedBox2d box = box_of(in_crop(house.outline, frame));
  const double side = std::max(box.sizes().maxCoeff(), 1.0) * (1.0 + 2.0 * kMargin);
  frame.north_west = frame.world_from_crop(box.center() - Eigen::Vector2d::Constant(0.5 * side));
  frame.pixel = side / kCropSize;

  for (const auto& corners : house.components) {
    const Eigen::AlignedBox2d r = box_of(in_crop({corners.begin(), corners.end()}, frame));
    answer.rectangles.push_back({r.min().x(), r.max().x(), r.min().y(), r.max().y()});
  }
  answer.polygon = in_crop(house.outline, frame);
  answer.dormers = in_crop(house.dormers, frame);
  answer.chimneys = in_crop(house.chimneys, frame);
  for (const auto& ring : house.garages) answer.garages.push_back(in_crop(ring, frame));
  return answer;
}

}  // namespace gable
