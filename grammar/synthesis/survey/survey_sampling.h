#pragma once

#include <gable/grammar/random.h>
#include <gable/grammar/raster.h>
#include <gable/grammar/synthesis/ground/site_ground.h>
#include <gable/grammar/synthesis/houses/built_shape.h>

#include <vector>

namespace gable {

/// How a survey makes one height of what a cell sees.
enum class CellHeight {
  kPoint,    ///< that of one point in it
  kMean,     ///< the mean of several points in and around it
  kHighest,  ///< the highest of several points in it
};

struct SurveySampling {
  CellHeight height = CellHeight::kPoint;
  int points = 1;          ///< a cell, >= 1
  double footprint = 0.0;  ///< the points lie in a square around the cell's centre, cells a side

  /// How far what a cell sees reaches beyond it, cells.
  double reach() const { return footprint > 1.0 ? 0.5 * (footprint - 1.0) : 0.0; }
};

/// Random sampling of a survey: points anywhere in their cells (`smooth` false), as high as the
/// highest of them in some; or means over footprints of 0.8-1.8 cells.
SurveySampling random_sampling(bool smooth, double gsd, Random* random);

/// Sets `surface`, which holds the ground, to what is built, seen through the sampling.
void sample_built(const std::vector<const BuiltShape*>& shapes, const SiteGround& ground,
                  const SurveySampling& sampling, Random* random, HeightRaster* surface);

}  // namespace gable
