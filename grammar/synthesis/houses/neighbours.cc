#include <gable/grammar/block.h>
#include <gable/grammar/plan_outline.h>
#include <gable/grammar/synthesis/houses/neighbours.h>
#include <gable/grammar/synthesis/houses/plan_union.h>
#include <gable/grammar/synthesis/houses/prior.h>
#include <gable/grammar/synthesis/houses/random_roof.h>
#include <gable/grammar/synthesis/houses/rectangle.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace gable {
namespace {

constexpr double kSharedWall = 3.0;

/// What stands on the ground of a house, in its frame: components, then garages.
struct Plan {
  std::vector<Block<double>> components;
  std::vector<Rectangle> rectangles;

  explicit Plan(const House& house) {
    const auto blocks = expand_blocks(house);
    const auto sources = block_sources(house);
    for (size_t i = 0; i < blocks.size(); ++i) {
      if (stands_on_roof(sources[i].role)) continue;
      rectangles.push_back(rectangle_of(blocks[i]));
      if (sources[i].role == BlockRole::kComponent) components.push_back(blocks[i]);
    }
  }
};

/// A wall of a component: 0 +x, 1 -x, 2 +y, 3 -y.
struct Wall {
  int component = 0;
  int side = 0;
};

bool is_gable_end(const Block<double>& block, int side) {
  using namespace block_value;
  if (block.flat) return true;
  const bool at_end = (block.ridge == Axis::kX) == (side < 2);
  const bool at_start = side == 1 || side == 3;
  return at_end && block[at_start ? kHipStart : kHipEnd] == 0.0;
}

/// Where neighbours stand: mostly at gable ends.
Wall random_wall(const Plan& plan, Random* random) {
  Wall wall;
  const bool want_gable = random->chance(0.75);
  for (int attempt = 0; attempt < 6; ++attempt) {
    wall.component = random->integer(0, static_cast<int>(plan.components.size()) - 1);
    wall.side = random->integer(0, 3);
    if (!want_gable || is_gable_end(plan.components[wall.component], wall.side)) break;
  }
  return wall;
}

/// A rectangle that stands `gap` off a wall.
Rectangle beside(const Rectangle& r, int side, double gap, double depth, double start,
                 double along) {
  switch (side) {
    case 0:
      return {r.x1 + gap, r.x1 + gap + depth, start, start + along};
    case 1:
      return {r.x0 - gap - depth, r.x0 - gap, start, start + along};
    case 2:
      return {start, start + along, r.y1 + gap, r.y1 + gap + depth};
    default:
      return {start, start + along, r.y0 - gap - depth, r.y0 - gap};
  }
}

bool has_room(const Rectangle& r, double gap, const std::vector<Rectangle>& others) {
  return std::all_of(others.begin(), others.end(), [&](const Rectangle& other) {
    return gap > 0.0 ? distance(r, other) >= std::min(gap, 0.4) : shared_area(r, other) <= 1e-9;
  });
}

Block<double> block_over(const Rectangle& r, const Rule& roof) {
  using namespace block_value;
  Block<double> block;
  block.values = {r.x0, r.x1, r.y0, r.y1, roof[param::roof::kEaves], 0.0, 0.0, 0.0};
  block.flat = roof.kind == RuleKind::kRoofFlat;
  block.ridge = roof.ridge;
  if (!block.flat) block[kRise] = roof[param::roof::kRise];
  if (roof.kind == RuleKind::kRoofHip) {
    block[kHipStart] = roof[param::roof::kHipStart];
    block[kHipEnd] = roof[param::roof::kHipEnd];
  }
  return block;
}

/// The roof of a neighbour over `r`: that of the block it stands at, a step up or down, or another.
Block<double> random_roof_beside(const Block<double>& of, const Rectangle& r, int side,
                                 Random* random) {
  using namespace block_value;
  const double step = random->chance(0.5) ? 0.0 : random->uniform(-3.0, 3.0);
  const double eaves = std::clamp(of[kEaves] + step, 2.3, 10.0);
  const double kind = random->uniform(0.0, 1.0);
  if (of.flat ? kind < 0.7 : kind < 0.12)
    return block_over(r, make_flat_roof(std::max(2.6, eaves)));
  const Rectangle at = rectangle_of(of);
  const double span = of.ridge == Axis::kX ? at.size_y() : at.size_x();
  const bool same_pitch = !of.flat && random->chance(0.7);
  const double pitch = same_pitch ? std::atan(of[kRise] / (0.5 * span)) : random_pitch(random);
  const Axis along_row = side < 2 ? Axis::kX : Axis::kY;
  const Axis other = side < 2 ? Axis::kY : Axis::kX;
  const Axis ridge =
      of.flat || random->chance(0.25) ? (random->chance(0.6) ? along_row : other) : of.ridge;
  const bool hipped_far = random->chance(0.3);
  const bool far_is_end = side == 0 || side == 2;
  const RoofEnd far = hipped_far ? RoofEnd::kHip : RoofEnd::kGable;
  const RoofEnd start = ridge == along_row && !far_is_end ? far : RoofEnd::kGable;
  const RoofEnd end = ridge == along_row && far_is_end ? far : RoofEnd::kGable;
  return block_over(r, make_roof(r, ridge, eaves, pitch, start, end, random));
}

/// Adds a block of the house's frame, where it is, to a shape in the world.
void add_block(const Block<double>& block, const House& house, BuiltShape* shape) {
  using namespace block_value;
  House alone;
  alone.origin = house.origin;
  alone.azimuth = house.azimuth;
  const Rectangle r = rectangle_of(block);
  using namespace param::rectangle;
  Rule footprint = make_rule(RuleKind::kFootprintI);
  footprint[kCenterX] = r.mid_x();
  footprint[kCenterY] = r.mid_y();
  footprint[kLength] = r.size_x();
  footprint[kWidth] = r.size_y();
  alone.footprints = {footprint};
  Rule roof = make_rule(block.flat ? RuleKind::kRoofFlat : RuleKind::kRoofHip);
  roof.ridge = block.ridge;
  roof[param::roof::kEaves] = block[kEaves];
  if (!block.flat) {
    roof[param::roof::kRise] = block[kRise];
    roof[param::roof::kHipStart] = block[kHipStart];
    roof[param::roof::kHipEnd] = block[kHipEnd];
  }
  alone.roofs = {roof};
  shape->append(shape_of(alone));
}

/// A stack astride the party wall, on the neighbour's side of it.
void add_stack(const Block<double>& block, int side, const House& house, Random* random,
               BuiltShape* shape) {
  using namespace block_value;
  const Rectangle r = rectangle_of(block);
  const double size = random->uniform(0.7, 1.4);
  const double from = 0.5 * ((side < 2 ? r.y0 + r.y1 : r.x0 + r.x1) - size);
  Rectangle at = beside(side == 0   ? Rectangle{r.x0, r.x0, 0.0, 0.0}
                        : side == 1 ? Rectangle{r.x1, r.x1, 0.0, 0.0}
                        : side == 2 ? Rectangle{0.0, 0.0, r.y0, r.y0}
                                    : Rectangle{0.0, 0.0, r.y1, r.y1},
                        side, 0.0, size, from, size);
  const double top = block[kEaves] + block[kRise] + random->uniform(0.6, 1.6);
  add_block(block_over(at, make_flat_roof(top)), house, shape);
}

BuiltShape random_row(bool party_wall, const House& house, Random* random) {
  const Plan plan(house);
  BuiltShape shape;
  std::vector<Rectangle> taken = plan.rectangles;
  const int wanted = random->chance(0.4) ? 2 : 1;
  int placed = 0;
  for (int attempt = 0; attempt < 16 && placed < wanted; ++attempt) {
    const Wall wall = random_wall(plan, random);
    const Block<double>& of = plan.components[wall.component];
    const Rectangle r = rectangle_of(of);
    const double w0 = wall.side < 2 ? r.y0 : r.x0, w1 = wall.side < 2 ? r.y1 : r.x1;
    const bool flush = random->chance(0.6);
    const double along = flush ? w1 - w0 : (w1 - w0) * random->uniform(0.7, 1.35);
    const double play = std::max(0.0, std::min(2.5, std::min(along, w1 - w0) - kSharedWall));
    const double shift = flush ? 0.0 : random->uniform(-play, play);
    const double start = 0.5 * (w0 + w1 - along) + shift;
    const double shared = std::min(w1, start + along) - std::max(w0, start);
    const double gap = party_wall ? 0.0 : random->uniform(0.4, 3.0);
    const double depth = random->chance(0.3) ? (wall.side < 2 ? r.size_x() : r.size_y())
                                             : random->uniform(4.5, 10.0);
    const Rectangle at = beside(r, wall.side, gap, depth, start, along);
    if (shared < kSharedWall || !has_room(at, gap, taken)) continue;
    const Block<double> block = random_roof_beside(of, at, wall.side, random);
    add_block(block, house, &shape);
    if (!block.flat && random->chance(0.3)) add_stack(block, wall.side, house, random, &shape);
    taken.push_back(at);
    ++placed;
    if (!random->chance(0.35)) continue;
    // The row goes on.
    const Rectangle next = beside(at, wall.side, 0.0, random->uniform(4.5, 9.0), start, along);
    if (has_room(next, gap, taken)) {
      add_block(random_roof_beside(block, next, wall.side, random), house, &shape);
      taken.push_back(next);
    }
  }
  return shape;
}

/// A house at any wall of an outline that is long enough, `gap` metres off it.
BuiltShape random_at_wall(double gap, const std::vector<Eigen::Vector2d>& outline, double ground,
                          Random* random) {
  for (int attempt = 0; attempt < 8; ++attempt) {
    const size_t k = static_cast<size_t>(random->integer(0, static_cast<int>(outline.size()) - 1));
    const Eigen::Vector2d& from = outline[k];
    const Eigen::Vector2d edge = outline[(k + 1) % outline.size()] - from;
    const double depth = random->uniform(4.5, 10.0);
    if (edge.norm() < kSharedWall + 1.0) continue;
    BuiltPart part;
    part.along = edge.normalized();
    const Eigen::Vector2d outward(part.along.y(), -part.along.x());
    part.half_length = 0.5 * edge.norm();
    part.half_width = 0.5 * depth;
    // A millimetre off, as two parties' walls are never the same.
    part.center = from + 0.5 * edge + (0.5 * depth + std::max(gap, 0.001)) * outward;
    part.eaves = ground + random_eaves(random);
    if (random->chance(0.8)) {
      part.form = PartForm::kGable;
      if (part.half_width > part.half_length || random->chance(0.3)) {
        part.along = outward;
        std::swap(part.half_width, part.half_length);
      }
      part.rise = part.half_width * std::tan(random_pitch(random));
    }
    if (ring_distance(outline, part.ring()) <= 0.0) continue;
    BuiltShape shape;
    shape.parts.push_back(part);
    return shape;
  }
  return {};
}

BuiltShape random_detached(const std::vector<Eigen::Vector2d>& outline, double azimuth,
                           double ground, Random* random) {
  PriorOptions options;
  options.garage_share = 0.3;
  House other = random_house(random, options);
  if (random->chance(0.6)) other.azimuth[0] = azimuth + 0.5 * M_PI * random->integer(0, 3);
  const double direction = random->uniform(0.0, 2.0 * M_PI);
  const Eigen::Vector2d outward(std::cos(direction), std::sin(direction));
  const double gap = random->uniform(3.0, 7.0);
  const BuiltShape around_origin = shape_of(other);
  const std::vector<Eigen::Vector2d> ring = outline_of(around_origin).outer;
  Eigen::Vector2d middle = Eigen::Vector2d::Zero();
  for (const auto& p : outline) middle += p / static_cast<double>(outline.size());
  for (double away = 8.0; away < 44.0; away += 1.0) {
    const Eigen::Vector2d to = middle + away * outward;
    std::vector<Eigen::Vector2d> moved = ring;
    for (auto& p : moved) p += to;
    if (ring_distance(outline, moved) < gap) continue;
    BuiltShape shape = around_origin;
    shape.move({to.x(), to.y(), ground});
    return shape;
  }
  return {};
}

}  // namespace

BuiltShape random_neighbours(NeighbourKind kind, const House& house, Random* random) {
  if (kind != NeighbourKind::kApart) {
    return random_row(kind == NeighbourKind::kPartyWall, house, random);
  }
  PlanPolygon largest;
  for (PlanPolygon& polygon : plan_outline(house)) {
    if (largest.outer.empty() || signed_area(polygon.outer) > signed_area(largest.outer)) {
      largest = std::move(polygon);
    }
  }
  for (auto& p : largest.outer) p += house.origin.head<2>();
  return random_detached(largest.outer, house.azimuth[0], house.origin.z(), random);
}

BuiltShape random_neighbours(NeighbourKind kind, const std::vector<Eigen::Vector2d>& outline,
                             double ground, Random* random) {
  if (kind == NeighbourKind::kApart) {
    const double azimuth = random->uniform(0.0, 2.0 * M_PI);
    return random_detached(outline, azimuth, ground, random);
  }
  const double gap = kind == NeighbourKind::kPartyWall ? 0.0 : random->uniform(0.4, 3.0);
  return random_at_wall(gap, outline, ground, random);
}

}  // namespace gable
