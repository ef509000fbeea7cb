#pragma once

#include <gable/engine/io/footprint_writer.h>
#include <gable/engine/io/models/building.h>
#include <gable/engine/io/models/model_writer.h>
#include <gable/engine/reconstruct/report/report_writer.h>
#include <gable/grammar/solid/roof_slabs.h>
#include <gable/residuals/height_image.h>

#include <CLI/CLI.hpp>
#include <Eigen/Geometry>
#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace gable {

/// Where models are written.
struct OutputOptions {
  std::string models, obj, glb, kml, gpkg, report;
  RoofSlabOptions slabs;
  bool kml_on_terrain = false;
  bool times = false;  ///< write gable_time_ms
};

/// Adds -o, --obj, --glb, --kml, --gpkg, --report, --thickness, --overhang and --times to a
/// command.
void add_output_options(CLI::App* command, OutputOptions* options);

/// The files that models go to. They appear under their names at `close`; destroyed before that,
/// they leave nothing.
class ModelOutputs {
 public:
  /// Tries all outputs at once. Throws Error: kUsage for a name of an unknown kind or roof slabs
  /// out of range, kCannotWrite.
  ModelOutputs(const OutputOptions& options, const ModelWriterOptions& writer_options);

  /// Overhangs of roofs end at these outlines where they are not the building's own (by its id).
  /// Kept by reference. Without them overhangs reach across party walls.
  void set_outlines(const std::vector<Footprint>& outlines);

  /// Draws the building's picture where there is a report; from any thread.
  void draw(size_t index, const Building& building, const HeightImage& image);
  /// Writes the building; in order.
  void append(Building building, BuildingModel model);
  /// The models last: where they are, everything is.
  void close();

 private:
  std::vector<PlanPolygon> neighbours_of(const Building& building) const;

  bool times_;
  RoofSlabOptions slabs_;
  const std::vector<Footprint>* outlines_ = nullptr;
  std::vector<Eigen::AlignedBox2d> outline_boxes_;
  std::vector<std::unique_ptr<ModelWriter>> writers_;
  std::unique_ptr<ReportWriter> report_;
};

}  // namespace gable
