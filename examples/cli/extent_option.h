#pragma once

#include <CLI/CLI.hpp>
#include <Eigen/Core>
#include <vector>

namespace gable {

/// Where the buildings of interest lie.
struct ExtentOption {
  std::vector<double> bounds;  ///< west, south, east, north, world metres; empty: everywhere

  bool holds(const Eigen::Vector2d& world) const {
    return bounds.empty() || (world.x() >= bounds[0] && world.y() >= bounds[1] &&
                              world.x() < bounds[2] && world.y() < bounds[3]);
  }
};

/// Adds --extent to a command.
inline void add_extent_option(CLI::App* command, ExtentOption* extent) {
  command
      ->add_option("--extent", extent->bounds,
                   "Only buildings here: west, south, east and north in the raster's metres")
      ->type_name("W S E N")
      ->expected(4);
}

}  // namespace gable
