#pragma once

#include <gable/engine/dataset/training_sample.h>
#include <gable/engine/reconstruct/tile/reconstruct_tile.h>

#include <optional>
#include <string>

namespace gable {

/// When the solver's own answer is good enough to teach with.
struct RealSampleOptions {
  /// Largest mean absolute distance from the heights, metres, (0, 10], at cells of 0.5 m; grows
  /// with the square root of coarser ones.
  double most_mad = 0.45;
  /// By how much the best hypothesis of any other foundation type must be dearer, in units of the
  /// penalised cost and for each square root of a hundred pixels, >= 0.
  double least_gap = 5.0;
  /// Where detectors were asked, how probable they must find the type, [0, 1].
  double least_probability = 0.7;
  double least_iou = 0.65;  ///< of the house's outline and the building's pixels, [0, 1]
  /// What is further than this from the heights, whatever is tried, is beyond the grammar, metres,
  /// >= most_mad.
  double beyond_mad = 0.9;
  double beyond_area = 150.0;  ///< smaller ones are not called that, square metres, >= 0
};

/// Empty if the options are in range; otherwise names the violated bound.
std::string check(const RealSampleOptions& options);

/// Why a building teaches or not.
enum class RealSampleVerdict { kHouse, kBeyondGrammar, kPoorFit, kCloseSecond };

/// How far the best hypothesis is ahead of the best of any other foundation type in penalised cost;
/// infinite where no other came to the end, 0 where nothing was found.
double lead_of(const HouseChoice& choice);

/// Intersection over union of a building's pixels and those that its house, garages with it,
/// covers.
double outline_iou(const TileBuilding& building);

RealSampleVerdict judge(const TileBuilding& building, const RealSampleOptions& options);

/// The sample of a reconstructed building that teaches: its house, or class C where it is beyond
/// the grammar or has more blocks than the detectors name. Its dormers, chimneys and garages are
/// not all known. Nothing for the others.
std::optional<TrainingSample> real_sample(const TileBuilding& building,
                                          const RealSampleOptions& options);

}  // namespace gable
