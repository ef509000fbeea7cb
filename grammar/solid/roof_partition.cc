#include <gable/grammar/ring.h>
#include <gable/grammar/solid/part_solids.h>
#include <gable/grammar/solid/roof_partition.h>

#include <limits>
#include <utility>

namespace gable {
namespace {

constexpr double kLeastVolume = 1e-3;
constexpr double kLeastHeight = 1e-3;

bool stands_above(const RoofPartition& partition, double base) {
  for (const RoofRegion& region : partition.regions) {
    for (const Eigen::Vector2d& p : region.polygon.outer) {
      if (!(partition.planes[region.plane].at(p) >= base + kLeastHeight)) return false;
    }
  }
  return true;
}

}  // namespace

std::optional<RoofPartition> partition_plan(
    const std::vector<PlanSegment>& segments, const std::vector<Plane>& planes,
    const std::function<int(const Eigen::Vector2d&)>& plane_of) {
  const auto label = [&plane_of](const Eigen::Vector2d& p) {
    const int plane = plane_of(p);
    return plane < 0 ? CellLabel{} : CellLabel{plane, plane};
  };
  const std::optional<PlanGraph> graph = divide_plan(segments, label, planes);
  if (!graph) return std::nullopt;
  std::vector<int> number(planes.size(), -1);
  for (const PlanCell& cell : graph->cells) number[cell.label.upper] = 0;
  RoofPartition partition;
  for (size_t i = 0; i < planes.size(); ++i) {
    if (number[i] < 0) continue;
    number[i] = static_cast<int>(partition.planes.size());
    partition.planes.push_back(planes[i]);
  }
  for (const PlanCell& cell : graph->cells) {
    RoofRegion region{number[cell.label.upper], {}};
    for (size_t r = 0; r < cell.rings.size(); ++r) {
      Ring ring;
      for (const int v : cell.rings[r]) ring.push_back(graph->vertices[v]);
      if (r == 0) {
        region.polygon.outer = std::move(ring);
      } else {
        region.polygon.holes.push_back(std::move(ring));
      }
    }
    partition.regions.push_back(std::move(region));
  }
  return partition;
}

std::optional<std::vector<Solid>> solids_of_partition(const RoofPartition& partition, double base) {
  if (partition.regions.empty() || !stands_above(partition, base)) return std::nullopt;
  std::vector<Plane> planes = {{0.0, 0.0, base}};
  planes.insert(planes.end(), partition.planes.begin(), partition.planes.end());
  std::vector<PlanSegment> segments;
  for (const RoofRegion& region : partition.regions) {
    append_ring(region.polygon.outer, &segments);
    append_rings(region.polygon.holes, &segments);
  }
  const auto label = [&partition](const Eigen::Vector2d& p) {
    const int region = region_at(partition, p);
    return region < 0 ? CellLabel{} : CellLabel{partition.regions[region].plane + 1, 0};
  };
  return solids_over_plan(segments, label, planes, kLeastVolume);
}

int region_at(const RoofPartition& partition, const Eigen::Vector2d& p) {
  for (size_t i = 0; i < partition.regions.size(); ++i) {
    if (polygon_holds(partition.regions[i].polygon, p)) return static_cast<int>(i);
  }
  return -1;
}

double roof_height(const RoofPartition& partition, const Eigen::Vector2d& p) {
  const int region = region_at(partition, p);
  if (region < 0) return std::numeric_limits<double>::quiet_NaN();
  return partition.planes[partition.regions[region].plane].at(p);
}

}  // namespace gable
