#include <gable/training/scans/furniture.h>
#include <gable/training/scans/surface_shapes.h>

#include <algorithm>

namespace gable {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

int hull_of(SurfaceBuilder* builder, bool large) { return large ? builder->add_hull() : kTouching; }

/// Small things that stand on a top at height z: books, cups, a screen with its foot.
void add_things(SurfaceBuilder* builder, double width, double depth, double z, Random* random) {
  const int count = random->integer(0, 3);
  for (int i = 0; i < count; ++i) {
    const Vector3d size(random->uniform(0.1, 0.25), random->uniform(0.08, 0.2),
                        random->uniform(0.03, 0.12));
    const double slot = width / std::max(count, 1);
    if (slot < size.x() + 0.05 || depth < size.y() + 0.1) continue;
    const Vector3d low(i * slot + 0.02, random->uniform(0.05, depth - size.y() - 0.02), z);
    add_box(builder, low, low + size, kTouching, {kBottom});
  }
}

}  // namespace

void add_table(SurfaceBuilder* builder, const Vector3d& size, bool large, Random* random) {
  const double thickness = random->uniform(0.025, 0.045), leg = random->uniform(0.04, 0.07);
  const int top = builder->add_structure(hull_of(builder, large));
  add_box(builder, {0.0, 0.0, size.z() - thickness}, size, top);
  for (double x : {0.02, size.x() - 0.02 - leg}) {
    for (double y : {0.02, size.y() - 0.02 - leg}) {
      add_box(builder, {x, y, 0.0}, {x + leg, y + leg, size.z() - thickness}, kTouching,
              {kTop, kBottom});
    }
  }
  if (random->chance(0.6)) {  // a drawer unit or apron under the front
    const double depth = 0.03;
    add_box(builder, {leg + 0.03, 0.03, size.z() - thickness - 0.1},
            {size.x() - leg - 0.03, 0.03 + depth, size.z() - thickness}, kTouching, {kTop});
  }
  add_things(builder, size.x(), size.y(), size.z(), random);
}

void add_desk(SurfaceBuilder* builder, const Vector3d& size, bool large, Random* random) {
  const double thickness = random->uniform(0.025, 0.04), leg = random->uniform(0.04, 0.06);
  const int top = builder->add_structure(hull_of(builder, large));
  add_box(builder, {0.0, 0.0, size.z() - thickness}, size, top);
  // Legs at one end, drawers at the other.
  for (double y : {0.02, size.y() - 0.02 - leg}) {
    add_box(builder, {0.02, y, 0.0}, {0.02 + leg, y + leg, size.z() - thickness}, kTouching,
            {kTop, kBottom});
  }
  const double x0 = size.x() - 0.45, x1 = size.x() - 0.03, y0 = 0.05, high = size.z() - thickness;
  std::array<int, 6> sides;
  for (int& side : sides) side = builder->add_structure();
  add_box(builder, {x0, y0, 0.0}, {x1, size.y() - 0.05, high}, sides, {kFront, kTop, kBottom});
  const int drawers = random->integer(2, 4);
  std::vector<Recess> fronts;
  for (int i = 0; i < drawers; ++i) {
    fronts.push_back(
        {0.02, x1 - x0 - 0.02, high * i / drawers + 0.02, high * (i + 1) / drawers - 0.02, -0.015});
  }
  add_panel(builder, sides[kFront], {x0, y0, 0.0}, Vector3d::UnitX(), Vector3d::UnitZ(),
            {{0.0, 0.0}, {x1 - x0, 0.0}, {x1 - x0, high}, {0.0, high}}, fronts);
  // The screen on its foot.
  const double wide = random->uniform(0.4, 0.6), middle = 0.4 * size.x(), y = size.y() - 0.18;
  add_box(builder, {middle - 0.1, y - 0.06, size.z()}, {middle + 0.1, y + 0.08, size.z() + 0.02},
          kTouching, {kBottom});
  add_box(builder, {middle - 0.03, y + 0.005, size.z() + 0.02},
          {middle + 0.03, y + 0.035, size.z() + 0.12}, kTouching, {kBottom, kTop});
  add_box(builder, {middle - 0.5 * wide, y, size.z() + 0.12},
          {middle + 0.5 * wide, y + 0.04, size.z() + 0.12 + 0.6 * wide}, kTouching);
}

void add_chair(SurfaceBuilder* builder, const Vector3d& size, Random* random) {
  const double seat = random->uniform(0.42, 0.47), thickness = 0.03, leg = 0.035;
  add_box(builder, {0.0, 0.0, seat - thickness}, {size.x(), size.y(), seat},
          builder->add_structure());
  add_box(builder, {0.0, size.y() - thickness, seat + 0.08}, {size.x(), size.y(), size.z()},
          builder->add_structure());
  for (double x : {0.0, size.x() - leg}) {
    for (double y : {0.0, size.y() - leg}) {
      add_box(builder, {x, y, 0.0}, {x + leg, y + leg, seat - thickness}, kTouching,
              {kTop, kBottom});
    }
    add_box(builder, {x, size.y() - leg, seat}, {x + leg, size.y() - 0.002, seat + 0.08}, kTouching,
            {kTop, kBottom});
  }
}

void add_cupboard(SurfaceBuilder* builder, const Vector3d& size, bool large, Random* random) {
  const int hull = hull_of(builder, large);
  const int front = builder->add_structure(hull);
  std::array<int, 6> sides;
  for (int& side : sides) side = builder->add_structure(hull);
  add_box(builder, Vector3d::Zero(), size, sides, {kFront, kBack, kBottom});
  // Doors or drawers stand out of the front a little, each with a handle.
  const bool drawers = size.z() < 1.3 && random->chance(0.6);
  const int columns = std::max(1, static_cast<int>(size.x() / 0.55));
  const int rows = drawers ? random->integer(2, 4) : 1;
  const double gap = 0.02, out = -0.018;
  std::vector<Recess> recesses;
  for (int c = 0; c < columns; ++c) {
    for (int r = 0; r < rows; ++r) {
      const double u0 = size.x() * c / columns + gap, u1 = size.x() * (c + 1) / columns - gap;
      const double v0 = 0.06 + (size.z() - 0.06) * r / rows + gap;
      const double v1 = 0.06 + (size.z() - 0.06) * (r + 1) / rows - gap;
      recesses.push_back({u0, u1, v0, v1, out});
      const double u = drawers ? 0.5 * (u0 + u1) - 0.06 : (c % 2 ? u0 + 0.04 : u1 - 0.07);
      const double v = 0.5 * (v0 + v1);
      const Vector3d high = drawers ? Vector3d(0.12, 0.0, 0.02) : Vector3d(0.025, 0.0, 0.14);
      const Vector3d low(u, out - 0.03, v);
      add_box(builder, low, Vector3d(u, out, v) + high, front, {kBack});
    }
  }
  add_panel(builder, front, Vector3d::Zero(), Vector3d::UnitX(), Vector3d::UnitZ(),
            {{0.0, 0.0}, {size.x(), 0.0}, {size.x(), size.z()}, {0.0, size.z()}}, recesses);
  if (size.z() < 1.4) add_things(builder, size.x(), size.y(), size.z(), random);
}

void add_bed(SurfaceBuilder* builder, const Vector3d& size, bool large, Random* random) {
  const int hull = hull_of(builder, large);
  std::array<int, 6> sides;
  for (int& side : sides) side = builder->add_structure(hull);
  const double base = 0.6 * size.z(), head = size.z() + random->uniform(0.3, 0.5);
  add_box(builder, Vector3d::Zero(), {size.x(), size.y(), base}, sides, {kBack, kBottom});
  add_box(builder, {0.03, 0.03, base}, {size.x() - 0.03, size.y() - 0.05, size.z()}, sides,
          {kBottom, kBack});
  const int board = builder->add_structure(hull);
  add_box(builder, {0.0, size.y() - 0.05, base}, {size.x(), size.y(), head}, board, {kBottom});
  const int pillows = size.x() > 1.2 ? 2 : 1;
  for (int i = 0; i < pillows; ++i) {
    const double x = size.x() * (i + 0.5) / pillows;
    add_box(builder, {x - 0.28, size.y() - 0.5, size.z()},
            {x + 0.28, size.y() - 0.1, size.z() + random->uniform(0.07, 0.11)}, kTouching,
            {kBottom});
  }
}

void add_bookshelf(SurfaceBuilder* builder, const Vector3d& size, bool large, Random* random) {
  const int hull = hull_of(builder, large);
  const int front = builder->add_structure(hull);
  std::array<int, 6> sides;
  for (int& side : sides) side = builder->add_structure(hull);
  add_box(builder, Vector3d::Zero(), size, sides, {kFront, kBack, kBottom});
  const int rows = std::max(1, static_cast<int>(size.z() / 0.38));
  const int columns = std::max(1, static_cast<int>(size.x() / 0.8));
  std::vector<Recess> bays;
  for (int r = 0; r < rows; ++r) {
    for (int c = 0; c < columns; ++c) {
      const double u0 = size.x() * c / columns + 0.02, u1 = size.x() * (c + 1) / columns - 0.02;
      const double v0 = size.z() * r / rows + 0.02, v1 = size.z() * (r + 1) / rows - 0.02;
      // Filled with books of one depth to some point, empty beyond it.
      const double filled = u0 + (u1 - u0) * random->uniform(0.3, 0.85);
      bays.push_back({u0, filled, v0, v1 - 0.05, random->uniform(0.02, 0.05)});
      bays.push_back({filled + 0.005, u1, v0, v1, std::min(0.8 * size.y(), 0.2)});
    }
  }
  add_panel(builder, front, Vector3d::Zero(), Vector3d::UnitX(), Vector3d::UnitZ(),
            {{0.0, 0.0}, {size.x(), 0.0}, {size.x(), size.z()}, {0.0, size.z()}}, bays);
}

void add_couch(SurfaceBuilder* builder, const Vector3d& size, bool large, Random* random) {
  const int hull = hull_of(builder, large);
  const double arm = random->uniform(0.15, 0.22), back = 0.2, seat = random->uniform(0.4, 0.45);
  std::array<int, 6> seat_sides, back_sides;
  for (int& side : seat_sides) side = builder->add_structure(hull);
  for (int& side : back_sides) side = builder->add_structure(hull);
  const int cushions = std::max(1, static_cast<int>((size.x() - 2 * arm) / 0.6));
  const double wide = (size.x() - 2 * arm) / cushions;
  add_box(builder, {arm, 0.02, 0.0}, {size.x() - arm, size.y() - back, seat - 0.14}, seat_sides,
          {kBottom, kTop, kLeft, kRight, kBack});
  for (int i = 0; i < cushions; ++i) {
    add_box(builder, {arm + i * wide + 0.006, 0.0, seat - 0.14},
            {arm + (i + 1) * wide - 0.006, size.y() - back, seat}, seat_sides, {kBottom, kBack});
  }
  add_box(builder, {arm, size.y() - back, seat}, {size.x() - arm, size.y(), size.z()}, back_sides,
          {kBottom, kLeft, kRight, kBack});
  for (double x : {0.0, size.x() - arm}) {
    std::array<int, 6> sides;
    for (int& side : sides) side = builder->add_structure(hull);
    add_box(builder, {x, 0.0, 0.0}, {x + arm, size.y(), seat + 0.18}, sides, {kBottom, kBack});
  }
}

}  // namespace gable
