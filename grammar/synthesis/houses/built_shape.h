#pragma once

#include <gable/grammar/house.h>
#include <gable/grammar/solid/extrusion.h>

#include <Eigen/Core>
#include <vector>

namespace gable {

/// The forms that a part of a building may have; more than the grammar knows.
enum class PartForm {
  kFlat,
  kGable,     ///< hips at either end where their runs are not 0
  kMono,      ///< one slope, up towards +v
  kMansard,   ///< steep all around, then shallow: the slope changes `kink` inside the wall
  kBarrel,    ///< a vault along u
  kSawtooth,  ///< `count` slopes one behind the other along u
  kCone,      ///< over a regular polygon of `count` corners, or a circle (0)
  kDome,      ///< the same, vaulted
};

/// A rectangle or regular polygon anywhere in plan, under a roof. Its frame: u along `along`, v to
/// the left of it, both from `center`.
struct BuiltPart {
  Eigen::Vector2d center = Eigen::Vector2d::Zero();  ///< metres, in the frame of its shape
  Eigen::Vector2d along = Eigen::Vector2d::UnitX();  ///< unit vector
  double half_length = 1.0;                          ///< along u, metres; a polygon's inner radius
  double half_width = 1.0;                           ///< along v, metres; a polygon's inner radius
  PartForm form = PartForm::kFlat;
  double eaves = 0.0;      ///< metres
  double rise = 0.0;       ///< of the highest point over the eaves, metres
  double start_run = 0.0;  ///< of the hip at -u, metres; 0: a gable
  double end_run = 0.0;    ///< of the hip at +u, metres
  double kink = 0.0;       ///< kMansard: run of the steep slope, metres, < half_width
  double kink_rise = 0.0;  ///< kMansard: its rise, metres, <= rise
  int count = 0;           ///< see PartForm

  /// Height at a point, or -infinity outside.
  double at(const Eigen::Vector2d& point) const;
  /// Corners in plan, anticlockwise; a circle as 24 of them.
  std::vector<Eigen::Vector2d> ring() const;
  /// Radius of the circle around it, metres.
  double radius() const;
};

/// Something built, as it is seen from above: the highest of its parts, with thin things on top
/// that lift whatever is under them.
struct BuiltShape {
  std::vector<BuiltPart> parts;
  std::vector<BuiltPart> lifts;  ///< their heights are added

  /// Height at a point, or -infinity outside all parts.
  double at(const Eigen::Vector2d& point) const;
  void move(const Eigen::Vector3d& by);
  void append(const BuiltShape& other);
};

/// The blocks of a house as parts, world.
BuiltShape shape_of(const House& house);

/// The outline of a shape's parts in plan, its largest piece, counted anticlockwise; holes
/// clockwise. Parts are grown by a few millimetres, so that those which touch have no gap.
PlanPolygon outline_of(const BuiltShape& shape);

}  // namespace gable
