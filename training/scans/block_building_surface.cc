#include <gable/training/scans/block_building_surface.h>
#include <gable/training/scans/surface_builder.h>
#include <gable/training/scans/surface_shapes.h>
#include <gable/training/scans/wall_openings.h>

#include <algorithm>
#include <cmath>

namespace gable {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using Plan = std::vector<Vector2d>;

constexpr double kContact = 0.03;  // metres
/// Shorter walls are no walls of LOD1 by themselves, metres.
constexpr double kLongWall = 6.5;

/// A rectilinear plan, anticlockwise.
Plan random_plan(Random* random) {
  const double a = random->uniform(16.0, 36.0), b = random->uniform(10.0, 16.0);
  const double c = random->uniform(8.0, 16.0), d = random->uniform(0.3, 0.5) * a;
  switch (random->integer(0, 5)) {
    case 0:
      return {{0, 0}, {a, 0}, {a, b}, {d, b}, {d, b + c}, {0, b + c}};
    case 1: {
      const double wing = std::min(d, 0.36 * a);
      return {{0, 0},        {a, 0},    {a, b + c},    {a - wing, b + c},
              {a - wing, b}, {wing, b}, {wing, b + c}, {0, b + c}};
    }
    case 2: {
      const double left = 0.5 * (a - d);
      return {{0, 0},        {a, 0},    {a, b}, {left + d, b}, {left + d, b + c},
              {left, b + c}, {left, b}, {0, b}};
    }
    case 3: {
      const double shift = random->uniform(0.35, 0.6) * b;
      return {{0, 0},         {d, 0},         {d, shift}, {a, shift},
              {a, b + shift}, {d, b + shift}, {d, b},     {0, b}};
    }
    default:
      return {{0, 0}, {a, 0}, {a, b}, {0, b}};
  }
}

Plan inset(const Plan& plan, double by) {
  Plan out;
  for (size_t i = 0; i < plan.size(); ++i) {
    const Vector2d& before = plan[(i + plan.size() - 1) % plan.size()];
    const Vector2d& after = plan[(i + 1) % plan.size()];
    const Vector2d in = (plan[i] - before).normalized(), on = (after - plan[i]).normalized();
    out.push_back(plan[i] + by * (Vector2d(-in.y(), in.x()) + Vector2d(-on.y(), on.x())));
  }
  return out;
}

SurfaceBuilder::Ring at_height(const Plan& plan, double z) {
  SurfaceBuilder::Ring ring;
  for (const Vector2d& p : plan) ring.push_back({p.x(), p.y(), z});
  return ring;
}

struct Style {
  WindowStyle windows;
  double parapet = 0.6;  // height, metres; 0: none
  double parapet_width = 0.3;
  int balcony_side = -1;  // wall with a column of balconies
  double balcony_depth = 1.1;
};

/// Balconies under the windows of one or two columns of a wall.
void add_balconies(const Style& style, double length, int storeys, Random* random,
                   std::vector<Recess>* openings) {
  const double width = random->uniform(2.2, 3.0);
  const int columns = length > 24.0 ? 2 : 1;
  for (int c = 0; c < columns; ++c) {
    const double middle = length * (columns == 1 ? 0.5 : 0.25 + 0.5 * c);
    const double u0 = middle - 0.5 * width, u1 = middle + 0.5 * width;
    std::erase_if(*openings, [&](const Recess& r) { return r.u1 > u0 - 0.3 && r.u0 < u1 + 0.3; });
    for (int s = 1; s < storeys; ++s) {
      const double floor = s * style.windows.storey;
      openings->push_back({u0, u1, floor - 0.15, floor + 0.95, -style.balcony_depth});
      openings->push_back({u0 + 0.3, u1 - 0.3, floor + 1.0, floor + 2.2, style.windows.depth});
    }
  }
}

class BlockBuilding {
 public:
  explicit BlockBuilding(Random* random) : random_(random), top_(builder_.add_hull()) {
    style_.windows = random_window_style(random->uniform(2.8, 3.4), random);
    // Wider and further apart than those of houses.
    style_.windows.width *= random->uniform(1.2, 2.0);
    style_.windows.spacing = style_.windows.width + random->uniform(1.4, 3.0);
    style_.parapet = random->chance(0.75) ? random->uniform(0.3, 0.8) : 0.0;
    style_.parapet_width = random->uniform(0.2, 0.4);
    if (random->chance(0.4)) style_.balcony_side = 0;
  }

  /// Walls of `storeys` storeys over a plan from height `base`, and the roof with a hole where
  /// `above` stands on it. Walls of the ground are walls of the hull.
  void add_level(const Plan& plan, double base, int storeys, const Plan& above) {
    const double rise = storeys * style_.windows.storey;
    const double top = base + rise;
    for (size_t i = 0; i < plan.size(); ++i) {
      const Vector2d a = plan[i], b = plan[(i + 1) % plan.size()];
      const double length = (b - a).norm();
      const Vector3d along((b - a).x() / length, (b - a).y() / length, 0.0);
      const bool of_hull = base == 0.0 && length > kLongWall;
      const int structure = builder_.add_structure(of_hull ? builder_.add_hull() : kTouching);
      const std::vector<Vector2d> outline = {
          {0.0, 0.0}, {length, 0.0}, {length, rise + style_.parapet}, {0.0, rise + style_.parapet}};
      const std::vector<Vector2d> window_area = {
          {0.0, 0.0}, {length, 0.0}, {length, rise}, {0.0, rise}};
      std::vector<Recess> openings =
          wall_openings(window_area, style_.windows, i == 0 && base == 0.0, random_,
                        [](const Recess&) { return true; });
      if (static_cast<int>(i) == style_.balcony_side && base == 0.0) {
        add_balconies(style_, length, storeys, random_, &openings);
      }
      add_panel(&builder_, structure, {a.x(), a.y(), base}, along, Vector3d::UnitZ(), outline,
                openings);
    }
    const int roof = builder_.add_structure(top_);
    const Plan inner = style_.parapet > 0.0 ? inset(plan, style_.parapet_width) : plan;
    std::vector<SurfaceBuilder::Ring> holes;
    if (!above.empty()) holes.push_back(at_height(above, top));
    builder_.add_face(roof, at_height(inner, top), holes);
    if (style_.parapet > 0.0) {
      SurfaceBuilder::Ring low = at_height(inner, top),
                           high = at_height(inner, top + style_.parapet);
      SurfaceBuilder::Ring rim = at_height(plan, top + style_.parapet);
      for (SurfaceBuilder::Ring* ring : {&low, &high, &rim}) ring->push_back(ring->front());
      for (size_t i = 0; i + 1 < low.size(); ++i) {
        builder_.add_face(kTouching, {low[i + 1], low[i], high[i], high[i + 1]});
        builder_.add_face(kTouching, {rim[i], rim[i + 1], high[i + 1], high[i]});
      }
    }
  }

  /// A housing on a roof of height `base`, and a few small boxes that are details.
  void add_housing(const Vector2d& low, const Vector2d& size, double base) {
    const double rise = random_->uniform(2.2, 3.2);
    std::array<int, 6> sides;
    for (int& side : sides) side = builder_.add_structure(top_);
    add_box(&builder_, {low.x(), low.y(), base},
            {low.x() + size.x(), low.y() + size.y(), base + rise}, sides, {kBottom});
  }

  void add_vent(const Vector2d& at, double base) {
    const double half = random_->uniform(0.25, 0.5), rise = random_->uniform(0.4, 0.9);
    add_box(&builder_, {at.x() - half, at.y() - half, base},
            {at.x() + half, at.y() + half, base + rise}, kTouching, {kBottom});
  }

  double storey() const { return style_.windows.storey; }
  LabelledSurface build() const { return builder_.build(kContact); }

 private:
  Random* random_;
  SurfaceBuilder builder_;
  int top_;
  Style style_;
};

}  // namespace

LabelledSurface random_block_building_surface(Random* random) {
  BlockBuilding building(random);
  const Plan plan = random_plan(random);
  const int storeys = random->integer(3, 7);
  const double top = storeys * building.storey();
  const double margin = random->uniform(1.6, 2.6);
  if (plan.size() == 4 && storeys > 3 && random->chance(0.6)) {
    const Plan above = inset(plan, margin);
    building.add_level(plan, 0.0, storeys, above);
    building.add_level(above, top, 1, {});
    building.add_vent({plan[0].x() + 5.0, plan[0].y() + 5.0}, top + building.storey());
  } else {
    building.add_level(plan, 0.0, storeys, {});
    // The first corner's rectangle is roof in every plan.
    const Vector2d size(random->uniform(2.5, 4.0), random->uniform(2.5, 4.0));
    building.add_housing({random->uniform(1.2, 1.8), random->uniform(1.2, 2.2)}, size, top);
    if (random->chance(0.7)) building.add_vent({1.5, random->uniform(7.0, 8.0)}, top);
  }
  return building.build();
}

}  // namespace gable
