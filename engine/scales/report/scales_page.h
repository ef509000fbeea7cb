#pragma once

#include <limits>
#include <string>
#include <vector>

namespace gable {

/// What the page says about one structural scale.
struct ScaleEntry {
  std::string name;     ///< "Scale 2: roofs"
  std::string color;    ///< of its label, "#35586e"
  std::string picture;  ///< path relative to the page
  int configuration = 0;
  int num_shapes = 0;
  double coverage = 0.0;                                           ///< share
  double rms = 0.0;                                                ///< metres
  double rms_share = 0.0;                                          ///< of the scan's diagonal
  double angle_before = std::numeric_limits<double>::quiet_NaN();  ///< degrees; NaN: not known
  double angle_after = std::numeric_limits<double>::quiet_NaN();
};

/// What the page says about the scan and its trajectory.
struct ScalesSummary {
  std::string title;
  std::string elements;   ///< "100000 points"
  double diagonal = 0.0;  ///< metres
  int num_first_shapes = 0;
  std::string picture;  ///< of the scan
  std::string strip;    ///< picture of the trajectory
};

/// The page of a report on structural scales. Entries are shown in the order given.
std::string scales_page(const ScalesSummary& summary, const std::vector<ScaleEntry>& entries);

}  // namespace gable
