// The planar shapes of a point cloud or mesh at its structural scales.
#include <gable/engine/io/model_folder.h>
#include <gable/engine/io/scans/scan_file.h>
#include <gable/engine/io/shapes/scale_model_file.h>
#include <gable/engine/scales/detect_scales.h>
#include <gable/grammar/synthesis/scene.h>

#include <cstdio>

using namespace gable;

/// The cells of a surveyed house as points.
Scan sample_scan() {
  const Scene scene = make_scene(Foundation::kL, {.seed = 3, .trees = 0});
  const Grid& grid = scene.dsm.grid;
  Scan scan;
  for (int row = 0; row < grid.rows; ++row) {
    for (int col = 0; col < grid.cols; ++col) {
      const Eigen::Vector2d p = grid.center_of(row, col);
      scan.points.emplace_back(p.x(), p.y(), scene.dsm.at(row, col));
    }
  }
  return scan;
}

/// usage: 06_scales_of_a_cloud [SCAN]
int main(int argc, char** argv) {
  const Scan scan = argc > 1 ? read_scan(argv[1]) : sample_scan();
  const ScaleModel model = read_scale_model(find_scale_model("buildings"));
  const DetectedScales found = detect_scales(scan, model, {});
  std::printf("%zu elements, %d first shapes\n", scan.num_elements(), found.trajectory.num_first);
  for (const ScaleShapes& scale : found.scales) {
    std::printf("%zu shapes cover %.0f %% within %.3f m\n", scale.shapes.size(),
                100.0 * scale.coverage, scale.rms);
  }
}
