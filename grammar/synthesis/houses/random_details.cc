#include <gable/grammar/height_field.h>
#include <gable/grammar/synthesis/houses/random_details.h>
#include <gable/grammar/synthesis/houses/rectangle.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace gable {
namespace {

constexpr double kDegree = M_PI / 180.0;

/// A component's roof in coordinates along (u) and across (v) its ridge.
struct Slope {
  Block<double> block;
  bool along_x = true;
  double u0 = 0.0, u1 = 0.0, v0 = 0.0, v1 = 0.0;

  explicit Slope(const Block<double>& b) : block(b), along_x(b.ridge == Axis::kX) {
    const Rectangle r = rectangle_of(b);
    u0 = along_x ? r.x0 : r.y0;
    u1 = along_x ? r.x1 : r.y1;
    v0 = along_x ? r.y0 : r.x0;
    v1 = along_x ? r.y1 : r.x1;
  }
  double half_span() const { return 0.5 * (v1 - v0); }
  double tangent() const { return block[block_value::kRise] / half_span(); }
  double eaves() const { return block[block_value::kEaves]; }
  double top() const { return eaves() + block[block_value::kRise]; }
  double start_run() const { return block[block_value::kHipStart] * (u1 - u0); }
  double end_run() const { return block[block_value::kHipEnd] * (u1 - u0); }
  Eigen::Vector2d point(double u, double v) const {
    return along_x ? Eigen::Vector2d(u, v) : Eigen::Vector2d(v, u);
  }
  Rectangle rectangle(double ua, double ub, double va, double vb) const {
    return along_x ? Rectangle{ua, ub, va, vb} : Rectangle{va, vb, ua, ub};
  }
};

std::vector<Rectangle> rectangles_of(const House& house, BlockRole role) {
  std::vector<Rectangle> rectangles;
  const auto blocks = expand_blocks(house);
  const auto sources = block_sources(house);
  for (size_t i = 0; i < blocks.size(); ++i) {
    if (sources[i].role == role) rectangles.push_back(rectangle_of(blocks[i]));
  }
  return rectangles;
}

bool is_clear(const Rectangle& rectangle, const std::vector<Rectangle>& others, double gap,
              int except = -1) {
  for (int i = 0; i < static_cast<int>(others.size()); ++i) {
    if (i != except && distance(rectangle, others[i]) < gap) return false;
  }
  return true;
}

/// The highest point of the house over a rectangle: corners, edges and ridge lines, sampled.
double highest_roof(const House& house, const Rectangle& r) {
  const HeightField field(house);
  std::vector<double> xs, ys;
  constexpr int kSteps = 8;
  constexpr double kInside = 1e-9;  // the field's rectangles are open at their upper sides
  for (int i = 0; i <= kSteps; ++i) {
    xs.push_back(r.x0 + (r.size_x() - kInside) * i / kSteps);
    ys.push_back(r.y0 + (r.size_y() - kInside) * i / kSteps);
  }
  for (const Block<double>& block : field.blocks()) {
    const Rectangle b = rectangle_of(block);
    if (b.mid_x() > r.x0 && b.mid_x() < r.x1) xs.push_back(b.mid_x());
    if (b.mid_y() > r.y0 && b.mid_y() < r.y1) ys.push_back(b.mid_y());
  }
  double highest = 0.0;
  for (double x : xs) {
    for (double y : ys) highest = std::max(highest, field.at_house({x, y}, 0.0, 0.0));
  }
  return highest;
}

/// Size and place across the slope of a row of dormers.
struct DormerShape {
  double width, depth, front, eaves, rise;
};

/// Draws a shape that dies into the slope below the ridge. False where the slope is too small.
bool draw_dormer_shape(const Slope& slope, Random* random, DormerShape* shape) {
  if (slope.block.flat || slope.tangent() < std::tan(30.0 * kDegree)) return false;
  for (int attempt = 0; attempt < 20; ++attempt) {
    shape->width = random->uniform(1.6, 2.6);
    shape->rise = 0.5 * shape->width * std::tan(random->uniform(24.0, 36.0) * kDegree);
    const double lift = random->uniform(0.9, 1.5);
    shape->front = random->uniform(0.3, 1.0);
    shape->depth = (lift + shape->rise) / slope.tangent();
    shape->eaves = slope.eaves() + shape->front * slope.tangent() + lift;
    if (shape->depth >= 1.5 && shape->depth <= 3.4 &&
        shape->front + shape->depth <= slope.half_span() - 0.1) {
      return true;
    }
  }
  return false;
}

/// Whether a part [ua, ub] of the slope, as high as `reach` across, lies clear of the hips.
bool clear_of_hips(const Slope& slope, double ua, double ub, double reach) {
  const double share = reach / slope.half_span();
  return ua - slope.u0 >= slope.start_run() * share + 0.3 &&
         slope.u1 - ub >= slope.end_run() * share + 0.3;
}

bool add_dormer_row(int component, const std::vector<Rectangle>& components, const Slope& slope,
                    Random* random, House* house) {
  DormerShape shape;
  if (!draw_dormer_shape(slope, random, &shape)) return false;
  const bool low_side = random->chance(0.5);
  const double kind = random->uniform(0.0, 1.0);
  const int wanted = kind < 0.5 ? 1 : (kind < 0.85 ? 2 : 3);
  const double gap = random->uniform(0.8, 2.5);
  const double row = wanted * shape.width + (wanted - 1) * gap;
  const double room = slope.u1 - slope.u0 - row;
  if (room <= 0.6) return false;
  const double first = slope.u0 + random->uniform(0.3, room - 0.3);

  std::vector<Rule> row_rules;
  for (int i = 0; i < wanted; ++i) {
    const double ua = first + i * (shape.width + gap);
    const double ub = ua + shape.width;
    const double back = shape.front + shape.depth;
    const double va = low_side ? slope.v0 + shape.front : slope.v1 - back;
    const Rectangle place = slope.rectangle(ua, ub, va, va + shape.depth);
    if (!clear_of_hips(slope, ua, ub, back)) return false;
    if (!is_clear(place, components, 0.3, component)) return false;
    namespace d = param::dormer;
    Rule dormer = make_rule(RuleKind::kDormer);
    dormer.component = component;
    dormer[d::kCenterX] = place.mid_x();
    dormer[d::kCenterY] = place.mid_y();
    dormer[d::kWidth] = shape.width;
    dormer[d::kDepth] = shape.depth;
    dormer[d::kEaves] = shape.eaves;
    dormer[d::kRise] = shape.rise;
    row_rules.push_back(dormer);
  }
  house->dormers.insert(house->dormers.end(), row_rules.begin(), row_rules.end());
  return true;
}

/// Plan centre of a chimney of the given side: at a gable end, on the ridge, or beside it.
Eigen::Vector2d draw_chimney_place(const Slope& slope, double side, Random* random) {
  const double inset = 0.5 * side + 0.05;
  const double ridge_start = slope.u0 + slope.start_run() + inset;
  const double ridge_end = std::max(ridge_start, slope.u1 - slope.end_run() - inset);
  const double mid = 0.5 * (slope.v0 + slope.v1);
  const double kind = random->uniform(0.0, 1.0);
  if (kind < 0.45) {  // at an end of the ridge: the gable wall where there is one
    const double off = random->chance(0.6) ? 0.0 : random->uniform(-0.3, 0.3) * slope.half_span();
    return slope.point(random->chance(0.5) ? ridge_start : ridge_end, mid + off);
  }
  const double u = random->uniform(ridge_start, ridge_end);
  if (kind < 0.75) return slope.point(u, mid);
  const double off = random->uniform(0.15, 0.4) * slope.half_span();
  return slope.point(u, mid + (random->chance(0.5) ? off : -off));
}

bool contains(const Rectangle& outer, const Rectangle& inner) {
  return inner.x0 >= outer.x0 && inner.x1 <= outer.x1 && inner.y0 >= outer.y0 &&
         inner.y1 <= outer.y1;
}

bool add_chimney(Random* random, House* house) {
  const auto blocks = expand_blocks(*house);
  const int component = random->integer(0, house->num_components() - 1);
  const Slope slope(blocks[component]);
  const double side = random->uniform(0.7, 1.3);
  const double lift = random->uniform(0.8, 2.0);
  const Eigen::Vector2d center = draw_chimney_place(slope, side, random);
  const double half = 0.5 * side;
  const Rectangle place = {center.x() - half, center.x() + half, center.y() - half,
                           center.y() + half};
  if (!contains(rectangle_of(blocks[component]), place)) return false;
  if (!is_clear(place, rectangles_of(*house, BlockRole::kDormer), 0.5)) return false;
  if (!is_clear(place, rectangles_of(*house, BlockRole::kChimney), 2.0)) return false;
  namespace c = param::chimney;
  Rule chimney = make_rule(RuleKind::kChimney);
  chimney[c::kCenterX] = center.x();
  chimney[c::kCenterY] = center.y();
  chimney[c::kSide] = side;
  chimney[c::kHeight] = highest_roof(*house, place) + lift;
  house->chimneys.push_back(chimney);
  return true;
}

}  // namespace

void add_dormers(Random* random, House* house) {
  const auto components = rectangles_of(*house, BlockRole::kComponent);
  const auto blocks = expand_blocks(*house);
  for (int attempt = 0; attempt < 12; ++attempt) {
    const int component = random->integer(0, house->num_components() - 1);
    if (add_dormer_row(component, components, Slope(blocks[component]), random, house)) return;
  }
}

void add_chimneys(Random* random, House* house) {
  const size_t wanted = random->chance(0.68) ? 1 : 2;
  for (int attempt = 0; attempt < 20 && house->chimneys.size() < wanted; ++attempt) {
    add_chimney(random, house);
  }
}

}  // namespace gable
