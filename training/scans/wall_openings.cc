#include <gable/training/scans/wall_openings.h>

#include <algorithm>
#include <cmath>

namespace gable {
namespace {

using Eigen::Vector2d;

constexpr double kMargin = 0.25;  // of wall around an opening, metres

bool inside(const std::vector<Vector2d>& polygon, const Vector2d& p) {
  bool in = false;
  for (size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
    const Vector2d &a = polygon[i], &b = polygon[j];
    if ((a.y() > p.y()) != (b.y() > p.y()) &&
        p.x() < (b.x() - a.x()) * (p.y() - a.y()) / (b.y() - a.y()) + a.x()) {
      in = !in;
    }
  }
  return in;
}

/// Whether a rectangle with its margin lies inside, probed on a lattice finer than any feature of
/// a wall.
bool fits(const std::vector<Vector2d>& outline, const Recess& r) {
  constexpr int kSteps = 6;
  const double low = std::max(r.v0 - kMargin, 0.02);
  for (int i = 0; i <= kSteps; ++i) {
    for (int j = 0; j <= kSteps; ++j) {
      const double u = r.u0 - kMargin + i * (r.u1 - r.u0 + 2 * kMargin) / kSteps;
      const double v = low + j * (r.v1 + kMargin - low) / kSteps;
      if (!inside(outline, {u, v})) return false;
    }
  }
  return true;
}

}  // namespace

WindowStyle random_window_style(double storey, Random* random) {
  WindowStyle style;
  style.storey = storey;
  style.width = random->uniform(0.8, 1.5);
  style.height = random->uniform(1.0, 1.45);
  style.sill = random->uniform(0.75, 1.0);
  style.spacing = style.width + random->uniform(0.9, 1.8);
  style.depth = random->uniform(0.10, 0.20);
  style.door_width = random->uniform(0.9, 1.2);
  style.door_height = random->uniform(2.0, 2.2);
  return style;
}

std::vector<Recess> wall_openings(const std::vector<Vector2d>& outline, const WindowStyle& style,
                                  bool with_door, Random* random,
                                  const std::function<bool(const Recess&)>& is_free) {
  double u0 = outline[0].x(), u1 = u0, top = outline[0].y();
  for (const Vector2d& p : outline) {
    u0 = std::min(u0, p.x());
    u1 = std::max(u1, p.x());
    top = std::max(top, p.y());
  }
  const int columns = static_cast<int>((u1 - u0 - 2 * kMargin) / style.spacing);
  const int storeys = static_cast<int>(std::ceil(top / style.storey));
  std::vector<Recess> out;
  for (int s = 0; s < storeys; ++s) {
    for (int c = 0; c < columns; ++c) {
      const double middle = 0.5 * (u0 + u1) + (c - 0.5 * (columns - 1)) * style.spacing;
      const double floor = s * style.storey;
      const bool door = with_door && s == 0 && c == columns / 2;
      const bool skipped = !door && random->chance(0.08);
      Recess r = {middle - 0.5 * style.width, middle + 0.5 * style.width, floor + style.sill,
                  floor + style.sill + style.height, style.depth};
      if (door) {
        r = {middle - 0.5 * style.door_width, middle + 0.5 * style.door_width, 0.04,
             style.door_height, style.depth};
      }
      if (!skipped && fits(outline, r) && is_free(r)) out.push_back(r);
    }
  }
  return out;
}

}  // namespace gable
