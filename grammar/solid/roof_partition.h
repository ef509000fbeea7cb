#pragma once

#include <gable/grammar/solid/extrusion.h>
#include <gable/grammar/solid/plan_graph.h>
#include <gable/grammar/solid/plane.h>
#include <gable/grammar/solid/solid.h>

#include <Eigen/Core>
#include <optional>
#include <vector>

namespace gable {

/// A region of the plan that one plane covers.
struct RoofRegion {
  int plane = 0;  ///< number of the plane
  PlanPolygon polygon;
};

/// A roof in 2.5D: the outline divided into regions, each under one plane. Local frame, metres.
/// Regions do not overlap; where neighbours meet they have the same vertices.
struct RoofPartition {
  std::vector<Plane> planes;
  std::vector<RoofRegion> regions;
};

/// The partition that `plane_of` describes, with boundaries along those parts of `segments` across
/// which it changes; -1 where nothing stands. Planes without a region are left out, the others
/// keep their order. Nothing where the labels contradict each other (see divide_plan).
std::optional<RoofPartition> partition_plan(
    const std::vector<PlanSegment>& segments, const std::vector<Plane>& planes,
    const std::function<int(const Eigen::Vector2d&)>& plane_of);

/// The closed bodies between the height `base` and the roof, with vertical walls where heights
/// step. Nothing where one would not be valid (see check_solid), or where a plane comes down to
/// less than a millimetre above `base` in its region.
std::optional<std::vector<Solid>> solids_of_partition(const RoofPartition& partition, double base);

/// The region that holds a place of the plan, -1 outside all of them.
int region_at(const RoofPartition& partition, const Eigen::Vector2d& p);

/// Height of the roof over a place of the plan; not a number outside the regions.
double roof_height(const RoofPartition& partition, const Eigen::Vector2d& p);

}  // namespace gable
