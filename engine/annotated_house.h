#pragma once

#include <gable/engine/detectors/crop_tasks.h>
#include <gable/grammar/house.h>

#include <Eigen/Core>
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace gable {

/// How sure whoever looked at a building is of what it is.
enum class Confidence { kLow, kMedium, kHigh };

/// "low", "medium" or "high".
std::string_view confidence_name(Confidence confidence);
std::optional<Confidence> confidence_from_name(std::string_view name);

/// "flat", "gable" or "hip".
std::string_view roof_type_name(RoofType type);
std::optional<RoofType> roof_type_from_name(std::string_view name);

/// How many rectangles an annotation of a foundation has: 1, 2, 3 of I, II, III; 0 of L, U and C,
/// which are told by their polygon.
int num_annotated_rectangles(Foundation foundation);
/// How many roof types: one per rectangle of I, II, III; 1 of L and U; 0 of C.
int num_annotated_roofs(Foundation foundation);
/// How many corners the polygon has: 6 of L, 8 of U; 0 where any number is right.
int num_annotated_corners(Foundation foundation);

/// A real building as somebody who looked at its heights described it. World coordinates, metres.
/// What has more than three blocks is C here, as it is to the detectors.
struct AnnotatedHouse {
  std::string id;
  Eigen::Vector2d center = Eigen::Vector2d::Zero();  ///< of the outline's box along the azimuth
  double azimuth = 0.0;  ///< radians in [0, pi / 2), from east anticlockwise to a wall
  Foundation foundation = Foundation::kC;
  /// Corners of the rectangles in the frame turned by the azimuth: top left, top right, bottom
  /// left, bottom right, in the order of RectangleCorner.
  std::vector<std::array<Eigen::Vector2d, 4>> components;
  std::vector<Eigen::Vector2d> outline;  ///< without garages
  std::vector<RoofType> roofs;
  std::vector<Eigen::Vector2d> dormers;   ///< centres
  std::vector<Eigen::Vector2d> chimneys;  ///< centres
  std::vector<std::vector<Eigen::Vector2d>> garages;
  Confidence confidence = Confidence::kLow;
};

}  // namespace gable
