#pragma once

#include <Eigen/Core>
#include <vector>

namespace gable {

/// The heat maps of the detectors, 64 x 64 each: corners of the five foundations, four types each,
/// then the centres of dormers and of chimneys and the pixels of garages (NPR sections 4.1-4.4).
/// A map peaks at 1 over a point; the garage map is 1 over garages.
namespace crop_map {
/// Corners of the rectangles of I, II and III by their place in the crop.
enum RectangleCorner { kTopLeft, kTopRight, kBottomLeft, kBottomRight };
/// Corners of L and U polygons by their role, which no turn or mirror changes: the concave corners
/// (L 1, U 2); their convex neighbours along the boundary, at the inner ends of the wings (2, 2);
/// the neighbours of those, at the outer ends (2, 2); the outer corners (1, 2).
enum PolygonCorner { kConcave, kInnerEnd, kOuterEnd, kOuter };

inline constexpr int kCornersI = 0;
inline constexpr int kCornersII = 4;
inline constexpr int kCornersIII = 8;
inline constexpr int kCornersL = 12;
inline constexpr int kCornersU = 16;
inline constexpr int kDormers = 20;
inline constexpr int kChimneys = 21;
inline constexpr int kGarages = 22;
}  // namespace crop_map
inline constexpr int kNumCropMaps = 23;

/// What a roof classifier says of a component (I, II, III) or of a whole polygon (L, U).
enum class RoofType { kFlat, kGable, kHip };
inline constexpr int kNumRoofTypes = 3;

/// A corner of a foundation in a crop; `type` is a RectangleCorner or a PolygonCorner.
struct CropCorner {
  int type = 0;
  Eigen::Vector2d crop = Eigen::Vector2d::Zero();
};

}  // namespace gable
