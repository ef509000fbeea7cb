#pragma once

#include <gable/grammar/house.h>
#include <gable/grammar/raster.h>
#include <gable/grammar/solid/extrusion.h>
#include <gable/grammar/synthesis/houses/prior.h>

#include <cstdint>
#include <string>

namespace gable {

/// How varied the scenes are that detectors are trained on. Every value is the most that a scene
/// may have; scenes draw theirs between nothing and that. With all shares, terrain_error and
/// most_noise 0 a survey shows the building alone, sampled at the cells' centres.
struct TrainingSceneOptions {
  double least_gsd = 0.25;        ///< metres, [0.1, 2]
  double most_gsd = 1.0;          ///< metres, >= least_gsd, <= 2
  double neighbour_share = 0.35;  ///< with a neighbour across a party wall or close by, [0, 1]
  double tree_share = 0.45;       ///< with trees that reach over a wall, [0, 1]
  double garden_share = 0.7;      ///< with trees, shrubs and hedges around, 1.35 of it from
                                  ///< cells of 0.75 m on, [0, 1]
  double shed_share = 0.25;       ///< with sheds, [0, 1]
  double car_share = 0.3;         ///< with cars in front, [0, 1]
  double clutter_share = 0.4;     ///< with solar panels, vents, parapets on the roof, [0, 1]
  double hole_share = 0.25;       ///< surveys with missing cells, [0, 1]
  double smooth_share = 0.45;     ///< surveys whose edges are smoothed, 0.8 of it below
                                  ///< 0.75 m and 1.6 of it from there on, [0, 1]
  double off_center_share = 0.7;  ///< of the others: sampled off the cells' centres, [0, 1]
  double outlier_share = 0.15;    ///< surveys with outliers, 0.2 % of their cells, [0, 1]
  double least_noise = 0.02;      ///< range of the paper's noise, metres, [0, most_noise]
  double most_noise = 0.3;        ///< metres, <= 2
  double terrain_error = 0.4;     ///< terrain left over in the surface, metres, [0, 2]
  double row_share = 0.45;        ///< of I and II, half of it of III: slices of a row between its
                                  ///< neighbours, 0.4 of it from cells of 0.75 m on, [0, 1]
  double oblique_share = 0.35;    ///< of those: footprints cut obliquely, by 15 % at most, [0, 1]
  double plain_share = 0.5;       ///< of the other I: plain houses, long terraces, sheds, [0, 1]
  double gable_share = 0.35;      ///< of the other I, II, III: those without any hip, 1.6 of it
                                  ///< from cells of 0.75 m on, [0, 1]
  double bent_share = 0.25;  ///< of the built C: bent and linked rows, up to 100 m long, [0, 1]
  double torn_share = 0.12;  ///< of the built C: slices of a row and sheds with 22-60 % of their
                             ///< footprint cut off, [0, 1]
  double least_hip_cells = 1.6;  ///< hips of a shorter run are gables, cells, [0, 4]
  double footprint_error = 0.5;  ///< most that `footprint` is moved by, metres, [0, 1]
  PriorOptions prior;            ///< of the details

  /// Empty, or one line that names the bound that does not hold.
  std::string check() const;
};

/// One building as a survey shows it, with what it is.
struct TrainingScene {
  Foundation foundation = Foundation::kC;  ///< kC: beyond the grammar, or no building
  House house;                             ///< the truth; not read where `foundation` is kC
  /// What stands there, world: house with garages, or the composite; a known outline. Empty for
  /// what is no building (trees).
  PlanPolygon outline;
  /// The outline as a register has it: a little moved and turned, its front or back cut obliquely.
  PlanPolygon footprint;
  Eigen::Vector2d center = Eigen::Vector2d::Zero();  ///< a world point on the building
  HeightRaster dsm;                                  ///< surveyed, NaN: missing
  HeightRaster dtm;    ///< the terrain as a survey derives it: smooth, a little wrong
  HeightRaster truth;  ///< noise-free world heights of the building alone, NaN elsewhere; those
                       ///< of `house` but for flat sheds that lean
  /// Another building (sheds and vans among them) touches this one, or is closer than 1.5 cells and
  /// what the survey blends: heights alone do not tell where it ends, so crops are cut by
  /// `footprint`. So are cut footprints and what is too small to be found.
  bool outline_needed = false;
};

/// A scene of the given foundation, kC among them: a building of random derivation in a random
/// sensor grid, with neighbours, trees, hedges, cars, missing cells, smoothed edges and the paper's
/// noise (NPR section 5.4). The same seed and options give the same scene, bit for bit.
TrainingScene make_training_scene(Foundation foundation, uint64_t seed,
                                  const TrainingSceneOptions& options);

}  // namespace gable
