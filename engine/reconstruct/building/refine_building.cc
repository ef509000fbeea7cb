#include <gable/engine/io/models/build_model.h>
#include <gable/engine/reconstruct/building/building_fit.h>
#include <gable/engine/reconstruct/building/model_defect.h>
#include <gable/engine/reconstruct/building/refine_building.h>
#include <gable/engine/reconstruct/choice/penalised_cost.h>
#include <gable/engine/reconstruct/heights/measured_heights.h>
#include <gable/engine/stopwatch.h>
#include <glog/logging.h>

#include <string>
#include <utility>

namespace gable {
namespace {

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
