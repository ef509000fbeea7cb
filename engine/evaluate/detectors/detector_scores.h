#pragma once

#include <gable/engine/detectors/detector_nets.h>
#include <gable/engine/evaluate/detections.h>
#include <gable/engine/evaluate/detectors/detector_truth.h>

#include <array>
#include <span>
#include <string>
#include <vector>

namespace gable {

/// How often a class was right.
struct ClassScore {
  int right = 0;
  int all = 0;
  double share() const { return all > 0 ? static_cast<double>(right) / all : 0.0; }
};

/// A mean over houses.
struct MeanScore {
  double sum = 0.0;
  int count = 0;
  double mean() const { return count > 0 ? sum / count : 0.0; }
  void add(double value) {
    sum += value;
    ++count;
  }
  MeanScore& operator+=(const MeanScore& other) {
    sum += other.sum;
    count += other.count;
    return *this;
  }
};

/// How good the detectors are: the figures of the paper's Table 1 and its confusion matrix.
struct DetectorScores {
  /// Rows: truth, columns: answer, both I, II, III, L, U, C.
  std::array<std::array<int, kNumFoundations>, kNumFoundations> confusion{};
  /// Roof types of components of I, II, III; of L; of U. Given the true outline, as in the paper.
  std::array<ClassScore, 3> roofs;
  /// IoU of the best foundation of the true type with the true outline, by type I, II, III, L, U;
  /// none found counts 0.
  std::array<MeanScore, 5> foundation_iou;
  /// Within 3 crop pixels. Those that the heights do not show need not be found, but may be.
  DetectionScore dormers, chimneys;
  MeanScore garage_iou;                ///< of pixels, over houses that have a garage
  std::vector<double> azimuth_errors;  ///< modulo a quarter turn, radians, >= 0

  /// Adds the scores of other buildings.
  DetectorScores& operator+=(const DetectorScores& other);

  int houses() const;
  double foundation_accuracy() const;
  /// Median of the azimuth errors, radians; 0 without any.
  double median_azimuth_error() const;
};

/// Distance that a detected dormer or chimney may be off, crop pixels (NPR Table 1).
inline constexpr double kDetectionPixels = 3.0;

/// Asks the networks about one building and adds how right they are.
void add_score(const DetectorTruth& truth, DetectorNets* nets, DetectorScores* scores);

/// One column of the table of `score_table`.
struct ScoreColumn {
  std::string title;
  const DetectorScores* scores = nullptr;
};

/// The paper's Table 1 beside the columns, then a confusion matrix for each, as text.
std::string score_table(std::span<const ScoreColumn> columns);

}  // namespace gable
