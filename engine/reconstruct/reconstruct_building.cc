#include <gable/engine/io/build_model.h>
#include <gable/engine/reconstruct/building_fit.h>
#include <gable/engine/reconstruct/known_walls.h>
#include <gable/engine/reconstruct/mask_outline.h>
#include <gable/engine/reconstruct/model_defect.h>
#include <gable/engine/reconstruct/penalised_cost.h>
#include <gable/engine/reconstruct/reconstruct_building.h>
#include <glog/logging.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <utility>

namespace gable {
namespace {

// Height of a building without a single measurement: one storey, metres.
constexpr double kUnknownHeight = 3.0;

// A margin that nothing exceeds, metres.
constexpr double kNever = 1000.0;

// Solids are never flatter than this, metres.
constexpr double kLeastHeight = 0.5;

class Stopwatch {
 public:
  double ms() const {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start_)
        .count();
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

std::string metres(double value) {
  char text[32];
  std::snprintf(text, sizeof(text), "%.2f m", value);
  return text;
}

/// Heights of the inside pixels that count.
std::vector<float> measured_heights(const HeightImage& image) {
  std::vector<float> heights;
  for (size_t i = 0; i < image.size(); ++i) {
    if (image.inside[i] && is_evidence(image, i)) heights.push_back(image.height[i]);
  }
  return heights;
}

Building extrusion_of(const std::string& id, const HeightImage& image, PlanPolygon outline) {
  Building building;
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
  return building;
}

/// What the last stage of a refinement minimises.
double robust_cost(const HeightImage& image, const RefinementOptions& options, const House& house) {
  const RefinementStage& stage = options.stages.back();
  PenaltyOptions penalty;
  penalty.support = stage.support;
  penalty.loss = stage.loss;
  penalty.loss_scale = stage.loss_scale;
  return penalised_cost(image, house, penalty).squared_residuals;
}

}  // namespace

std::string check(const BuildingOptions& options) {
  for (const std::string& error :
       {check(options.choice), check(options.house_scales), check(options.scale_values)}) {
    if (!error.empty()) return error;
  }
  if (!(options.least_area >= 0.0 && options.least_area <= 1000.0)) {
    return "least_area must lie in [0, 1000] square metres";
  }
  if (!(options.outline_tolerance >= 0.01 && options.outline_tolerance <= 10.0)) {
    return "outline_tolerance must lie in [0.01, 10] m";
  }
  if (const std::string error = check(options.closing); !error.empty()) return error;
  if (!(options.planes_from >= 0.0 && options.planes_from <= kNever)) {
    return "planes_from must lie in [0, 1000] m";
  }
  if (!(options.planes_margin >= 0.0 && options.planes_margin <= kNever)) {
    return "planes_margin must lie in [0, 1000] m";
  }
  if (!(options.planes_ratio >= 0.0 && options.planes_ratio <= 1.0)) {
    return "planes_ratio must lie in [0, 1]";
  }
  if (!(options.extrusion_margin >= 0.0 && options.extrusion_margin <= 10.0)) {
    return "extrusion_margin must lie in [0, 10] m";
  }
  return "";
}

ReconstructedBuilding reconstruct_building(const std::string& id, const HeightImage& image,
                                           const PlanPolygon* outline,
                                           const BuildingOptions& options,
                                           const DetectValues& detect) {
  CHECK(check(options).empty()) << check(options);
  const Stopwatch watch;
  ReconstructedBuilding extrusion;
  extrusion.building = extrusion_of(
      id, image, outline ? *outline : outline_of_mask(image, options.outline_tolerance));
  const BuildingFit flat = fit_of_building(image, extrusion.building);
  const auto give = [&](Building building, const std::string& reason) {
    extrusion.building = std::move(building);
    extrusion.building.reason = reason;
    extrusion.model = build_model(extrusion.building);
    extrusion.building.quality.time_ms = watch.ms();
    return std::move(extrusion);
  };
  const auto give_extrusion = [&](const std::string& reason) {
    return give(extrusion.building, reason);
  };
  const double area = flat.pixels * image.gsd * image.gsd;
  if (area < options.least_area) {
    char text[64];
    std::snprintf(text, sizeof(text), "only %.1f square metres with heights", area);
    return give_extrusion(text);
  }
  HouseChoiceOptions choice_options = options.choice;
  choice_options.outline_known = outline != nullptr;
  FirstValues values;
  if (detect) {
    DetectedValues detected = detect(image);
    values.foundation = detected.foundation;
    values.houses = std::move(detected.houses);
  }
  if (options.scales) {
    const HouseScales scales = house_scales(image, nullptr, options.house_scales);
    for (FirstValue& value : scale_values(image, scales, options.scale_values)) {
      values.houses.push_back(std::move(value));
    }
  }
  extrusion.choice = choose_house(image, choice_options, values);
  const HouseChoice& choice = extrusion.choice;
  // The planes of the roof where they can be closed and are nearer than one height, else that.
  const auto give_planes = [&](const std::string& reason) {
    Building planes = extrusion.building;
    const std::string defect = close_roof(image, options.closing, &planes);
    if (!defect.empty()) return give_extrusion(reason + "; " + defect);
    const BuildingFit fit = fit_of_building(image, planes);
    if (fit.charge > flat.charge - options.extrusion_margin) {
      return give_extrusion(reason + "; the planes of its roof are " + metres(fit.charge) +
                            " from the heights");
    }
    set_fit(fit, &planes);
    planes.base = extrusion.building.base;
    return give(std::move(planes), reason);
  };
  if (!choice.found) return give_planes("no house of the grammar explains the heights");

  ReconstructedBuilding house;
  house.building.id = id;
  house.building.house = choice.best.house;
  house.building.deviations = choice.summary.deviations;
  if (outline) house.building.walls = known_walls(*outline, image, house.building);
  const BuildingFit fit = fit_of_building(image, house.building);
  set_fit(fit, &house.building);
  if (fit.charge > flat.charge + options.extrusion_margin) {
    return give_planes("the best house of the grammar is " + metres(fit.charge) +
                       " from the heights on average, the extruded outline " + metres(flat.charge));
  }
  house.model = build_model(house.building);
  if (outline && !defect_of(house.model).empty()) {
    house.building.walls = {};
    set_fit(fit_of_building(image, house.building), &house.building);
    house.model = build_model(house.building);
  }
  if (const std::string defect = defect_of(house.model); !defect.empty()) {
    return give_planes(defect);
  }
  // Found in the heights, a building's cells are too uncertain at their rim to tell planes from
  // smear, and closing takes longer than all the rest.
  if (outline && options.planes_margin < kNever && fit.charge > options.planes_from) {
    Building planes = extrusion.building;
    if (close_roof(image, options.closing, &planes).empty()) {
      const BuildingFit closed = fit_of_building(image, planes);
      if (closed.charge < fit.charge - options.planes_margin &&
          closed.charge < options.planes_ratio * fit.charge) {
        return give_planes("the best house of the grammar is " + metres(fit.charge) +
                           " from the heights on average, the planes of its roof " +
                           metres(closed.charge));
      }
    }
  }
  house.building.quality.time_ms = watch.ms();
  house.choice = std::move(extrusion.choice);
  return house;
}

ReconstructedBuilding refine_building(const Building& start, const RefinementOptions& options,
                                      HeightImage* image) {
  CHECK(start.house && start.house->origin == image->origin);
  const Stopwatch watch;
  Building refined = start;
  if (measured_heights(*image).empty()) {
    refined.reason = "not refined: no heights there";
    return {refined, build_model(refined), {}};
  }
  refined.reason.clear();
  const RefinementSummary summary = refine_house(*image, options, &*refined.house);
  refined.deviations = summary.deviations;
  mark_covered(refined, image);
  set_fit(fit_of_building(*image, refined), &refined);
  BuildingModel model = build_model(refined);
  std::string reason = defect_of(model);
  if (summary.termination == Termination::kFailed) reason = "no solution was found";
  if (robust_cost(*image, options, *start.house) < robust_cost(*image, options, *refined.house)) {
    reason = "the given house is nearer to the heights";
  }
  if (!reason.empty()) {
    refined = start;
    refined.reason = "not refined: " + reason;
    mark_covered(refined, image);
    set_fit(fit_of_building(*image, refined), &refined);
    model = build_model(refined);
  }
  refined.quality.time_ms = watch.ms();
  return {std::move(refined), std::move(model), {}};
}

}  // namespace gable
