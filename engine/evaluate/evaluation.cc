#include <gable/engine/evaluate/evaluation.h>
#include <gable/engine/evaluate/model_surface.h>
#include <glog/logging.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace gable {
namespace {

Foundation foundation_of(const Building& building) {
  return building.house ? building.house->foundation : Foundation::kC;
}

/// Errors of the model over the union of a house's two footprints, one pass for all houses.
void add_union_errors(const ModelSurface& model, const ModelSurface& truth, const HeightRaster& dtm,
                      const std::vector<int>& truth_of_building, std::vector<TruthScore>* scores) {
  for (size_t i = 0; i < dtm.values.size(); ++i) {
    const int owner = truth.owner.values[i];
    const int building = model.owner.values[i];
    const int of_model = building >= 0 ? truth_of_building[building] : -1;
    if (owner >= 0) {
      const double seen = of_model == owner ? model.height.values[i] : dtm.values[i];
      (*scores)[owner].union_error.add(seen - truth.height.values[i]);
    }
    if (of_model >= 0 && of_model != owner) {
      (*scores)[of_model].union_error.add(model.height.values[i] - dtm.values[i]);
    }
  }
}

void add_footprint_errors(const ModelSurface& model, const EvaluationInput& input,
                          Evaluation* result) {
  HeightError over, both;
  for (size_t i = 0; i < input.dsm->values.size(); ++i) {
    const bool in_model = model.owner.values[i] >= 0;
    const float seen = in_model ? model.height.values[i] : input.dtm->values[i];
    if (input.footprints->values[i]) {
      over.add(seen - input.dsm->values[i]);
      both.add(seen - input.dsm->values[i]);
    } else if (in_model) {
      both.add(seen - input.dtm->values[i]);
    }
  }
  result->over_footprints = over;
  result->footprint_union = both;
}

HeightError union_error(const ModelSurface& model, const ModelSurface& truth,
                        const HeightRaster& dsm, const HeightRaster& dtm) {
  HeightError error;
  for (size_t i = 0; i < dsm.values.size(); ++i) {
    const bool in_model = model.owner.values[i] >= 0;
    if (truth.owner.values[i] >= 0) {
      error.add((in_model ? model.height.values[i] : dtm.values[i]) - dsm.values[i]);
    } else if (in_model) {
      error.add(model.height.values[i] - dtm.values[i]);
    }
  }
  return error;
}

double median(std::vector<double> values) {
  if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
  std::sort(values.begin(), values.end());
  const size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : 0.5 * (values[half - 1] + values[half]);
}

void summarise(const std::vector<TruthScore>& scores, double good_mad, TruthSummary* summary) {
  std::vector<double> mads;
  int right = 0, good = 0;
  double sum_iou = 0.0;
  for (const TruthScore& score : scores) {
    const bool missed = score.match.building < 0;
    const int column = missed ? TruthSummary::kMissed : static_cast<int>(score.found);
    ++summary->confusion[static_cast<int>(score.foundation)][column];
    if (!missed) ++summary->matched;
    if (!missed && score.found == score.foundation) ++right;
    sum_iou += score.match.iou;
    if (score.union_error.pixels() == 0) continue;  // outside the raster
    mads.push_back(score.union_error.mad());
    if (mads.back() < good_mad) ++good;
  }
  const double n = static_cast<double>(scores.size());
  summary->foundation_accuracy = right / n;
  summary->mean_iou = sum_iou / n;
  summary->share_good = good / n;
  summary->median_mad = median(mads);
}

void evaluate_against_truth(const EvaluationInput& input, const ModelSurface& model,
                            Evaluation* result) {
  const std::vector<Building>& buildings = *input.buildings;
  const std::vector<Building>& truth = *input.truth;
  const ModelSurface truth_surface = rasterise_buildings(truth, input.dsm->grid);
  const auto matches = match_buildings(model.owner, static_cast<int>(buildings.size()),
                                       truth_surface.owner, static_cast<int>(truth.size()));
  std::vector<int> truth_of_building(buildings.size(), -1);
  for (size_t t = 0; t < truth.size(); ++t) {
    TruthScore score;
    score.id = truth[t].id;
    score.foundation = foundation_of(truth[t]);
    score.match = matches[t];
    if (matches[t].building >= 0) {
      score.found = foundation_of(buildings[matches[t].building]);
      truth_of_building[matches[t].building] = static_cast<int>(t);
      result->buildings[matches[t].building].truth = static_cast<int>(t);
    }
    result->truth.push_back(score);
  }
  add_union_errors(model, truth_surface, *input.dtm, truth_of_building, &result->truth);

  TruthSummary summary;
  summarise(result->truth, result->options.good_mad, &summary);
  summary.invented = static_cast<int>(buildings.size()) - summary.matched;
  summary.union_error = union_error(model, truth_surface, *input.dsm, *input.dtm);
  const double radius = result->options.detection_radius;
  summary.dormers = score_detections(dormer_centers(buildings), dormer_centers(truth), radius);
  summary.chimneys = score_detections(chimney_centers(buildings), chimney_centers(truth), radius);
  result->summary = summary;
}

}  // namespace

std::string EvaluationOptions::check() const {
  if (!(detection_radius > 0.0)) return "detection_radius must be > 0";
  if (!(good_mad > 0.0)) return "good_mad must be > 0";
  return "";
}

Evaluation evaluate(const EvaluationInput& input, const EvaluationOptions& options) {
  CHECK(options.check().empty()) << options.check();
  CHECK(input.buildings != nullptr && input.dsm != nullptr && input.dtm != nullptr);
  CHECK(input.dsm->grid == input.dtm->grid);
  CHECK(input.triangles.empty() || input.triangles.size() == input.buildings->size());
  Evaluation result;
  result.options = options;
  for (size_t i = 0; i < input.buildings->size(); ++i) {
    BuildingScore score;
    score.id = (*input.buildings)[i].id;
    if (!input.triangles.empty()) score.triangles = input.triangles[i];
    result.buildings.push_back(score);
  }
  if (!input.triangles.empty()) {
    result.mean_triangles = std::accumulate(input.triangles.begin(), input.triangles.end(), 0.0) /
                            static_cast<double>(input.triangles.size());
  }
  const ModelSurface model = rasterise_buildings(*input.buildings, input.dsm->grid);
  for (size_t i = 0; i < model.owner.values.size(); ++i) {
    if (model.owner.values[i] < 0) continue;
    const double difference = model.height.values[i] - input.dsm->values[i];
    result.over_model.add(difference);
    result.buildings[model.owner.values[i]].over_model.add(difference);
  }
  if (input.footprints != nullptr) {
    CHECK(input.footprints->grid == input.dsm->grid);
    add_footprint_errors(model, input, &result);
  }
  if (input.truth != nullptr) evaluate_against_truth(input, model, &result);
  return result;
}

}  // namespace gable
