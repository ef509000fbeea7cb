#pragma once

#include <gable/engine/io/building.h>
#include <gable/engine/io/model_writer.h>
#include <gable/engine/reconstruct/report/report_writer.h>
#include <gable/residuals/height_image.h>

#include <CLI/CLI.hpp>
#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace gable {

/// Where models are written.
struct OutputOptions {
  std::string models, obj, glb, report;
  bool times = false;  ///< write gable_time_ms
};

/// Adds -o, --obj, --glb, --report and --times to a command.
void add_output_options(CLI::App* command, OutputOptions* options);

/// The files that models go to. They appear under their names at `close`; destroyed before that,
/// they leave nothing.
class ModelOutputs {
 public:
  /// Tries all outputs at once. Throws Error: kUsage for a name of an unknown kind, kCannotWrite.
  ModelOutputs(const OutputOptions& options, const ModelWriterOptions& writer_options);

  /// Draws the building's picture where there is a report; from any thread.
  void draw(size_t index, const Building& building, const HeightImage& image);
  /// Writes the building; in order.
  void append(Building building, const BuildingModel& model);
  /// The models last: where they are, everything is.
  void close();

 private:
  bool times_;
  std::vector<std::unique_ptr<ModelWriter>> writers_;
  std::unique_ptr<ReportWriter> report_;
};

}  // namespace gable
