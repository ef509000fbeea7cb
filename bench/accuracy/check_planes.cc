// Planes against known ones: buildings of a city model (LoD 2.2 surfaces) sampled with noise and
// 5 % outliers, and how well each detector finds their planes, with the tolerance that suits it
// best at each level of noise. "nearest true plane" knows the surface: about the most there is.
//   gable_check_planes [buildings] [seed] [points] [city model] [step]
// step: polygons of the model that touch count as one plane where their corners keep within this
// distance, metres (0.02 and 1 degree where it is not given). Fewer points than 20,000 are
// sparser than the 1 % of the diagonal that RANSAC's connectivity reaches.
//   CGAL's detectors are tried with the tolerances and the normals that had a chance at each level
// of noise on 15 of the buildings (see cgal_grid), which leaves 50 buildings to be measured in
// reasonable time: tolerances of 0.05 to 0.5 % of the diagonal without noise; 0.5 to 3 % (RANSAC to
// 2 %) with 0.5 % noise; 1 to 4 % (RANSAC to 3 %) with 1 %. "gable" has no tolerance to choose;
// "gable, known scale" takes the scale from the truth (see known_scales) instead of from a model.

#include <gable/engine/error.h>
#include <gable/engine/stopwatch.h>
#include <gable/grammar/random.h>
#include <gable/training/scans/cityjson_surfaces.h>
#include <gable/training/scans/sample_surface.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <utility>

#include "nearest_planes.h"
#include "plane_methods.h"
#include "plane_scores.h"

namespace gable {
namespace {

constexpr double kNoises[] = {0.0, 0.005, 0.01};
constexpr double kOutlierShare = 0.05;
constexpr int kScale = 2;  // structure

/// Means over buildings.
struct Tally {
  PlaneScores sum;
  double lowest = 1.0;  // Rand index
  double seconds = 0.0;
  int buildings = 0;

  void add(const PlaneScores& scores, double time) {
    sum.rand_index += scores.rand_index;
    sum.planes += scores.planes;
    sum.coverage += scores.coverage;
    sum.rms += scores.rms;
    lowest = std::min(lowest, scores.rand_index);
    seconds += time;
    ++buildings;
  }
  double rand_index() const { return sum.rand_index / buildings; }
};

double seconds_of(const auto& call) {
  const Stopwatch watch;
  call();
  return 1e-3 * watch.ms();
}

/// A method at one tolerance.
struct Row {
  std::string name;
  std::string setting;
  double epsilon_percent;
  Tally tally;
};

void print(const Row& row, bool is_best) {
  const Tally& t = row.tally;
  const double n = t.buildings;
  std::printf(
      "%c %-22s %-5s %5.2f %%  ARI %6.4f (lowest %6.4f)  planes %6.1f  coverage %5.1f %%  "
      "RMS %6.4f %%  %6.2f s\n",
      is_best ? '*' : ' ', row.name.c_str(), row.setting.c_str(), row.epsilon_percent,
      t.rand_index(), t.lowest, t.sum.planes / n, 100.0 * t.sum.coverage / n, 100.0 * t.sum.rms / n,
      t.seconds / n);
}

/// A row is the best of its method.
bool is_best(const std::vector<Row>& rows, const Row& row) {
  return std::none_of(rows.begin(), rows.end(), [&](const Row& other) {
    return other.name == row.name && other.tally.rand_index() > row.tally.rand_index();
  });
}

std::vector<BuildingSurface> choose(CityJsonSurfaces surfaces, int count, uint64_t seed) {
  std::vector<BuildingSurface>& buildings = surfaces.buildings;
  std::printf("%d buildings with both levels of detail, %d with too few planes, %d invalid\n",
              surfaces.with_both_levels, surfaces.too_simple, surfaces.invalid);
  Random random(seed);
  for (size_t i = buildings.size(); i > 1; --i) {
    std::swap(buildings[i - 1], buildings[random.integer(0, static_cast<int>(i) - 1)]);
  }
  buildings.resize(std::min(buildings.size(), static_cast<size_t>(count)));
  return std::move(buildings);
}

std::vector<Row> empty_rows(const std::vector<PlaneMethod>& methods) {
  std::vector<Row> rows = {{"nearest true plane", "", 0.0, {}}};
  for (const PlaneMethod& method : methods) {
    for (const double epsilon : method.epsilons_percent) {
      rows.push_back({method.name, method.setting, epsilon, {}});
    }
  }
  return rows;
}

void measure(const BuildingSurface& building, const SampleOptions& options,
             const std::vector<PlaneMethod>& methods, std::vector<Row>* rows) {
  Scan scan = sample_surface(building.surface, options);
  const std::vector<int> truth = scan.labels.at("scale_" + std::to_string(kScale));
  Eigen::AlignedBox<double, 3> box;
  for (const Eigen::Vector3d& point : scan.points) box.extend(point);
  auto row = rows->begin();
  const auto tally = [&](const std::vector<int>& planes, double seconds) {
    row++->tally.add(score_planes(scan.points, truth, planes), seconds);
  };
  std::vector<int> planes;
  const double nearest_seconds =
      seconds_of([&] { planes = nearest_planes(building.surface, kScale - 1, scan.points); });
  tally(planes, nearest_seconds);
  for (const PlaneMethod& method : methods) {
    scan.normals.clear();
    const double preparing = method.prepare ? seconds_of([&] { method.prepare(&scan); }) : 0.0;
    for (const double percent : method.epsilons_percent) {
      const double epsilon = percent / 100.0 * box.diagonal().norm();
      const double seconds = seconds_of([&] { planes = method.detect(scan, epsilon); });
      tally(planes, preparing + seconds);
    }
  }
}

void run(int count, uint64_t seed, int num_points, const std::string& path,
         const CityJsonSurfaceOptions& truth) {
  const std::vector<BuildingSurface> buildings =
      choose(read_cityjson_surfaces(path, truth), count, seed);
  double true_planes = 0.0;
  for (const BuildingSurface& building : buildings) true_planes += building.num_planes[kScale - 1];
  std::printf("%zu buildings, seed %llu, %d points each, %.0f %% outliers, %.1f true planes\n",
              buildings.size(), static_cast<unsigned long long>(seed), num_points,
              100.0 * kOutlierShare, true_planes / buildings.size());
  for (const double noise : kNoises) {
    const std::vector<PlaneMethod> methods = plane_methods(noise);
    std::vector<Row> rows = empty_rows(methods);
    for (size_t i = 0; i < buildings.size(); ++i) {
      SampleOptions options;
      options.num_points = num_points;
      options.noise = noise;
      options.outlier_share = kOutlierShare;
      options.seed = seed + i;
      measure(buildings[i], options, methods, &rows);
    }
    std::printf("noise %.1f %% (* the best of its method)\n", 100.0 * noise);
    for (const Row& row : rows) print(row, is_best(rows, row));
    std::fflush(stdout);
  }
}

}  // namespace
}  // namespace gable

int main(int argc, char** argv) {
  const char* data = std::getenv("GABLE_DATA");
  const std::string folder = data ? data : GABLE_SOURCE_DIR "/../shared/data";
  const std::string model = argc > 4 ? argv[4] : folder + "/3dbag-delft/tile_5910.city.json";
  if (argc <= 4 && !std::filesystem::exists(model)) {
    std::printf("skipped: no %s; set GABLE_DATA to the folder of the data\n", model.c_str());
    return 0;
  }
  gable::CityJsonSurfaceOptions truth;
  if (argc > 5) truth.structure = {90.0, std::atof(argv[5])};
  try {
    gable::run(argc > 1 ? std::max(std::atoi(argv[1]), 1) : 50,
               argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 1,
               argc > 3 ? std::max(std::atoi(argv[3]), 1) : 143000, model, truth);
  } catch (const gable::Error& error) {
    std::fprintf(stderr, "gable_check_planes: %s\n", error.what());
    return static_cast<int>(error.code());
  }
  return 0;
}
