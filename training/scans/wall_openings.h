#pragma once

#include <gable/grammar/random.h>
#include <gable/training/scans/surface_shapes.h>

#include <Eigen/Core>
#include <functional>
#include <vector>

namespace gable {

/// How the windows of a building look; sizes in metres.
struct WindowStyle {
  double storey = 2.8;   ///< height of a storey
  double sill = 0.9;     ///< of a window over its floor
  double width = 1.1;    ///< of a window
  double height = 1.3;   ///< of a window
  double spacing = 2.6;  ///< least distance between the middles of two windows
  double depth = 0.12;   ///< of the recess
  double door_width = 1.0;
  double door_height = 2.1;
};

WindowStyle random_window_style(double storey, Random* random);

/// Rows of windows on a wall, one row a storey, apart by the style's spacing and centred, where
/// they fit into the outline with a margin and `is_free` holds for their rectangle; the first
/// window of the lowest row is a door where `with_door`. A few windows are left out at random.
/// @param outline  of the wall in metres: first axis along it, second up from the ground
std::vector<Recess> wall_openings(const std::vector<Eigen::Vector2d>& outline,
                                  const WindowStyle& style, bool with_door, Random* random,
                                  const std::function<bool(const Recess&)>& is_free);

}  // namespace gable
