#pragma once

#include <gable/grammar/block.h>

#include <algorithm>
#include <cmath>

namespace gable {

/// An axis-aligned rectangle of the house frame, metres.
struct Rectangle {
  double x0 = 0.0, x1 = 0.0, y0 = 0.0, y1 = 0.0;

  double size_x() const { return x1 - x0; }
  double size_y() const { return y1 - y0; }
  double area() const { return size_x() * size_y(); }
  double mid_x() const { return 0.5 * (x0 + x1); }
  double mid_y() const { return 0.5 * (y0 + y1); }
  Rectangle shifted(double dx, double dy) const { return {x0 + dx, x1 + dx, y0 + dy, y1 + dy}; }
  Rectangle grown(double margin) const {
    return {x0 - margin, x1 + margin, y0 - margin, y1 + margin};
  }
};

inline Rectangle rectangle_of(const Block<double>& block) {
  using namespace block_value;
  return {block[kX0], block[kX1], block[kY0], block[kY1]};
}

/// Area that two rectangles share.
inline double shared_area(const Rectangle& a, const Rectangle& b) {
  const double dx = std::min(a.x1, b.x1) - std::max(a.x0, b.x0);
  const double dy = std::min(a.y1, b.y1) - std::max(a.y0, b.y0);
  return dx > 0.0 && dy > 0.0 ? dx * dy : 0.0;
}

/// Distance between two rectangles, 0 where they touch or overlap.
inline double distance(const Rectangle& a, const Rectangle& b) {
  const double dx = std::max({0.0, a.x0 - b.x1, b.x0 - a.x1});
  const double dy = std::max({0.0, a.y0 - b.y1, b.y0 - a.y1});
  return std::hypot(dx, dy);
}

/// The smallest rectangle around both.
inline Rectangle bounds(const Rectangle& a, const Rectangle& b) {
  return {std::min(a.x0, b.x0), std::max(a.x1, b.x1), std::min(a.y0, b.y0), std::max(a.y1, b.y1)};
}

}  // namespace gable
