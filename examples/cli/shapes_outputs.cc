#include "examples/cli/shapes_outputs.h"

#include <gable/engine/io/shapes/labelled_ply.h>
#include <gable/engine/io/shapes/polygon_obj.h>
#include <gable/engine/io/shapes/shapes_json.h>
#include <gable/engine/io/shapes/trajectory_json.h>

#include <charconv>
#include <cstdio>
#include <filesystem>
#include <system_error>
#include <vector>

namespace gable {

namespace fs = std::filesystem;

void write_scales(const std::string& folder, const Scan& scan, const DetectedScales& detected) {
  int number = 0;
  for (const ScaleShapes& scale : detected.scales) {
    const std::string stem = (fs::path(folder) / ("scale-" + std::to_string(++number))).string();
    write_labelled_ply(stem + ".ply", scan, scale.shape_of);
    write_shapes_json(stem + ".json", scale);
    write_polygon_obj(stem + ".obj", scale);
  }
  write_trajectory_json((fs::path(folder) / "trajectory.json").string(),
                        {detected.first_shapes, detected.trajectory, detected.labels});
}

int scale_number(const std::string& name, const std::string& extension) {
  constexpr std::string_view kPrefix = "scale-";
  if (!name.starts_with(kPrefix) || !name.ends_with(extension)) return 0;
  const char* end = name.data() + name.size() - extension.size();
  int number = 0;
  const auto [rest, error] = std::from_chars(name.data() + kPrefix.size(), end, number);
  return error == std::errc() && rest == end && number > 0 ? number : 0;
}

void remove_further_scales(const std::string& folder, int num_scales) {
  std::error_code ignored;
  std::vector<fs::path> further;
  for (const auto& entry : fs::directory_iterator(folder, ignored)) {
    for (const char* extension : {".ply", ".json", ".obj"}) {
      if (scale_number(entry.path().filename().string(), extension) > num_scales) {
        further.push_back(entry.path());
      }
    }
  }
  for (const fs::path& file : further) fs::remove(file, ignored);
}

std::string scales_table(const DetectedScales& detected) {
  std::string table = "scale  planes  coverage %      RMS m    RMS %  configuration\n";
  const double diagonal = detected.first_shapes.diagonal;
  int number = 0;
  for (const ScaleShapes& scale : detected.scales) {
    char line[128];
    std::snprintf(line, sizeof(line), "%5d  %6zu  %10.2f  %9.4g  %7.4f  %13d\n", ++number,
                  scale.shapes.size(), 100.0 * scale.coverage, scale.rms,
                  diagonal > 0.0 ? 100.0 * scale.rms / diagonal : 0.0, scale.configuration);
    table += line;
  }
  return table;
}

}  // namespace gable
