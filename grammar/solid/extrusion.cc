#include <gable/grammar/random.h>
#include <gable/grammar/ring.h>
#include <gable/grammar/solid/extrusion.h>
#include <gable/grammar/solid/part_solids.h>
#include <gable/grammar/solid/validity.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace gable {
namespace {

constexpr int kNumAttempts = 12;
constexpr double kLeastVolume = 1e-3;

std::vector<Ring> finite_rings(const PlanPolygon& polygon) {
  std::vector<Ring> rings = {polygon.outer};
  rings.insert(rings.end(), polygon.holes.begin(), polygon.holes.end());
  for (const Ring& ring : rings) {
    for (const Eigen::Vector2d& p : ring) {
      if (!p.allFinite()) return {};
    }
  }
  return rings;
}

// Drops points nearer than `spacing` to the one before, then moves the others by up to `amplitude`.
Ring moved(const Ring& ring, double spacing, double amplitude, Random* random) {
  Ring result;
  for (const Eigen::Vector2d& p : ring) {
    if (result.empty() || (p - result.back()).norm() > spacing) result.push_back(p);
  }
  while (result.size() > 1 && (result.back() - result.front()).norm() <= spacing) {
    result.pop_back();
  }
  if (amplitude > 0.0) {
    for (Eigen::Vector2d& p : result) {
      p += Eigen::Vector2d(random->uniform(-amplitude, amplitude),
                           random->uniform(-amplitude, amplitude));
    }
  }
  return result;
}

}  // namespace

bool polygon_holds(const PlanPolygon& polygon, const Eigen::Vector2d& point) {
  return ring_holds(polygon.outer, point) != rings_hold(polygon.holes, point);
}

Solid extrude(const PlanPolygon& polygon, double base, double top) {
  const std::vector<Ring> rings = finite_rings(polygon);
  if (rings.empty() || !std::isfinite(base) || !std::isfinite(top) || base >= top) return {};
  const std::vector<Plane> planes = {{0.0, 0.0, base}, {0.0, 0.0, top}};
  for (int attempt = 0; attempt < kNumAttempts; ++attempt) {
    Random random(static_cast<uint64_t>(attempt));
    const double spacing = attempt == 0 ? 0.0 : 0.005 * attempt;
    // Once without moving anything: often the points that lie too near are all that is wrong.
    const double amplitude = attempt < 2 ? 0.0 : 0.004 * attempt;
    std::vector<Ring> moved_rings;
    std::vector<PlanSegment> segments;
    for (const Ring& ring : rings) {
      const Ring r = moved(ring, spacing, amplitude, &random);
      append_ring(r, &segments);
      if (r.size() >= 3) moved_rings.push_back(r);
    }
    const auto label = [&moved_rings](const Eigen::Vector2d& p) {
      return rings_hold(moved_rings, p) ? CellLabel{1, 0} : CellLabel{};
    };
    std::optional<std::vector<Solid>> solids =
        solids_over_plan(segments, label, planes, kLeastVolume);
    if (!solids) continue;
    const auto smaller = [](const Solid& a, const Solid& b) {
      return check_solid(a).volume < check_solid(b).volume;
    };
    const auto largest = std::max_element(solids->begin(), solids->end(), smaller);
    return largest == solids->end() ? Solid{} : std::move(*largest);
  }
  return {};
}

}  // namespace gable
