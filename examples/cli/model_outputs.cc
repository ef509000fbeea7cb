#include "examples/cli/model_outputs.h"

#include <gable/engine/error.h>

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
      ->add_option("--report", options->report,
                   "Folder for a page with a picture of every building")
      ->type_name("DIR");
  command->add_flag("--times", options->times,
                    "Write the time spent on each building (gable_time_ms, milliseconds); "
                    "without it the same input gives the same bytes");
}

ModelOutputs::ModelOutputs(const OutputOptions& options, const ModelWriterOptions& writer_options)
    : times_(options.times) {
  require_kind(options.models, "-o", {".jsonl", ".json"});
  if (!options.obj.empty()) require_kind(options.obj, "--obj", {".obj"});
  if (!options.glb.empty()) require_kind(options.glb, "--glb", {".glb"});
  for (const std::string& path : {options.obj, options.glb, options.models}) {
    if (!path.empty()) writers_.push_back(open_model_writer(path, writer_options));
  }
  if (!options.report.empty()) report_ = std::make_unique<ReportWriter>(options.report);
}

void ModelOutputs::draw(size_t index, const Building& building, const HeightImage& image) {
  if (!report_) return;
  Building shown = building;
  if (!times_) shown.quality.time_ms = -1.0;
  report_->add(index, shown, image);
}

void ModelOutputs::append(Building building, const BuildingModel& model) {
  if (!times_) building.quality.time_ms = -1.0;
  for (const auto& writer : writers_) writer->append(building, model);
}

void ModelOutputs::close() {
  if (report_) report_->finish();
  for (const auto& writer : writers_) writer->close();
}

}  // namespace gable
