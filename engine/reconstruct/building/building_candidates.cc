#include <gable/engine/io/models/build_model.h>
#include <gable/engine/reconstruct/building/building_candidates.h>
#include <gable/engine/reconstruct/building/known_walls.h>
#include <gable/engine/reconstruct/building/model_defect.h>
#include <gable/engine/reconstruct/heights/measured_heights.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace gable {
namespace {

// Height of a building without a single measurement: one storey, metres.
constexpr double kUnknownHeight = 3.0;

// Solids are never flatter than this, metres.
constexpr double kLeastHeight = 0.5;

}  // namespace

BuildingCandidate extruded_outline(const std::string& id, const HeightImage& image,
                                   PlanPolygon outline) {
  BuildingCandidate extrusion;
  Building& building = extrusion.building;
  building.id = id;
  building.status = BuildingStatus::kExtrusion;
  building.origin = image.origin;
  building.outline = std::move(outline);
  std::vector<float> heights = measured_heights(image);
  building.height = kUnknownHeight;
  if (!heights.empty()) {
    std::nth_element(heights.begin(), heights.begin() + heights.size() / 2, heights.end());
    building.height = heights[heights.size() / 2];
  }
  set_fit(fit_of_building(image, building), &building);
  building.height = std::max(building.height, building.base + kLeastHeight);
  extrusion.fit = fit_of_building(image, building);
  return extrusion;
}

BuildingCandidate chosen_house(const std::string& id, const HeightImage& image,
                               const HouseChoice& choice, const PlanPolygon* outline,
                               double farthest) {
  BuildingCandidate house;
  house.building.id = id;
  house.building.house = choice.best.house;
  house.building.deviations = choice.summary.deviations;
  if (outline) house.building.walls = known_walls(*outline, image, house.building, farthest);
  house.fit = fit_of_building(image, house.building);
  set_fit(house.fit, &house.building);
  return house;
}

std::string raise_house(const HeightImage& image, BuildingCandidate* house, BuildingModel* model) {
  Building& building = house->building;
  *model = build_model(building);
  if (!building.walls.empty() && !defect_of(*model).empty()) {
    building.walls = {};
    set_fit(fit_of_building(image, building), &building);
    *model = build_model(building);
  }
  return defect_of(*model);
}

PlanesCandidate closed_roof(const HeightImage& image, const RoofClosingOptions& options,
                            const Building& extrusion) {
  PlanesCandidate candidate;
  Building& building = candidate.planes.building;
  building = extrusion;
  candidate.defect = close_roof(image, options, &building);
  if (!candidate.defect.empty()) return candidate;
  candidate.planes.fit = fit_of_building(image, building);
  set_fit(candidate.planes.fit, &building);
  building.base = extrusion.base;
  return candidate;
}

}  // namespace gable
