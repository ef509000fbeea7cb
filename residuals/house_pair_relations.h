#pragma once

#include <ceres/cost_function.h>
#include <gable/grammar/house.h>

#include <memory>
#include <vector>

namespace gable {

/// A residual over the rules of two houses: the cost function and, in the order of its parameter
/// blocks, the positions of these rules in House::derivation(), those of the first house before
/// those of the second. Origins are constants: the houses have frames of their own.
struct HousePairRelation {
  std::unique_ptr<ceres::CostFunction> cost;
  std::vector<int> rules_a;
  std::vector<int> rules_b;
};

/// A wall of a house: one edge of a component's rectangle.
struct ComponentWall {
  int component = 0;
  int side = 0;  ///< block_value::kX0, kX1, kY0 or kY1
};

/// How two walls of different houses run beside each other.
struct WallContact {
  double length = 0.0;  ///< of wall a that lies beside wall b, metres; <= 0: none does
  double from = 0.0;    ///< where that part begins, as a share of wall a
  double to = 0.0;      ///< where it ends, as a share of wall a
  /// Signed distances of these two points from the line of wall b, metres: positive outside house
  /// b, i.e. where there is a gap, and negative where the houses overlap.
  double offset_from = 0.0;
  double offset_to = 0.0;
  double angle = 0.0;  ///< between a's outward normal and b's inward one, radians, [0, pi]
};

WallContact wall_contact(const House& a, const ComponentWall& wall_a, const House& b,
                         const ComponentWall& wall_b);

/// The azimuth of b that is the same direction modulo a quarter turn and next to that of a, less
/// the azimuth of b: a multiple of pi / 2, radians.
double quarter_turns(const House& a, const House& b);

// Weights: residuals are weight times a difference, in its unit, as in house_relations.h.

/// Two walls are one: weight * the signed distances (metres, as in WallContact) of two points of
/// wall a from the line of wall b. The points keep their shares of wall a, those where the contact
/// of the houses as given begins and ends. With p a point of wall a in the frame of house a, R the
/// rotations by the azimuths and o the origins, the point is in the frame of house b
///
///   q = R_b' (R_a p + o_a - o_b)
///
/// and its distance from the side x = x1, say, is q.x - x1. Two residuals, smooth everywhere.
/// Parameter blocks: azimuth and footprint rule of a, then of b. The walls must have a contact.
HousePairRelation party_wall(const House& a, const ComponentWall& wall_a, const House& b,
                             const ComponentWall& wall_b, double weight);

/// Two components have their eaves at one elevation: weight * the difference of
/// origin.z + eaves, metres.
HousePairRelation equal_eaves(const House& a, int component_a, const House& b, int component_b,
                              double weight);

/// Two components have their ridges at one elevation: weight * the difference of
/// origin.z + eaves + rise, metres. A flat roof's ridge is its eaves.
HousePairRelation equal_ridges(const House& a, int component_a, const House& b, int component_b,
                               double weight);

/// Two houses have one azimuth modulo a quarter turn, that of `quarter_turns`:
/// weight * the difference, radians.
HousePairRelation equal_azimuths(const House& a, const House& b, double weight);

}  // namespace gable
