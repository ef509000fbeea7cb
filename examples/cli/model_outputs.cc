#include "examples/cli/model_outputs.h"

#include <gable/engine/error.h>
#include <gable/engine/io/models/add_roof_slabs.h>
#include <gable/grammar/block.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace gable {
namespace {

void require_kind(const std::string& path, const std::string& option,
                  const std::vector<std::string>& ends) {
  std::string known;
  for (const std::string& end : ends) {
    if (path.ends_with(end)) return;
    known += (known.empty() ? "" : " or ") + end;
  }
  throw Error(ExitCode::kUsage, option + " " + path + ": end the name with " + known);
}

}  // namespace

void add_output_options(CLI::App* command, OutputOptions* options) {
  command
      ->add_option("-o,--output", options->models,
                   "Models: .city.jsonl (CityJSONSeq) or .city.json (CityJSON)")
      ->type_name("FILE")
      ->required();
  command->add_option("--obj", options->obj, "Wavefront OBJ as well: local origin, Z up")
      ->type_name("FILE");
  command->add_option("--glb", options->glb, "Binary glTF as well")->type_name("FILE");
  command
      ->add_option("--kml", options->kml,
                   "For globe viewers as well, in 3D: .kml, or .kmz, which is smaller")
      ->type_name("FILE");
  command->add_flag("--kml-on-terrain", options->kml_on_terrain,
                    "In the KML, heights above the viewer's own terrain instead of the raster's "
                    "heights above sea level");
  command
      ->add_option("--gpkg", options->gpkg,
                   "GeoPackage as well: plans with all attributes, and roofs with slope, aspect "
                   "and area")
      ->type_name("FILE");
  command
      ->add_option("--thickness", options->slabs.thickness,
                   "Thickness of roofs, measured vertically: 0, or 0.05 to 1 m; their upper side "
                   "stays where it is")
      ->type_name("METRES")
      ->capture_default_str();
  command
      ->add_option("--overhang", options->slabs.overhang,
                   "By how much roofs reach beyond the walls, horizontally, 0 to 1 m; needs "
                   "--thickness")
      ->type_name("METRES")
      ->capture_default_str();
  command
      ->add_option("--report", options->report,
                   "Folder for a page with a picture of every building")
      ->type_name("DIR");
  command->add_flag("--times", options->times,
                    "Write the time spent on each building (gable_time_ms, milliseconds); "
                    "without it the same input gives the same bytes");
}

ModelOutputs::ModelOutputs(const OutputOptions& options, const ModelWriterOptions& writer_options)
    : times_(options.times), slabs_(options.slabs) {
  require_kind(options.models, "-o", {".jsonl", ".json"});
  if (!options.obj.empty()) require_kind(options.obj, "--obj", {".obj"});
  if (!options.glb.empty()) require_kind(options.glb, "--glb", {".glb"});
  if (!options.kml.empty()) require_kind(options.kml, "--kml", {".kml", ".kmz"});
  if (!options.gpkg.empty()) require_kind(options.gpkg, "--gpkg", {".gpkg"});
  if (const std::string error = check(slabs_); !error.empty()) {
    throw Error(ExitCode::kUsage, "--thickness, --overhang: " + error);
  }
  ModelWriterOptions all = writer_options;
  all.kml_on_terrain = options.kml_on_terrain;
  for (const std::string& path :
       {options.obj, options.glb, options.kml, options.gpkg, options.models}) {
    if (!path.empty()) writers_.push_back(open_model_writer(path, all));
  }
  if (!options.report.empty()) report_ = std::make_unique<ReportWriter>(options.report);
}

void ModelOutputs::draw(size_t index, const Building& building, const HeightImage& image) {
  if (!report_) return;
  Building shown = building;
  if (!times_) shown.quality.time_ms = -1.0;
  report_->add(index, shown, image);
}

void ModelOutputs::append(Building building, BuildingModel model) {
  if (!times_) building.quality.time_ms = -1.0;
  if (slabs_.wanted()) add_roof_slabs(slabs_, neighbours_of(building), &building, &model);
  for (const auto& writer : writers_) writer->append(building, model);
}

void ModelOutputs::set_outlines(const std::vector<Footprint>& outlines) {
  outlines_ = &outlines;
  outline_boxes_.clear();
  for (const Footprint& outline : outlines) {
    Eigen::AlignedBox2d& box = outline_boxes_.emplace_back();
    for (const Eigen::Vector2d& p : outline.polygon.outer) box.extend(p);
  }
}

std::vector<PlanPolygon> ModelOutputs::neighbours_of(const Building& building) const {
  std::vector<PlanPolygon> neighbours;
  if (!outlines_ || !building.house) return neighbours;
  // A circle that no overhang leaves.
  double reach = 0.0;
  for (const Block<double>& block : expand_blocks(*building.house)) {
    using namespace block_value;
    const double x = std::max(std::abs(block[kX0]), std::abs(block[kX1]));
    const double y = std::max(std::abs(block[kY0]), std::abs(block[kY1]));
    reach = std::max(reach, std::hypot(x, y));
  }
  reach += 2.0 * slabs_.overhang;
  const Eigen::Vector2d center = building.house->origin.head<2>();
  for (size_t i = 0; i < outlines_->size(); ++i) {
    const Footprint& outline = (*outlines_)[i];
    if (outline_boxes_[i].exteriorDistance(center) < reach && outline.id != building.id) {
      neighbours.push_back(outline.polygon);
    }
  }
  return neighbours;
}

void ModelOutputs::close() {
  if (report_) report_->finish();
  for (const auto& writer : writers_) writer->close();
}

}  // namespace gable
