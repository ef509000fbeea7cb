#include <gable/grammar/block.h>
#include <gable/grammar/wing_polygons.h>

#include <algorithm>
#include <cmath>

namespace gable {
namespace {

// Turns a house frame by quarter turns; the new x axis is the old one turned anticlockwise.
struct QuarterTurns {
  int turns = 0;

  Eigen::Vector2d apply(Eigen::Vector2d p) const {
    for (int i = 0; i < turns; ++i) p = {p.y(), -p.x()};
    return p;
  }

  RoofedRectangle apply(const RoofedRectangle& r) const {
    const Eigen::Vector2d a = apply(Eigen::Vector2d(r.x0, r.y0));
    const Eigen::Vector2d b = apply(Eigen::Vector2d(r.x1, r.y1));
    RoofedRectangle out{std::min(a.x(), b.x()), std::max(a.x(), b.x()), std::min(a.y(), b.y()),
                        std::max(a.y(), b.y()), r.roof};
    const bool along_x = r.roof.ridge == Axis::kX;
    const Eigen::Vector2d ridge =
        apply(along_x ? Eigen::Vector2d(1.0, 0.0) : Eigen::Vector2d(0.0, 1.0));
    if (turns % 2 == 1) out.roof.ridge = along_x ? Axis::kY : Axis::kX;
    // A reversed axis swaps the ends of the ridge.
    if (r.roof.kind == RuleKind::kRoofHip && ridge.x() + ridge.y() < 0.0) {
      std::swap(out.roof[param::roof::kHipStart], out.roof[param::roof::kHipEnd]);
    }
    return out;
  }
};

}  // namespace

House l_house(const RoofedRectangle& along_x, const RoofedRectangle& along_y, const Side& corner,
              double azimuth) {
  QuarterTurns turn;
  while (turn.apply(corner) != Side(-1.0, -1.0)) ++turn.turns;
  const bool swapped = turn.turns % 2 == 1;
  const RoofedRectangle x = turn.apply(swapped ? along_y : along_x);
  const RoofedRectangle y = turn.apply(swapped ? along_x : along_y);
  House house;
  house.foundation = Foundation::kL;
  house.azimuth[0] = azimuth + turn.turns * 0.5 * M_PI;
  Rule footprint = make_rule(RuleKind::kFootprintL);
  const double corner_x = 0.5 * (x.x0 + y.x0), corner_y = 0.5 * (x.y0 + y.y0);
  footprint.values = {corner_x,        corner_y,        x.x1 - corner_x,
                      x.y1 - corner_y, y.y1 - corner_y, y.x1 - corner_x};
  house.footprints = {footprint};
  house.roofs = {x.roof, y.roof};
  return house;
}

House u_house(const RoofedRectangle& base, const RoofedRectangle& wing_a,
              const RoofedRectangle& wing_b, const Side& open, double azimuth) {
  QuarterTurns turn;
  while (turn.apply(open) != Side(0.0, 1.0)) ++turn.turns;
  const RoofedRectangle b = turn.apply(base);
  RoofedRectangle left = turn.apply(wing_a), right = turn.apply(wing_b);
  if (left.x0 > right.x0) std::swap(left, right);
  House house;
  house.foundation = Foundation::kU;
  house.azimuth[0] = azimuth + turn.turns * 0.5 * M_PI;
  Rule footprint = make_rule(RuleKind::kFootprintU);
  const double corner_x = 0.5 * (b.x0 + left.x0), end_x = 0.5 * (b.x1 + right.x1);
  footprint.values = {corner_x,         b.y0,
                      end_x - corner_x, b.y1 - b.y0,
                      left.y1 - b.y0,   left.x1 - corner_x,
                      right.y1 - b.y0,  end_x - right.x0};
  house.footprints = {footprint};
  house.roofs = {b.roof, left.roof, right.roof};
  return house;
}

House blocks_house(const std::vector<RoofedRectangle>& blocks, double azimuth) {
  House house;
  house.foundation = blocks.size() == 1   ? Foundation::kI
                     : blocks.size() == 2 ? Foundation::kII
                     : blocks.size() == 3 ? Foundation::kIII
                                          : Foundation::kMany;
  house.azimuth[0] = azimuth;
  for (const RoofedRectangle& r : blocks) {
    Rule footprint = make_rule(RuleKind::kFootprintI);
    footprint.values = {0.5 * (r.x0 + r.x1), 0.5 * (r.y0 + r.y1), r.x1 - r.x0, r.y1 - r.y0};
    house.footprints.push_back(footprint);
    house.roofs.push_back(r.roof);
  }
  return house;
}

std::vector<RoofedRectangle> roofed_rectangles(const House& house) {
  using namespace block_value;
  const std::vector<Block<double>> blocks = expand_blocks(house);
  std::vector<RoofedRectangle> out;
  for (int i = 0; i < house.num_components(); ++i) {
    const Block<double>& b = blocks[i];
    out.push_back({b[kX0], b[kX1], b[kY0], b[kY1], house.roofs[i]});
  }
  return out;
}

}  // namespace gable
