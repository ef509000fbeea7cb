#pragma once

#include <gable/grammar/random.h>
#include <gable/grammar/raster.h>
#include <gable/grammar/synthesis/ground/site_ground.h>
#include <gable/grammar/synthesis/ground/vegetation.h>
#include <gable/grammar/synthesis/houses/built_shape.h>

#include <Eigen/Core>
#include <vector>

namespace gable {

using PlanRing = std::vector<Eigen::Vector2d>;

/// What grows around a building.
struct Greenery {
  std::vector<Tree> trees;
  std::vector<Hedge> hedges;
};

/// One to three cars of 4.2-5 x 1.8 x 1.5 m, vans among them, 0.7-6 m from a building.
BuiltShape random_cars(const PlanRing& outline, const SiteGround& ground, Random* random);

/// One to three sheds and greenhouses, 2.0-2.6 m high and 1.5-4 m a side, 0.5-6 m from a building,
/// a third of them closer than 1.5 m.
BuiltShape random_sheds(const PlanRing& outline, const SiteGround& ground, Random* random);

/// One to three trees whose crowns reach over a wall, mostly by less than a metre.
void plant_trees_over_walls(const PlanRing& outline, Random* random, Greenery* greenery);

/// Trees, shrubs, hedges and garden walls that keep clear of a building.
void plant_garden(const PlanRing& outline, Random* random, Greenery* greenery);

/// A grove, a row of trees or a block of tall hedges around a point: high, and no building.
Greenery random_grove(const Eigen::Vector2d& center, Random* random);

/// Raises `surface` to all of it.
void add_greenery(const Greenery& greenery, const HeightRaster& ground, Random* random,
                  HeightRaster* surface);

}  // namespace gable
