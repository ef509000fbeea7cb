// The whole choice on synthetic crops: nothing given but heights over a terrain. Prints foundation
// accuracy with its confusion matrix, footprint IoU, height errors to the truth, and precision and
// recall of dormers and chimneys.
//   gable_check_reconstruction [houses per type] [first seed] [verbose: 0 or 1]

#include <gable/engine/reconstruct/choice/house_choice.h>
#include <gable/engine/reconstruct/finding/vegetation.h>
#include <gable/engine/stopwatch.h>
#include <gable/grammar/height_field.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <numeric>
#include <vector>

#include "scene_image.h"

namespace gable {
namespace {

constexpr Foundation kTypes[] = {Foundation::kI, Foundation::kII, Foundation::kIII, Foundation::kL,
                                 Foundation::kU};

struct Detections {
  int found = 0, right = 0, truth = 0;
};

// Keeps the connected component (heights above 2 m) nearest to the crop's centre as the building.
void keep_central_component(HeightImage* image) {
  std::vector<int> label(image->size(), 0);
  int next = 0, best = 0;
  size_t best_size = 0;
  for (size_t start = 0; start < image->size(); ++start) {
    if (!image->inside[start] || label[start]) continue;
    std::vector<size_t> stack = {start};
    label[start] = ++next;
    size_t size = 0;
    while (!stack.empty()) {
      const size_t i = stack.back();
      stack.pop_back();
      ++size;
      const int row = static_cast<int>(i / image->cols), col = static_cast<int>(i % image->cols);
      const int steps[4][2] = {{0, 1}, {1, 0}, {0, -1}, {-1, 0}};
      for (const auto& s : steps) {
        const int r = row + s[0], c = col + s[1];
        if (r < 0 || c < 0 || r >= image->rows || c >= image->cols) continue;
        const size_t j = image->index(r, c);
        if (image->inside[j] && !label[j]) {
          label[j] = next;
          stack.push_back(j);
        }
      }
    }
    if (size > best_size) {
      best_size = size;
      best = next;
    }
  }
  for (size_t i = 0; i < image->size(); ++i) {
    if (image->inside[i] && label[i] != best) {
      image->inside[i] = 0;
      set_aside(i, image);
    }
  }
}

void match(const House& truth, const House& house, const std::vector<Rule>& truth_rules,
           const std::vector<Rule>& rules, Detections* out) {
  const HeightField a(truth), b(house);
  std::vector<char> used(truth_rules.size(), 0);
  out->found += static_cast<int>(rules.size());
  out->truth += static_cast<int>(truth_rules.size());
  for (const Rule& r : rules) {
    const Eigen::Vector2d p = b.local_from_house({r[0], r[1]});
    for (size_t i = 0; i < truth_rules.size(); ++i) {
      const Eigen::Vector2d q = a.local_from_house({truth_rules[i][0], truth_rules[i][1]});
      if (!used[i] && (p - q).norm() < 1.5) {
        used[i] = 1;
        ++out->right;
        break;
      }
    }
  }
}

int run(int per_type, uint64_t first_seed, bool verbose) {
  int confusion[5][kNumFoundationTypes] = {};
  std::vector<double> errors, ious, times;
  Detections dormers, chimneys, garages;
  for (int t = 0; t < 5; ++t) {
    for (int i = 0; i < per_type; ++i) {
      SceneOptions options;
      options.seed = first_seed + static_cast<uint64_t>(i);
      options.trees = i % 3;
      const Scene scene = make_scene(kTypes[t], options);
      HeightImage image = scene_image(scene);
      leave_out_vegetation({}, &image);
      keep_central_component(&image);
      const Stopwatch watch;
      const HouseChoice choice = choose_house(image, {});
      times.push_back(watch.ms());
      const House& house = choice.best.house;
      const int guess = choice.found ? static_cast<int>(house.foundation) : 5;
      ++confusion[t][guess];
      const HeightField field(house), truth_field(scene.house);
      double sum = 0.0;
      int n = 0, both = 0, either = 0;
      for (int row = 0; row < image.rows; ++row) {
        for (int col = 0; col < image.cols; ++col) {
          const double ground = image.ground[image.index(row, col)];
          const Eigen::Vector2d p = image.center_of(row, col);
          const double h = field.at_local(p, 0.0, ground);
          const double truth = truth_field.at_local(p, 0.0, ground);
          const bool in = field.block_at_house(field.house_from_local(p)) >= 0;
          const bool in_truth = truth_field.block_at_house(truth_field.house_from_local(p)) >= 0;
          both += in && in_truth;
          either += in || in_truth;
          if (in || in_truth) {
            sum += std::abs(h - truth);
            ++n;
          }
        }
      }
      errors.push_back(sum / std::max(n, 1));
      ious.push_back(static_cast<double>(both) / std::max(either, 1));
      match(scene.house, house, scene.house.dormers, house.dormers, &dormers);
      match(scene.house, house, scene.house.chimneys, house.chimneys, &chimneys);
      match(scene.house, house, scene.house.garages, house.garages, &garages);
      if (verbose && (guess != t || errors.back() > 0.3)) {
        std::printf("%s seed %d -> %s  error %.3f  IoU %.3f  noise %.3f  J:",
                    std::string(foundation_name(kTypes[t])).c_str(), static_cast<int>(options.seed),
                    std::string(foundation_name(static_cast<Foundation>(guess))).c_str(),
                    errors.back(), ious.back(), choice.noise);
        for (const Candidate& c : choice.finalists) {
          std::printf(" %s=%.0f(d%zu c%zu g%zu)",
                      std::string(foundation_name(c.house.foundation)).c_str(), c.cost.total,
                      c.house.dormers.size(), c.house.chimneys.size(), c.house.garages.size());
        }
        const PenaltyOptions penalty{0.5, LossKind::kGemanMcClure, 0.5, choice.noise};
        std::printf(" truth=%.0f(d%zu c%zu g%zu)\n",
                    penalised_cost(image, scene.house, penalty).total, scene.house.dormers.size(),
                    scene.house.chimneys.size(), scene.house.garages.size());
      }
    }
  }
  int right = 0;
  std::printf("truth \\ found   I   II  III    L    U    C    N\n");
  for (int t = 0; t < 5; ++t) {
    std::printf("%13s", std::string(foundation_name(kTypes[t])).c_str());
    for (const int count : confusion[t]) std::printf(" %4d", count);
    std::printf("\n");
    right += confusion[t][t];
  }
  const double n = static_cast<double>(errors.size());
  std::sort(errors.begin(), errors.end());
  std::sort(times.begin(), times.end());
  const double iou = std::accumulate(ious.begin(), ious.end(), 0.0) / n;
  const auto under = std::lower_bound(errors.begin(), errors.end(), 0.40) - errors.begin();
  std::printf("foundation %.1f %%, mean IoU %.3f, error median %.3f m, under 0.40 m %.1f %%\n",
              100.0 * right / n, iou, errors[errors.size() / 2],
              100.0 * static_cast<double>(under) / n);
  const auto rates = [](const char* name, const Detections& d) {
    std::printf("%s: precision %.1f %%, recall %.1f %% of %d\n", name,
                100.0 * d.right / std::max(d.found, 1), 100.0 * d.right / std::max(d.truth, 1),
                d.truth);
  };
  rates("dormers", dormers);
  rates("chimneys", chimneys);
  rates("garages", garages);
  std::printf("time median %.1f ms, 95 %% %.1f ms\n", times[times.size() / 2],
              times[times.size() * 95 / 100]);
  return 0;
}

}  // namespace
}  // namespace gable

int main(int argc, char** argv) {
  const int per_type = argc > 1 ? std::atoi(argv[1]) : 100;
  const int first_seed = argc > 2 ? std::atoi(argv[2]) : 1;
  return gable::run(per_type, static_cast<uint64_t>(first_seed), argc > 3 && *argv[3] == '1');
}
