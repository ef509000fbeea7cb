// A million points, from a cloud without normals to the labels of its trajectory, against the
// search for neighbours that it cannot do without.

#include <benchmark/benchmark.h>
#include <gable/engine/io/model_folder.h>
#include <gable/engine/io/shapes/scale_model_file.h>
#include <gable/engine/scales/detect_scales.h>
#include <gable/engine/scales/neighbours.h>
#include <gable/engine/scales/scale_chain.h>
#include <gable/engine/scales/train_forest.h>
#include <gable/grammar/random.h>
#include <malloc.h>

#include <algorithm>
#include <fstream>
#include <string>

#include "scan_scene.h"

namespace gable {
namespace {

constexpr int kSmall = 115000, kLarge = 1150000;
constexpr int kThreads = 2;
constexpr char kModel[] = "buildings";

/// A forest of the usual size for where no model is installed; what it says means nothing.
Forest random_forest() {
  constexpr int kScales = 3, kConfigurations = 1000;
  Random random(1);
  std::vector<LabelledTrajectory> trajectories(10);
  for (LabelledTrajectory& trajectory : trajectories) {
    for (int i = 0; i < kConfigurations; ++i) {
      ScaleFeatures features;
      for (float& f : features) f = static_cast<float>(random.uniform(0.0, 1.0));
      trajectory.features.push_back(features);
      trajectory.labels.push_back(i * (kScales + 1) / kConfigurations);
    }
  }
  return train_forest(trajectories, kScales, {});
}

ScaleModel model_at_hand() {
  const std::vector<std::string> names = scale_model_names();
  if (std::find(names.begin(), names.end(), kModel) == names.end()) {
    return {"random", 0.5, random_forest()};
  }
  return read_scale_model(find_scale_model(kModel));
}

/// A number of /proc/self/status, in bytes.
double status_bytes(const std::string& name) {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);) {
    if (line.starts_with(name + ":")) return 1024.0 * std::stod(line.substr(name.size() + 1));
  }
  return 0.0;
}

/// The most memory that a call has at a time, over what there is before it, bytes.
template <typename Call>
double peak_bytes(const Call& call) {
  malloc_trim(0);
  std::ofstream("/proc/self/clear_refs") << 5 << std::flush;  // the peak so far is what is now
  const double before = status_bytes("VmRSS");
  call();
  return status_bytes("VmHWM") - before;
}

FirstShapesOptions options_of_bench() {
  FirstShapesOptions options;
  options.threads = kThreads;
  return options;
}

void BM_Knn(benchmark::State& state) {
  const Scan scan = make_scan_scene(static_cast<int>(state.range(0)));
  for (auto _ : state) {
    const OrderedCloud cloud = order_cloud(scan.points);
    benchmark::DoNotOptimize(
        find_neighbours(cloud, options_of_bench().neighbours, kThreads).indices.data());
  }
}

void BM_Trajectory(benchmark::State& state) {
  const Scan scan = make_scan_scene(static_cast<int>(state.range(0)));
  const ScaleModel model = model_at_hand();
  int first_shapes = 0;
  size_t merges = 0;
  for (auto _ : state) {
    const CollapsedScan collapsed = collapse_scan(scan, options_of_bench());
    const ScaleLabels labels =
        label_trajectory(collapsed.trajectory.features, model.forest, {model.gamma});
    benchmark::DoNotOptimize(labels.first.data());
    first_shapes = collapsed.trajectory.num_first;
    merges = collapsed.trajectory.merges.size();
  }
  state.counters["first_shapes"] = first_shapes;
  state.counters["merges"] = static_cast<double>(merges);
  state.SetItemsProcessed(state.iterations() * state.range(0));  // points
}

/// Memory, not time, over the points themselves.
void BM_TrajectoryMemory(benchmark::State& state) {
  const Scan scan = make_scan_scene(static_cast<int>(state.range(0)));
  double bytes = 0.0;
  for (auto _ : state) {
    bytes = peak_bytes(
        [&] { benchmark::DoNotOptimize(collapse_scan(scan, options_of_bench()).trajectory); });
  }
  state.counters["bytes_per_point"] = bytes / static_cast<double>(state.range(0));
}

void sizes(benchmark::internal::Benchmark* bench) {
  bench->Arg(kSmall)->Arg(kLarge)->Unit(benchmark::kSecond)->UseRealTime();
}
BENCHMARK(BM_Knn)->Apply(sizes)->Iterations(3);
BENCHMARK(BM_Trajectory)->Apply(sizes)->Iterations(1);
BENCHMARK(BM_TrajectoryMemory)->Apply(sizes)->Iterations(1);

}  // namespace
}  // namespace gable
