#pragma once

#include <gable/training/scans/surface_builder.h>

#include <Eigen/Core>
#include <array>
#include <functional>
#include <vector>

namespace gable {

/// Sides of an axis-aligned box, by the direction that they look to.
enum BoxSide { kLeft, kRight, kFront, kBack, kBottom, kTop };  // -x +x -y +y -z +z

/// Faces of a box from `low` to `high`, each a detail of its own. `structure` holds a plane of the
/// structure (or kTouching) per BoxSide; sides in `hidden` are left out.
void add_box(SurfaceBuilder* builder, const Eigen::Vector3d& low, const Eigen::Vector3d& high,
             const std::array<int, 6>& structure, const std::vector<BoxSide>& hidden = {});
/// The same with one plane of the structure for all sides.
void add_box(SurfaceBuilder* builder, const Eigen::Vector3d& low, const Eigen::Vector3d& high,
             int structure = kTouching, const std::vector<BoxSide>& hidden = {});

/// Strips between two curves of as many points, each strip a detail of its own (two, where its four
/// corners do not lie on a plane). From outside, `from` runs left to right below `to`.
void add_loft(SurfaceBuilder* builder, int structure, const SurfaceBuilder::Ring& from,
              const SurfaceBuilder::Ring& to);

/// A surface over the unit square in rows x columns cells, each a detail of its own (two, where its
/// corners do not lie on a plane). `at(s, t)`: s runs to the right and t up, seen from outside.
void add_patch(SurfaceBuilder* builder, int structure, int columns, int rows,
               const std::function<Eigen::Vector3d(double, double)>& at);

/// Strips swept from an open curve. From outside, with the sweep to the right, the curve runs up.
/// @param structure  per strip, one less than points
void add_strips(SurfaceBuilder* builder, const std::vector<int>& structure,
                const SurfaceBuilder::Ring& curve, const Eigen::Vector3d& sweep);

/// A polygon of a panel that lies deeper than the rest (depth > 0) or stands out of it (< 0).
struct Inset {
  std::vector<Eigen::Vector2d> outline;  ///< along the panel's axes, anticlockwise, metres
  double depth = 0.0;                    ///< metres, not 0
};

/// A rectangle of a panel that lies deeper than the rest (depth > 0) or stands out of it (< 0).
struct Recess {
  double u0 = 0.0, u1 = 0.0, v0 = 0.0, v1 = 0.0;  ///< metres along the panel's axes
  double depth = 0.0;                             ///< metres, not 0
};

/// A planar panel with insets: the panel with holes, and for each inset its bottom and sides, all
/// of one plane of the structure. `outline` lies in the axes u, v (orthonormal, u x v looks
/// outward) at `origin`; insets lie inside, apart from each other. Returns the panel's detail.
int add_panel(SurfaceBuilder* builder, int structure, const Eigen::Vector3d& origin,
              const Eigen::Vector3d& u, const Eigen::Vector3d& v,
              const std::vector<Eigen::Vector2d>& outline, const std::vector<Inset>& insets);
int add_panel(SurfaceBuilder* builder, int structure, const Eigen::Vector3d& origin,
              const Eigen::Vector3d& u, const Eigen::Vector3d& v,
              const std::vector<Eigen::Vector2d>& outline, const std::vector<Recess>& recesses);

}  // namespace gable
