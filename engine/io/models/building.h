#pragma once

#include <gable/grammar/house.h>
#include <gable/grammar/known_outline.h>
#include <gable/grammar/solid/extrusion.h>
#include <gable/grammar/solid/house_solids.h>
#include <gable/grammar/solid/roof_partition.h>

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

namespace gable {

/// How a building came out.
enum class BuildingStatus {
  kGrammar,    ///< a house of the grammar
  kPlanes,     ///< outside the grammar: the planes of its roof, closed over its outline
  kExtrusion,  ///< outside the grammar: its outline at one height (LoD 1.2)
};

/// "grammar", "planes" or "extrusion".
const char* building_status_name(BuildingStatus status);

/// How well a model fits the heights it was fitted to.
struct FitQuality {
  double mad = 0.0;      ///< mean absolute difference over the building's pixels, metres
  double rmse = 0.0;     ///< root mean square difference over the same pixels, metres
  double time_ms = 0.0;  ///< time spent on this building, milliseconds; not written when < 0
};

/// A building as reconstruction returns it and as files carry it. World frame, metres.
struct Building {
  std::string id;
  BuildingStatus status = BuildingStatus::kGrammar;
  std::string reason;  ///< what could not be reconstructed, and why; empty when all could
  FitQuality quality;

  /// kGrammar: the derivation. `house->origin` places it.
  std::optional<House> house;
  /// Standard deviations of the parameters in derivation order, one vector per rule; empty when
  /// they are not known.
  std::vector<std::vector<double>> deviations;

  /// kGrammar: where the walls are known to be (OutlinedHouse), relative to `house->origin`.
  KnownOutline walls;

  /// kPlanes, kExtrusion: the outline relative to `origin`, and its height above it.
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  PlanPolygon outline;
  double height = 0.0;

  /// kPlanes: the roof over the outline, relative to `origin`. Its solid over `base` is valid.
  std::optional<RoofPartition> roof;

  /// Height of the ground face relative to the origin's z (metres, usually <= 0).
  double base = 0.0;
};

}  // namespace gable
