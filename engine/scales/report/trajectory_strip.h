#pragma once

#include <gable/engine/scales/scale_labels.h>
#include <gable/engine/scales/trajectory.h>

#include <opencv2/core.hpp>
#include <vector>

namespace gable {

/// Where the configurations of a trajectory lie on an axis from many shapes to few, even in the
/// logarithm of their number.
class ShapeNumberAxis {
 public:
  /// `width` in pixels.
  ShapeNumberAxis(const Trajectory& trajectory, int width);

  /// Where a configuration begins, pixels from the left; num_configurations is the right end.
  double position(int configuration) const;
  /// Where shapes of a number begin (the configuration that has as many).
  double position_of_number(double num_shapes) const;
  /// The configuration in the middle of a column of pixels.
  int configuration(int column) const;

 private:
  int num_first_;
  int num_last_;
  int width_;
};

/// A labelled trajectory as a picture.
struct TrajectoryStrip {
  cv::Mat image;           ///< 8-bit BGR
  cv::Rect strip;          ///< where the configurations are, coloured by label
  std::vector<int> marks;  ///< per scale: the column of the image where it begins
};

/// Draws a trajectory from left (many shapes) to right (few): a strip in the colours of the labels
/// (`label_color`), above it the RMS distance of every merge (metres, logarithmic), and a mark with
/// its number where each scale begins. `width` is at least 320 pixels.
TrajectoryStrip draw_trajectory_strip(const Trajectory& trajectory, const ScaleLabels& labels,
                                      int width = 1280);

}  // namespace gable
