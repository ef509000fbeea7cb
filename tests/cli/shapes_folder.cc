#include "cli/shapes_folder.h"

#include <gable/engine/io/shapes/labelled_ply.h>
#include <gable/engine/io/shapes/scale_model_file.h>
#include <gable/engine/scales/detect_scales.h>
#include <gable/engine/scales/known_scales.h>
#include <gable/engine/scales/train_forest.h>

#include <algorithm>
#include <filesystem>

#include "cli/sample_house.h"

namespace gable {
namespace {

ScaleModel tiny_model() {
  std::vector<LabelledTrajectory> trajectories;
  for (const uint64_t seed : {11, 12}) {
    const Scan scan = sample_house(seed);
    const CollapsedScan collapsed = collapse_scan(scan, {});
    const ScaleLabels labels = known_scales(
        {scan.labels.at("scale_1"), scan.labels.at("scale_2"), scan.labels.at("scale_3")},
        collapsed.first_shapes, collapsed.trajectory);
    trajectories.push_back({collapsed.trajectory.features, labels.labels()});
  }
  ForestTrainingOptions options;
  options.num_trees = 10;
  ScaleModel model;
  model.name = "tiny";
  model.forest = train_forest(trajectories, 3, options);
  return model;
}

}  // namespace

ShapesFolder::ShapesFolder() {
  write_scan_ply(scan(), sample_house(1));
  write_scale_model(tiny_model(), model());
}

ProgramRun ShapesFolder::shapes(const std::string& scan,
                                const std::vector<std::string>& more) const {
  std::vector<std::string> arguments = {"shapes", scan, "--model", model(), "-o", out()};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return run_gable(arguments);
}

std::vector<std::string> ShapesFolder::files(const std::string& folder) const {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(path(folder))) {
    names.push_back(entry.path().filename().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace gable
