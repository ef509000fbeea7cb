#pragma once

#include <gable/engine/closing/closing_evidence.h>
#include <gable/engine/closing/closing_options.h>
#include <gable/engine/closing/height_sample.h>
#include <gable/grammar/solid/extrusion.h>
#include <gable/grammar/solid/plane.h>
#include <gable/grammar/solid/roof_partition.h>
#include <gable/grammar/solid/solid.h>

#include <string>
#include <vector>

namespace gable {

/// A roof closed from planes, and how it came about.
struct ClosedPlanes {
  RoofPartition roof;         ///< empty where there is none
  std::vector<Solid> solids;  ///< valid, between base and roof; one per connected body
  /// Per plane of the roof the number of the plane given that it came from; -1: a level one that
  /// stands in, at the median height or just above the base.
  std::vector<int> origins;
  /// What the roof costs (see ClosingOptions), after the first labelling and after every refit that
  /// lowered it: falling. Cubic metres.
  std::vector<double> costs;
  int cells = 0;       ///< that the outline was divided into at last
  std::string reason;  ///< why there is no roof; empty where there is one
};

/// Closes planes into a 2.5D roof over an outline: its plan is divided by the lines along which
/// neighbouring planes meet or heights step, every cell gets the plane that a graph cut finds best
/// for the samples in it, for short boundaries, low steps and few planes, and cells of one plane
/// become one region. Then the planes are refitted together to the samples of their regions, with
/// the regularities found among them, and all is done again as long as the cost falls.
///
/// In the manner of Zebedin et al. 2008 ("Fusion of Feature- and Area-Based Information for Urban
/// Buildings Modeling from Aerial Imagery"), on lines that come from the planes themselves and from
/// the walls of `evidence`. Where corners of the solid come too near to each other, the lines,
/// corners or planes there are moved by up to two centimetres; where that does not help, planes and
/// outline are all moved by millimetres, then boundaries made dearer. What cannot be closed at all
/// comes back with the reason. Samples outside the outline are left out. All in one local frame,
/// metres; deterministic.
ClosedPlanes close_planes(const PlanPolygon& outline, const std::vector<Plane>& planes,
                          const std::vector<HeightSample>& samples, double base,
                          const ClosingOptions& options, const ClosingEvidence& evidence = {});

}  // namespace gable
