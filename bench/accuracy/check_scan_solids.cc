// Scans closed into solids: buildings of a city model (LoD 2.2 surfaces, what is seen from above)
// sampled with noise, their shapes at the scales that the model `buildings` finds, and each scale
// closed.
//   gable_check_scan_solids CITY_MODEL [buildings] [seed] [points per square metre] [folder]
// A row per building, noise and scale: planes, facets and triangles of the closed model; the RMS
// distance of the scan to it; that of the surface itself, sampled without noise; the volume over
// that of the surface; whether all solids are valid; seconds, of the closing alone. folder: the
// scans are written there as well, for `gable shapes`.

#include <gable/engine/closing/surface_distance.h>
#include <gable/engine/error.h>
#include <gable/engine/io/model_folder.h>
#include <gable/engine/io/shapes/labelled_ply.h>
#include <gable/engine/io/shapes/scale_model_file.h>
#include <gable/engine/reconstruct/scan/scan_solids.h>
#include <gable/engine/scales/detect_scales.h>
#include <gable/engine/stopwatch.h>
#include <gable/grammar/random.h>
#include <gable/grammar/solid/validity.h>
#include <gable/training/scans/cityjson_surfaces.h>
#include <gable/training/scans/sample_surface.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace gable {
namespace {

constexpr double kNoises[] = {0.03, 0.1};  // metres
constexpr double kSeenFromAbove = -0.2;
constexpr int kTruthPoints = 20000;

struct Extent {
  double area = 0.0;  ///< seen from above, square metres
  double diagonal = 0.0;
  double volume = 0.0;
};

Extent extent_of(const LabelledSurface& surface) {
  Extent extent;
  Eigen::AlignedBox3d box;
  for (const auto& [a, b, c] : surface.triangles) {
    const Eigen::Vector3d &p = surface.vertices[a], &q = surface.vertices[b],
                          &r = surface.vertices[c];
    const Eigen::Vector3d normal = 0.5 * (q - p).cross(r - p);
    if (normal.z() >= kSeenFromAbove * normal.norm()) extent.area += normal.norm();
    extent.volume += p.dot(normal) / 3.0;
    for (const Eigen::Vector3d& corner : {p, q, r}) box.extend(corner);
  }
  extent.diagonal = box.diagonal().norm();
  return extent;
}

Scan scan_of(const BuildingSurface& building, const Extent& extent, double noise, int num_points,
             uint64_t seed) {
  SampleOptions options;
  options.num_points = num_points;
  options.noise = noise / extent.diagonal;
  options.least_normal_z = kSeenFromAbove;
  options.seed = seed;
  Scan scan = sample_surface(building.surface, options);
  for (Eigen::Vector3d& p : scan.points) p += building.origin;
  return scan;
}

void measure(const BuildingSurface& building, const ScaleModel& model, double density,
             uint64_t seed, const std::string& folder) {
  const Extent extent = extent_of(building.surface);
  const Scan truth = scan_of(building, extent, 0.0, kTruthPoints, seed + 1);
  std::printf("%s: %d planes, %.0f m2 seen from above\n", building.id.c_str(),
              building.num_planes[0], extent.area);
  for (const double noise : kNoises) {
    const int num_points = std::max(100, static_cast<int>(density * extent.area));
    const Scan scan = scan_of(building, extent, noise, num_points, seed);
    if (!folder.empty()) {
      const std::string name =
          building.id + "-" + std::to_string(std::lround(100 * noise)) + ".ply";
      write_scan_ply((std::filesystem::path(folder) / name).string(), scan);
    }
    const DetectedScales detected = detect_scales(scan, model, {});
    const Stopwatch watch;
    const std::vector<ScanSolid> solids = close_scales(scan, detected.scales, {});
    const double seconds = 1e-3 * watch.ms();
    for (size_t k = 0; k < solids.size(); ++k) {
      const ScanSolid& solid = solids[k];
      if (!solid.reason.empty()) {
        std::printf("  %4.2f m  scale %zu  none: %s\n", noise, k + 1, solid.reason.c_str());
        continue;
      }
      double volume = 0.0, squares = 0.0;
      bool valid = true;
      for (const Solid& body : solid.solids) {
        const SolidValidity validity = check_solid(body);
        valid = valid && validity.valid();
        volume += validity.volume;
      }
      const SurfaceDistance distance(solid.solids);
      for (const Eigen::Vector3d& p : truth.points) {
        squares += std::pow(distance(p - solid.origin), 2) / static_cast<double>(kTruthPoints);
      }
      std::printf(
          "  %4.2f m  scale %zu  %3zu shapes  %3d planes  %3d facets  %4d triangles  RMS %.3f m  "
          "of the surface %.3f m  volume %.3f  %s\n",
          noise, k + 1, detected.scales[k].shapes.size(), solid.planes, solid.facets,
          solid.triangles, solid.rms, std::sqrt(squares), volume / extent.volume,
          valid ? "valid" : "INVALID");
    }
    std::printf("  %4.2f m  all scales closed in %.2f s\n", noise, seconds);
  }
}

void run(const std::string& path, int count, uint64_t seed, double density,
         const std::string& folder) {
  const ScaleModel model = read_scale_model(find_scale_model("buildings"));
  std::vector<BuildingSurface> buildings = read_cityjson_surfaces(path).buildings;
  Random random(seed);
  for (size_t i = buildings.size(); i > 1; --i) {
    std::swap(buildings[i - 1], buildings[random.integer(0, static_cast<int>(i) - 1)]);
  }
  buildings.resize(std::min(buildings.size(), static_cast<size_t>(std::max(0, count))));
  if (!folder.empty()) std::filesystem::create_directories(folder);
  for (const BuildingSurface& building : buildings) {
    measure(building, model, density, seed, folder);
  }
}

}  // namespace
}  // namespace gable

int main(int argc, char** argv) {
  if (argc < 2) {
    std::fprintf(stderr,
                 "gable_check_scan_solids CITY_MODEL [buildings] [seed] [points per square metre] "
                 "[folder]\n");
    return 2;
  }
  try {
    gable::run(argv[1], argc > 2 ? std::atoi(argv[2]) : 3,
               argc > 3 ? std::strtoull(argv[3], nullptr, 10) : 1,
               argc > 4 ? std::atof(argv[4]) : 20.0, argc > 5 ? argv[5] : "");
  } catch (const gable::Error& error) {
    std::fprintf(stderr, "gable_check_scan_solids: %s\n", error.what());
    return static_cast<int>(error.code());
  }
  return 0;
}
