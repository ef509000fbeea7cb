#include "examples/cli/shapes_solids.h"

#include <gable/engine/error.h>
#include <gable/engine/io/atomic_file.h>
#include <gable/engine/io/models/obj_writer.h>
#include <gable/engine/io/number_text.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>

namespace gable {
namespace {

std::string solid_name(size_t scale) { return "solid-" + std::to_string(scale + 1) + ".obj"; }

void write_solid(const std::string& path, size_t scale, const ScanSolid& solid) {
  Building building;
  building.id = "scale-" + std::to_string(scale + 1);
  BuildingModel model;
  model.origin = solid.origin;
  for (size_t i = 0; i < solid.solids.size(); ++i) {
    model.parts.push_back({PartRole::kMain, 0, static_cast<int>(i), {{Lod::k22, solid.solids[i]}}});
  }
  ModelWriterOptions options;
  // Small coordinates are kept as they are, large ones relative to a local origin.
  if (solid.origin.cwiseAbs().maxCoeff() > 1e4) options.anchor = solid.origin;
  ObjWriter writer(path, options);
  writer.append(building, model);
  writer.close();
}

void append_member(const char* name, double value, std::string* text) {
  *text += std::string(", \"") + name + "\": ";
  append_number(value, text);
}

}  // namespace

std::vector<ScanSolid> close_detected_scales(const std::string& scan_name, const Scan& scan,
                                             const DetectedScales& detected) {
  std::vector<ScanSolid> solids = close_scales(scan, detected.scales, {});
  const bool any = std::any_of(solids.begin(), solids.end(),
                               [](const ScanSolid& solid) { return solid.reason.empty(); });
  if (!any) {
    throw Error(ExitCode::kBadInput,
                scan_name + ": no scale can be closed into a solid: " +
                    (solids.empty() ? "there are no scales" : solids.back().reason));
  }
  return solids;
}

void write_solids(const std::string& folder, const std::vector<ScanSolid>& solids,
                  double diagonal) {
  namespace fs = std::filesystem;
  std::string text = "{\"solids\": [";
  for (size_t i = 0; i < solids.size(); ++i) {
    const ScanSolid& solid = solids[i];
    text += std::string(i > 0 ? ",\n" : "\n") + "{\"scale\": " + std::to_string(i + 1);
    if (!solid.reason.empty()) {
      text += ", \"file\": null, \"reason\": \"" + solid.reason + "\"}";
      continue;
    }
    write_solid((fs::path(folder) / solid_name(i)).string(), i, solid);
    text += ", \"file\": \"" + solid_name(i) + "\"";
    append_member("shapes_of_scale", solid.scale + 1, &text);
    append_member("planes", solid.planes, &text);
    append_member("facets", solid.facets, &text);
    append_member("triangles", solid.triangles, &text);
    append_member("rms", solid.rms, &text);
    append_member("mean", solid.mean, &text);
    append_member("rms_percent", diagonal > 0.0 ? 100.0 * solid.rms / diagonal : 0.0, &text);
    text += "}";
  }
  write_file_atomically((fs::path(folder) / "solids.json").string(), text + "\n]}\n");
}

std::string solids_table(const std::vector<ScanSolid>& solids, double diagonal) {
  std::string table = "solid  scale  planes  facets  triangles      RMS m    RMS %     mean m\n";
  for (size_t i = 0; i < solids.size(); ++i) {
    const ScanSolid& solid = solids[i];
    char line[160];
    if (!solid.reason.empty()) {
      table += "    " + std::to_string(i + 1) + "  none: " + solid.reason + "\n";
      continue;
    }
    std::snprintf(line, sizeof(line), "%5zu  %5d  %6d  %6d  %9d  %9.4g  %7.4f  %9.4g\n", i + 1,
                  solid.scale + 1, solid.planes, solid.facets, solid.triangles, solid.rms,
                  diagonal > 0.0 ? 100.0 * solid.rms / diagonal : 0.0, solid.mean);
    table += line;
  }
  return table;
}

}  // namespace gable
