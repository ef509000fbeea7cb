#include <gable/engine/io/build_model.h>
#include <gable/engine/reconstruct/building_fit.h>
#include <gable/engine/reconstruct/mask_outline.h>
#include <gable/engine/reconstruct/model_defect.h>
#include <gable/engine/reconstruct/penalised_cost.h>
#include <gable/engine/reconstruct/reconstruct_building.h>
#include <glog/logging.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <optional>
#include <utility>

namespace gable {
namespace {

// Height of a building without a single measurement: one storey, metres.
constexpr double kUnknownHeight = 3.0;

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
  if (const std::string error = check(options.choice); !error.empty()) return error;
  if (!(options.least_area >= 0.0 && options.least_area <= 1000.0)) {
    return "least_area must lie in [0, 1000] square metres";
  }
  if (!(options.outline_tolerance >= 0.01 && options.outline_tolerance <= 10.0)) {
    return "outline_tolerance must lie in [0.01, 10] m";
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
  const auto give_extrusion = [&](const std::string& reason) {
    extrusion.building.reason = reason;
    extrusion.model = build_model(extrusion.building);
    extrusion.building.quality.time_ms = watch.ms();
    return std::move(extrusion);
  };

  const BuildingFit flat = fit_of_building(image, extrusion.building);
  const double area = flat.pixels * image.gsd * image.gsd;
  if (area < options.least_area) {
    char text[64];
    std::snprintf(text, sizeof(text), "only %.1f square metres with heights", area);
    return give_extrusion(text);
  }
  HouseChoiceOptions choice_options = options.choice;
  choice_options.outline_known = outline != nullptr;
  std::optional<DetectedValues> detected;
  if (detect) detected = detect(image);
  extrusion.choice = choose_house(image, choice_options, detected ? &*detected : nullptr);
  const HouseChoice& choice = extrusion.choice;
  if (!choice.found) return give_extrusion("no house of the grammar explains the heights");

  ReconstructedBuilding house;
  house.building.id = id;
  house.building.house = choice.best.house;
  house.building.deviations = choice.summary.deviations;
  const BuildingFit fit = fit_of_building(image, house.building);
  set_fit(fit, &house.building);
  if (fit.charge > flat.charge + options.extrusion_margin) {
    return give_extrusion("the best house of the grammar is " + metres(fit.charge) +
                          " from the heights on average, the extruded outline " +
                          metres(flat.charge));
  }
  house.model = build_model(house.building);
  if (const std::string defect = defect_of(house.model); !defect.empty()) {
    return give_extrusion(defect);
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
