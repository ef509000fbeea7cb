#pragma once

#include <gable/grammar/house.h>
#include <gable/residuals/house_pair_relations.h>

#include <string>
#include <vector>

namespace gable {

/// What houses that touch have in common.
enum class NeighbourRelationKind { kPartyWall, kEqualEaves, kEqualRidges, kEqualAzimuths };

inline constexpr int kNumNeighbourRelationKinds = 4;

/// One relation between two of a list of houses. Components are those of the walls; azimuths belong
/// to no component.
struct NeighbourRelation {
  NeighbourRelationKind kind = NeighbourRelationKind::kPartyWall;
  int house_a = 0;
  int house_b = 0;
  ComponentWall wall_a;  ///< kPartyWall: the wall; kEqualEaves, kEqualRidges: its component counts
  ComponentWall wall_b;
};

/// When a relation is taken to be meant, and how it then pulls.
struct RelationScale {
  double tolerance = 0.0;  ///< misfit up to which it is detected, > 0
  double deviation = 0.0;  ///< standard deviation of what is meant to be equal, > 0
  /// Misfit at which its pull is the strongest; beyond that it lets go (the scale of a Cauchy
  /// loss), > 0.
  double let_go = 0.0;
};

struct NeighbourRelationOptions {
  RelationScale wall = {0.6, 0.005, 0.3};           ///< metres
  RelationScale height = {0.15, 0.015, 0.03};       ///< of eaves and ridges, metres
  RelationScale azimuth = {0.0698, 0.0035, 0.026};  ///< radians: 4, 0.2 and 1.5 degrees
  double wall_angle = 0.175;   ///< between party walls, radians (10 degrees), (0, 0.5]
  double least_contact = 1.5;  ///< length that party walls share, metres, (0, 100]
};

/// Empty if the options are in range; otherwise names the violated bound.
std::string check(const NeighbourRelationOptions& options);

/// The scale of relations of a kind.
const RelationScale& scale_of(const NeighbourRelationOptions& options, NeighbourRelationKind kind);

/// How far houses are from a relation: the larger of a party wall's two distances, the difference
/// of elevations, or that of azimuths modulo a quarter turn; metres or radians, >= 0.
double misfit(const std::vector<const House*>& houses, const NeighbourRelation& relation);

/// The relations that hold within the tolerances. Party walls face each other (outward normals
/// opposite within `wall_angle`), share `least_contact` metres and are nowhere there further apart
/// or deeper in each other than the tolerance; between two houses the longest contacts are taken,
/// and none of two walls that are both in a longer one. Houses with a party wall are compared by
/// their azimuths, and the components on either side of one by their eaves and ridges; ridges only
/// where neither roof is flat. In the order of the houses, the same whatever is done in threads;
/// time is linear in the pairs of houses whose boxes touch, with a small quadratic part.
std::vector<NeighbourRelation> detect_neighbour_relations(const std::vector<const House*>& houses,
                                                          const NeighbourRelationOptions& options);

/// The relation as a residual, weight times its misfit (signed).
HousePairRelation residual_of(const std::vector<const House*>& houses,
                              const NeighbourRelation& relation, double weight);

}  // namespace gable
