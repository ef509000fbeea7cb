#pragma once

#include <gable/grammar/random.h>
#include <gable/grammar/synthesis/plot.h>

#include <vector>

namespace gable {

/// A gently winding street: its centre line as a function of the way along the village's axis.
struct Street {
  Eigen::Vector2d origin = Eigen::Vector2d::Zero();  ///< world
  double heading = 0.0;     ///< of the village's axis, radians from east, anticlockwise
  double offset = 0.0;      ///< across the axis, metres
  double swing = 0.0;       ///< amplitude of the bends, metres
  double wavelength = 300;  ///< metres
  double phase = 0.0;       ///< radians

  Eigen::Vector2d at(double along) const;
  /// Direction of the centre line, radians from east.
  double direction_at(double along) const;
};

/// A house on a street: the plot and where it faces the street.
struct StreetPlot {
  Plot plot;
  int street = 0;
  int side = 1;        ///< 1: left of the street's direction, -1: right
  double start = 0.0;  ///< first and last point of the frontage along the street
  double end = 0.0;
};

struct StreetPlan {
  std::vector<Street> streets;
  std::vector<StreetPlot> plots;  ///< in the order of the given houses
};

/// Half of the width of carriageway and pavements, metres.
inline constexpr double kStreetHalfWidth = 5.0;

/// Places the houses along both sides of parallel winding streets, each facing the street with a
/// front garden of 3-8 m, at least `gap` metres from all others, garages included. Sets the azimuth
/// and the plan position of each house.
StreetPlan lay_out_streets(const std::vector<House>& houses, double gap,
                           const Eigen::Vector2d& center, Random* random);

}  // namespace gable
