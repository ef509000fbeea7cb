#pragma once

#include <gable/engine/io/models/building.h>
#include <gable/engine/io/windows/window_folder.h>
#include <gable/engine/reconstruct/tile/reconstruct_tile.h>

#include <CLI/CLI.hpp>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "examples/cli/model_outputs.h"
#include "examples/cli/tile_files.h"

namespace gable {

/// Whether -o names a folder of models: it ends with '/', is a folder, or has no extension.
bool names_a_folder(const std::string& models);

/// The files that the models of a folder are made of. Throws Error (kNoInput).
std::vector<ManifestInput> manifest_inputs(const TileFileOptions& options, const TileFiles& files,
                                           const std::string& filter, const std::string& detectors);

/// The options of a command as they were given or are set unless given, but for those that name
/// inputs or that do not change the models.
std::vector<std::pair<std::string, std::string>> manifest_options(const CLI::App& command);

/// Models by window: -o DIR.
class WindowOutputs {
 public:
  /// Throws Error: kUsage for outputs that there are for single files only, otherwise as
  /// WindowFolder.
  WindowOutputs(const OutputOptions& options, bool resume, const std::vector<TileWindow>& windows,
                WindowManifest manifest, const ModelWriterOptions& writer_options);

  size_t num_windows() const { return folder_.manifest().windows.size(); }
  size_t num_done() const;

  /// Has the windows that are missing made, and takes note of what is in them.
  void follow(TileCallbacks* callbacks);
  /// Writes the building; in order.
  void append(Building building, const BuildingModel& model);

  /// Of all windows that are done, those of earlier runs among them.
  TileSummary summary() const;
  size_t num_of(BuildingStatus status) const;

 private:
  const bool times_;
  WindowFolder folder_;
  size_t window_ = 0;  ///< that is being worked on
};

}  // namespace gable
