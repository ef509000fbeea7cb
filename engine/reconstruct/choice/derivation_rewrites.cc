#include <gable/engine/reconstruct/choice/derivation_rewrites.h>
#include <gable/grammar/wing_polygons.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace gable {
namespace {

double extent_x(const RoofedRectangle& r) { return r.x1 - r.x0; }
double extent_y(const RoofedRectangle& r) { return r.y1 - r.y0; }

RoofedRectangle transposed(RoofedRectangle r) {
  std::swap(r.x0, r.y0);
  std::swap(r.x1, r.y1);
  r.roof.ridge = r.roof.ridge == Axis::kX ? Axis::kY : Axis::kX;
  return r;
}

// A wing along y on a base along x: at which end of the base it stands and to which side it goes;
// `wing` is extended to the base's outer side. Empty sides where they form no L.
struct Attachment {
  int end = 0;   // -1: low x, +1: high x
  int side = 0;  // -1: goes to low y, +1: to high y
  RoofedRectangle wing;
};

Attachment attach(const RoofedRectangle& base, const RoofedRectangle& wing, double near) {
  Attachment out;
  const double low = std::abs(base.x0 - wing.x0), high = std::abs(base.x1 - wing.x1);
  if (std::min(low, high) > near || extent_x(wing) > extent_x(base) - near) return out;
  const bool up = wing.y1 > base.y1 + near;
  const bool down = wing.y0 < base.y0 - near;
  if (up == down) return out;
  // The wing must reach the base, and not end beyond its outer side.
  if (up && (wing.y0 > base.y1 + near || wing.y0 < base.y0 - near)) return out;
  if (down && (wing.y1 < base.y0 - near || wing.y1 > base.y1 + near)) return out;
  out.end = low <= high ? -1 : 1;
  out.side = up ? 1 : -1;
  out.wing = wing;
  Rule& roof = out.wing.roof;
  const double before = extent_y(wing);
  (up ? out.wing.y0 : out.wing.y1) = up ? base.y0 : base.y1;
  const double after = extent_y(out.wing);
  if (roof.kind == RuleKind::kRoofHip && roof.ridge == Axis::kY && after > 1.05 * before) {
    // The free end keeps its run; the end at the corner meets the base's roof at equal pitch.
    const int free_end = up ? param::roof::kHipEnd : param::roof::kHipStart;
    const int corner_end = up ? param::roof::kHipStart : param::roof::kHipEnd;
    roof[free_end] = std::clamp(roof[free_end] * before / after, 0.02, 0.5);
    roof[corner_end] = std::clamp(0.5 * extent_x(wing) / after, 0.02, 0.5);
  }
  return out;
}

// Ls and Us may be hipped where blocks were simplified to gables: an L's corner is a matter of
// hips.
RoofedRectangle as_hip(RoofedRectangle r) {
  if (r.roof.kind == RuleKind::kRoofGable) {
    r.roof.kind = RuleKind::kRoofHip;
    r.roof[param::roof::kHipStart] = r.roof[param::roof::kHipEnd] = 0.05;
  }
  return r;
}

void carry_details(const House& from, House* to) {
  to->origin = from.origin;
  // The frame may have been turned by quarter turns; details turn with it.
  const double turn = to->azimuth[0] - from.azimuth[0];
  const int turns = static_cast<int>(std::lround(turn / (0.5 * M_PI)));
  const auto turned = [&](Rule rule) {
    for (int i = 0; i < turns; ++i) {
      const double x = rule[0];
      rule[0] = rule[1];
      rule[1] = -x;
    }
    return rule;
  };
  for (const Rule& r : from.chimneys) to->chimneys.push_back(turned(r));
  for (Rule r : from.dormers) to->dormers.push_back(turned(r));
  for (Rule r : from.garages) {
    // An L garage's corner does not turn with the frame.
    if (r.kind != RuleKind::kGarageI && turns != 0) continue;
    r = turned(r);
    if (turns % 2 == 1) {
      std::swap(r[param::rectangle::kLength], r[param::rectangle::kWidth]);
    }
    to->garages.push_back(r);
  }
}

void add(const House& from, House house, std::vector<House>* out) {
  carry_details(from, &house);
  reassign_dormers(&house);
  out->push_back(std::move(house));
}

void add_l(const House& house, const std::vector<RoofedRectangle>& blocks, double near,
           std::vector<House>* out) {
  for (int base = 0; base < 2; ++base) {
    const RoofedRectangle x = as_hip(blocks[base]), y = as_hip(blocks[1 - base]);
    const Attachment a = attach(x, y, near);
    if (a.end != 0) {
      add(house, l_house(x, a.wing, Side(a.end, -a.side), house.azimuth[0]), out);
    }
    // The same seen from a base along y.
    const Attachment b = attach(transposed(x), transposed(y), near);
    if (b.end != 0) {
      add(house, l_house(transposed(b.wing), x, Side(-b.side, b.end), house.azimuth[0]), out);
    }
  }
}

void add_u(const House& house, const std::vector<RoofedRectangle>& blocks, double near,
           std::vector<House>* out) {
  for (int base = 0; base < 3; ++base) {
    const RoofedRectangle r = as_hip(blocks[base]);
    const RoofedRectangle p = as_hip(blocks[(base + 1) % 3]), q = as_hip(blocks[(base + 2) % 3]);
    const Attachment a = attach(r, p, near), b = attach(r, q, near);
    if (a.end != 0 && b.end == -a.end && a.side == b.side) {
      add(house, u_house(r, a.wing, b.wing, Side(0.0, a.side), house.azimuth[0]), out);
    }
    const Attachment c = attach(transposed(r), transposed(p), near);
    const Attachment d = attach(transposed(r), transposed(q), near);
    if (c.end != 0 && d.end == -c.end && c.side == d.side) {
      add(house,
          u_house(r, transposed(c.wing), transposed(d.wing), Side(c.side, 0.0), house.azimuth[0]),
          out);
    }
  }
}

// The part of `r` outside `main` where it sticks out to one side; `r` itself where it does not
// overlap it.
RoofedRectangle outside_of(RoofedRectangle r, const RoofedRectangle& main) {
  if (r.x1 <= main.x0 || r.x0 >= main.x1 || r.y1 <= main.y0 || r.y0 >= main.y1) return r;
  const std::array<double, 4> out = {main.x0 - r.x0, r.x1 - main.x1, main.y0 - r.y0,
                                     r.y1 - main.y1};
  switch (std::max_element(out.begin(), out.end()) - out.begin()) {
    case 0:
      r.x1 = main.x0;
      break;
    case 1:
      r.x0 = main.x1;
      break;
    case 2:
      r.y1 = main.y0;
      break;
    default:
      r.y0 = main.y1;
  }
  return r;
}

void add_garage(const House& house, const std::vector<RoofedRectangle>& blocks,
                const RewriteOptions& options, std::vector<House>* out) {
  int low = -1;
  for (size_t i = 0; i < blocks.size(); ++i) {
    const Rule& roof = blocks[i].roof;
    if (roof.kind != RuleKind::kRoofFlat || roof[param::roof::kEaves] > options.garage_height)
      continue;
    if (low < 0 || roof[0] < blocks[low].roof[0]) low = static_cast<int>(i);
  }
  if (low < 0 || blocks.size() < 2) return;
  std::vector<RoofedRectangle> rest;
  RoofedRectangle garage = blocks[low];
  for (size_t i = 0; i < blocks.size(); ++i) {
    if (static_cast<int>(i) == low) continue;
    rest.push_back(blocks[i]);
    garage = outside_of(garage, blocks[i]);
  }
  House with = blocks_house(rest, house.azimuth[0]);
  carry_details(house, &with);
  reassign_dormers(&with);
  Rule rule = make_rule(RuleKind::kGarageI);
  rule.values = {0.5 * (garage.x0 + garage.x1), 0.5 * (garage.y0 + garage.y1),
                 std::max(extent_x(garage), 1.0), std::max(extent_y(garage), 1.0),
                 garage.roof[param::roof::kEaves]};
  with.garages.push_back(rule);
  out->push_back(with);
  // The rest of an L or U may be one polygon still.
  if (rest.size() == 2) add_l(with, rest, options.alignment, out);
}

}  // namespace

void reassign_dormers(House* house) {
  const std::vector<RoofedRectangle> rectangles = roofed_rectangles(*house);
  std::vector<Rule> kept;
  for (Rule dormer : house->dormers) {
    dormer.component = -1;
    double top = 0.0;
    for (size_t i = 0; i < rectangles.size(); ++i) {
      const RoofedRectangle& r = rectangles[i];
      const double height =
          r.roof[param::roof::kEaves] + (r.roof.size() > 1 ? r.roof[param::roof::kRise] : 0.0);
      if (dormer[0] < r.x0 || dormer[0] > r.x1 || dormer[1] < r.y0 || dormer[1] > r.y1) continue;
      if (dormer.component < 0 || height > top) {
        dormer.component = static_cast<int>(i);
        top = height;
      }
    }
    if (dormer.component >= 0) kept.push_back(dormer);
  }
  house->dormers = kept;
}

std::vector<House> rewrites(const House& house, const RewriteOptions& options) {
  const std::vector<RoofedRectangle> blocks = roofed_rectangles(house);
  std::vector<House> out;
  if (house.foundation == Foundation::kII) add_l(house, blocks, options.alignment, &out);
  if (house.foundation == Foundation::kIII) add_u(house, blocks, options.alignment, &out);
  add_garage(house, blocks, options, &out);
  return out;
}

}  // namespace gable
