#pragma once

#include <gable/engine/evaluate/building_matching.h>
#include <gable/engine/evaluate/detections.h>
#include <gable/engine/evaluate/height_error.h>
#include <gable/engine/io/models/building.h>
#include <gable/grammar/raster.h>

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace gable {

struct EvaluationOptions {
  double detection_radius = 1.5;  ///< metres, > 0: the paper's 3 pixels at 0.5 m
  double good_mad = 0.40;         ///< metres, > 0: the bound for `share_good`

  /// Empty, or one line that names the bound that does not hold.
  std::string check() const;
};

/// What is compared. The rasters lie on one grid; NaN where there is no measurement.
struct EvaluationInput {
  const std::vector<Building>* buildings = nullptr;
  const HeightRaster* dsm = nullptr;
  const HeightRaster* dtm = nullptr;
  const std::vector<Building>* truth = nullptr;  ///< or null
  /// Triangles of each building's finest model, or empty where they are not known.
  std::vector<int> triangles;
  /// On the same grid, not 0 where a known footprint covers a cell; or null.
  const Raster<unsigned char>* footprints = nullptr;
};

/// One building of the model.
struct BuildingScore {
  std::string id;
  HeightError over_model;  ///< against the DSM over the cells it covers (as seen from above)
  int truth = -1;          ///< the truth building that it was matched with, or -1
  std::optional<int> triangles;
};

/// One building of the truth.
struct TruthScore {
  std::string id;
  Foundation foundation = Foundation::kI;
  Foundation found = Foundation::kC;  ///< of the match; kC: an extrusion, or missed
  BuildingMatch match;
  /// Against the truth's noise-free heights over the union of both footprints: a cell of one only
  /// counts its height over the DTM. A missed building counts all of its own.
  HeightError union_error;
};

/// Figures over all truth buildings.
struct TruthSummary {
  /// Rows: truth, columns: found, both in the order of Foundation (I, II, III, L, U, C, N); the
  /// last column counts the missed ones.
  static constexpr int kMissed = kNumFoundationTypes;
  std::array<std::array<int, kNumFoundationTypes + 1>, kNumFoundationTypes> confusion{};
  double foundation_accuracy = 0.0;  ///< share of the truth buildings; a missed one is wrong
  double mean_iou = 0.0;             ///< over the truth buildings; a missed one counts 0
  int matched = 0;
  int invented = 0;         ///< model buildings that stand for no truth building
  double median_mad = 0.0;  ///< of TruthScore::union_error, metres
  double share_good = 0.0;  ///< truth buildings with such a MAD below `good_mad`
  /// Model against the DSM over the union of all footprints: a truth cell that the model misses
  /// counts |DSM - DTM|, a model cell outside the truth |model - DTM|.
  HeightError union_error;
  DetectionScore dormers;
  DetectionScore chimneys;
};

/// All figures. MAD and RMSE are the paper's (NPR section 6): along gravity, against the heights.
struct Evaluation {
  EvaluationOptions options;
  HeightError over_model;  ///< model against the DSM over all cells that it covers
  /// Where footprints were given: model against the DSM over their cells; one that the model misses
  /// counts |DSM - DTM|.
  std::optional<HeightError> over_footprints;
  /// The same with the model's cells outside the footprints added; they count |model - DTM|.
  std::optional<HeightError> footprint_union;
  std::optional<double> mean_triangles;
  std::vector<BuildingScore> buildings;  ///< in the order of the input
  std::vector<TruthScore> truth;         ///< in the order of the input; empty without truth
  std::optional<TruthSummary> summary;   ///< where truth was given
};

Evaluation evaluate(const EvaluationInput& input,
                    const EvaluationOptions& options = EvaluationOptions());

}  // namespace gable
