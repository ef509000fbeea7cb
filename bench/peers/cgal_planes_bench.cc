#include <benchmark/benchmark.h>

#include <Eigen/Geometry>
#include <algorithm>

#include "../scan_scene.h"
#include "cgal_planes.h"

namespace gable {
namespace {

double diagonal_of(const Scan& scan) {
  Eigen::AlignedBox<double, 3> box;
  for (const Eigen::Vector3d& point : scan.points) box.extend(point);
  return box.diagonal().norm();
}

using Detector = std::vector<int>(const std::vector<Eigen::Vector3d>&,
                                  const std::vector<Eigen::Vector3d>&, const CgalPlaneOptions&);

/// One detection at a tolerance of 1 % of the diagonal; the normals are not timed.
void run(benchmark::State& state, Detector* detector) {
  const Scan scan = make_scan_scene(static_cast<int>(state.range(0)));
  const std::vector<Eigen::Vector3d> normals = cgal_normals(scan.points, 20);
  CgalPlaneOptions options;
  options.epsilon = 0.01 * diagonal_of(scan);
  int planes = 0;
  for (auto _ : state) {
    const std::vector<int> plane_of = detector(scan.points, normals, options);
    planes = *std::max_element(plane_of.begin(), plane_of.end()) + 1;
  }
  state.counters["planes"] = planes;
}

void BM_CgalNormals(benchmark::State& state) {
  const Scan scan = make_scan_scene(static_cast<int>(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(cgal_normals(scan.points, 20));
}
void BM_CgalRegionGrowing(benchmark::State& state) { run(state, cgal_region_growing); }
void BM_CgalEfficientRansac(benchmark::State& state) { run(state, cgal_efficient_ransac); }

constexpr int kSmall = 115000, kLarge = 1150000;
BENCHMARK(BM_CgalNormals)->Arg(kSmall)->Arg(kLarge)->Unit(benchmark::kSecond)->Iterations(1);
BENCHMARK(BM_CgalRegionGrowing)->Arg(kSmall)->Arg(kLarge)->Unit(benchmark::kSecond)->Iterations(1);
BENCHMARK(BM_CgalEfficientRansac)
    ->Arg(kSmall)
    ->Arg(kLarge)
    ->Unit(benchmark::kSecond)
    ->Iterations(1);

}  // namespace
}  // namespace gable
