// Refinement alone: synthetic houses of every type with the paper's noise, trees and outliers, from
// disturbed starts. Prints the share that ends under 0.10 m mean error to the noise-free truth.
//   gable_check_refinement [houses per type] [first seed]

#include <gable/engine/reconstruct/finding/vegetation.h>
#include <gable/engine/solver/house_refinement.h>
#include <gable/grammar/height_field.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include "scene_image.h"

namespace gable {

namespace {

// Mean |h - truth|, metres.
struct TruthError {
  double over_house = 0.0;  // over the pixels where the house or the truth stands
  double over_crop = 0.0;   // over all pixels of the crop
};

TruthError truth_error(const Scene& scene, const House& house) {
  const HeightField field(house);
  const Grid& grid = scene.dsm.grid;
  double sum = 0.0;
  int n = 0;
  for (int row = 0; row < grid.rows; ++row) {
    for (int col = 0; col < grid.cols; ++col) {
      const double ground = scene.dtm.at(row, col) - house.origin.z();
      const double truth = scene.truth.at(row, col) - house.origin.z();
      const double h =
          field.at_local(grid.center_of(row, col) - house.origin.head<2>(), 0.0, ground);
      sum += std::abs(h - truth);
      n += std::abs(h - ground) > 1e-3 || std::abs(truth - ground) > 1e-3;
    }
  }
  return {sum / std::max(n, 1), sum / static_cast<double>(grid.size())};
}

// Off by up to 1.5 m in place, 20 % in size, 1 m in height and 5 degrees.
void disturb(Random* random, House* house) {
  const auto shift = [&](double& v, double range) { v += random->uniform(-range, range); };
  const auto scale = [&](double& v) { v *= 1.0 + random->uniform(-0.2, 0.2); };
  shift(house->azimuth[0], 5.0 * M_PI / 180.0);
  for (Rule& r : house->footprints) {
    shift(r[0], 1.5);
    shift(r[1], 1.5);
    for (int k = 2; k < r.size(); ++k) scale(r[k]);
  }
  for (Rule& r : house->roofs) {
    shift(r[param::roof::kEaves], 1.0);
    if (r.size() > 1) {
      shift(r[param::roof::kRise], 1.0);
      r[param::roof::kRise] = std::max(r[param::roof::kRise], 0.3);
    }
    for (int k = 2; k < r.size(); ++k) scale(r[k]);
  }
}

int run(int per_type, uint64_t first_seed) {
  const Foundation types[] = {Foundation::kI, Foundation::kII, Foundation::kIII, Foundation::kL,
                              Foundation::kU};
  int good = 0, good_crop = 0, all = 0;
  double iterations = 0.0, time = 0.0;
  for (const Foundation type : types) {
    std::vector<double> errors;
    int type_good = 0;
    for (int i = 0; i < per_type; ++i) {
      SceneOptions options;
      options.seed = first_seed + static_cast<uint64_t>(i);
      options.trees = 1 + i % 2;
      options.lidar.outlier_share = 0.03;
      options.prior.dormer_share = 0.0;
      options.prior.chimney_share = 0.0;
      options.prior.garage_share = 0.0;
      const Scene scene = make_scene(type, options);
      HeightImage image = scene_image(scene);
      leave_out_vegetation({}, &image);
      House house = scene.house;
      Random random(options.seed * 7919 + 13);
      disturb(&random, &house);
      RefinementOptions refinement;
      refinement.deviations = false;
      const RefinementSummary summary = refine_house(image, refinement, &house);
      const TruthError error = truth_error(scene, house);
      errors.push_back(error.over_house);
      type_good += error.over_house < 0.10;
      good_crop += error.over_crop < 0.10;
      iterations += summary.iterations;
      time += summary.time_ms;
      ++all;
    }
    good += type_good;
    std::sort(errors.begin(), errors.end());
    std::printf("%-3s under 0.10 m: %3d of %d, median %.3f m, 95 %% %.3f m\n",
                std::string(foundation_name(type)).c_str(), type_good, per_type,
                errors[errors.size() / 2], errors[errors.size() * 95 / 100]);
  }
  std::printf(
      "all under 0.10 m over the house: %.1f %%, over the crop: %.1f %%; %.1f iterations, "
      "%.2f ms a house\n",
      100.0 * good / all, 100.0 * good_crop / all, iterations / all, time / all);
  return 0;
}

}  // namespace
}  // namespace gable

int main(int argc, char** argv) {
  const int per_type = argc > 1 ? std::atoi(argv[1]) : 100;
  const int first_seed = argc > 2 ? std::atoi(argv[2]) : 1;
  return gable::run(per_type, static_cast<uint64_t>(first_seed));
}
