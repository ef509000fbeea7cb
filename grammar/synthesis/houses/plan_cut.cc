#include <gable/grammar/synthesis/houses/plan_cut.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace gable {
namespace {

constexpr double kDegree = M_PI / 180.0;

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

}  // namespace

std::vector<Eigen::Vector2d> left_of_line(const std::vector<Eigen::Vector2d>& ring,
                                          const Eigen::Vector2d& point,
                                          const Eigen::Vector2d& direction) {
  std::vector<Eigen::Vector2d> kept;
  for (size_t i = 0; i < ring.size(); ++i) {
    const Eigen::Vector2d& a = ring[i];
    const Eigen::Vector2d& b = ring[(i + 1) % ring.size()];
    const double side_a = cross(direction, a - point), side_b = cross(direction, b - point);
    if (side_a >= 0.0) kept.push_back(a);
    if ((side_a > 0.0 && side_b < 0.0) || (side_a < 0.0 && side_b > 0.0)) {
      kept.push_back(a + side_a / (side_a - side_b) * (b - a));
    }
  }
  return kept;
}

bool inside_ring(const std::vector<Eigen::Vector2d>& ring, const Eigen::Vector2d& point) {
  bool inside = false;
  for (size_t i = 0; i < ring.size(); ++i) {
    const Eigen::Vector2d& a = ring[i];
    const Eigen::Vector2d& b = ring[(i + 1) % ring.size()];
    if ((a.y() > point.y()) == (b.y() > point.y())) continue;
    inside ^= point.x() < a.x() + (point.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x());
  }
  return inside;
}

PlanPolygon cut_obliquely(const PlanPolygon& outline, const Eigen::Vector2d& along, double angle,
                          bool left) {
  double farthest = -std::numeric_limits<double>::infinity();
  for (const Eigen::Vector2d& p : outline.outer) farthest = std::max(farthest, along.dot(p));
  // The extremes of the end's own corners: what lies further back may be wider.
  const Eigen::Vector2d across(-along.y(), along.x());
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const Eigen::Vector2d& p : outline.outer) {
    if (along.dot(p) < farthest - 1e-3) continue;
    low = std::min(low, across.dot(p));
    high = std::max(high, across.dot(p));
  }
  const Eigen::Vector2d corner = farthest * along + (left ? high : low) * across;
  // The body lies towards -along, on the left of a line that runs along `across`.
  const double turn = left ? -angle : angle;
  const Eigen::Vector2d line = std::cos(turn) * across - std::sin(turn) * along;
  return {left_of_line(outline.outer, corner, line), {}};
}

PlanPolygon register_outline(const PlanPolygon& outline, double most, Random* random) {
  Eigen::Vector2d middle = Eigen::Vector2d::Zero();
  for (const auto& p : outline.outer) middle += p / static_cast<double>(outline.outer.size());
  const double angle = random->uniform(-1.0, 1.0) * kDegree;
  const auto off = [&] { return std::clamp(0.3 * most * random->normal(1.0), -most, most); };
  const double dx = off(), dy = off();
  const Eigen::Vector2d by(dx, dy);
  Eigen::Matrix2d turn;
  turn << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle);
  PlanPolygon moved = outline;
  const auto move = [&](std::vector<Eigen::Vector2d>* ring) {
    for (auto& p : *ring) p = middle + turn * (p - middle) + by;
  };
  move(&moved.outer);
  for (auto& hole : moved.holes) move(&hole);
  return moved;
}

}  // namespace gable
