#pragma once

#include <gable/engine/io/models/building.h>
#include <gable/engine/io/models/building_model.h>
#include <gable/engine/solver/neighbour_refinement.h>
#include <gable/residuals/height_image.h>

#include <optional>
#include <stop_token>
#include <string>
#include <vector>

namespace gable {

/// How houses that touch are refined together.
struct JoinOptions {
  NeighbourRefinementOptions refinement;
  int most_houses = 40;  ///< refined as one problem; larger groups are cut, [2, 1000]
  /// By how much a house's own robust cost (the squared residuals of `refinement.stage`) may rise
  /// for what it shares with its neighbours, as a share, [0, 1].
  double cost_rise = 0.05;
  int rounds = 8;  ///< how often a group is tried, each time without what failed, [1, 100]
};

/// Empty if the options are in range; otherwise names the violated bound.
std::string check(const JoinOptions& options);

/// A building with the heights it was fitted to.
struct FittedBuilding {
  const Building* building = nullptr;
  const HeightImage* image = nullptr;
};

/// A relation that a house was refined with, as the house sees it.
struct UsedRelation {
  NeighbourRelationKind kind = NeighbourRelationKind::kPartyWall;
  std::string neighbour;  ///< id of the other building
  double before = 0.0;    ///< misfit, metres or radians
  double after = 0.0;
};

/// A building as it came out of the joint refinement.
struct JoinedBuilding {
  Building building;
  BuildingModel model;
  std::vector<UsedRelation> relations;  ///< never empty
};

/// Refines the houses among `buildings` that share party walls together, group by group
/// (`neighbour_groups`), on `threads` threads. A group is accepted when no house's own cost rises
/// by more than `cost_rise`, pixels at its shared walls left aside, and every house still has valid
/// solids. A house that fails loses what it shares besides walls, and if it fails again the wall
/// with the largest misfit; then the group is tried again, `rounds` times in all. Quality and
/// solids are made anew; deviations are those that its own heights give. One entry per building,
/// none where it stays as it was. The result depends on neither the number of threads nor their
/// timing; after a stop request groups are left as they were.
std::vector<std::optional<JoinedBuilding>> join_neighbours(
    const std::vector<FittedBuilding>& buildings, const JoinOptions& options, int threads,
    const std::stop_token& stop);

}  // namespace gable
