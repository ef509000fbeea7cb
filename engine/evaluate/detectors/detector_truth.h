#pragma once

#include <gable/engine/annotated_house.h>
#include <gable/engine/dataset/training_sample.h>
#include <gable/engine/detectors/crop_bits.h>
#include <gable/engine/detectors/crop_tasks.h>
#include <gable/engine/detectors/house_crop.h>
#include <gable/grammar/house.h>
#include <gable/residuals/height_image.h>

#include <Eigen/Core>
#include <vector>

namespace gable {

/// A building as crops, and what the detectors should say of it.
struct DetectorTruth {
  HouseCrop crop;    ///< rectified; the members below are in its frame
  HouseCrop turned;  ///< at azimuth 0
  Foundation foundation = Foundation::kC;
  double azimuth = 0.0;              ///< modulo a quarter turn, radians; NaN where unknown
  CropBits outline;                  ///< pixels of the foundation, garages left out
  std::vector<CropBits> components;  ///< of an I, II, III; one of an L or U: its outline
  std::vector<RoofType> roofs;       ///< of the components
  std::vector<Eigen::Vector2d> dormers, chimneys;  ///< crop pixels; those that the heights show
  std::vector<Eigen::Vector2d> faint_dormers, faint_chimneys;  ///< those that they do not
  CropBits garages;
};

/// The truth of a synthetic sample.
DetectorTruth truth_of(const TrainingSample& sample);

/// The truth of an annotated building in a crop of its heights at `azimuth`, radians, local.
DetectorTruth truth_of(const AnnotatedHouse& house, const HeightImage& image, double azimuth);

/// The pixels whose centres lie in a polygon of crop pixels, even-odd.
CropBits bits_of_polygon(const std::vector<Eigen::Vector2d>& ring);

}  // namespace gable
