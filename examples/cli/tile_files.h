#pragma once

#include <gable/engine/io/footprint_file.h>
#include <gable/engine/io/raster_file.h>
#include <gable/engine/reconstruct/reconstruct_tile.h>

#include <CLI/CLI.hpp>
#include <functional>
#include <optional>
#include <string>

namespace gable {

/// The files that describe a tile.
struct TileFileOptions {
  std::string dsm, dtm, footprints, crs;
};

/// Adds DSM, --dtm, --footprints and --crs to a command. Returns --footprints, for options that
/// exclude it.
CLI::Option* add_tile_file_options(CLI::App* command, TileFileOptions* options);

/// The opened files of a tile. Notes on derived terrain and on skipped, repaired and outside
/// footprints go to `say`. Errors name the file.
class TileFiles {
 public:
  TileFiles(const TileFileOptions& options, const std::function<void(const std::string&)>& say);
  TileFiles(const TileFiles&) = delete;
  TileFiles& operator=(const TileFiles&) = delete;

  const RasterFile& dsm() const { return dsm_; }
  /// Points into this object.
  TileInput input() const;
  /// Reads more polygons for the same tile.
  FootprintFile read_polygons(const std::string& path) const;

 private:
  TileFileOptions options_;
  std::function<void(const std::string&)> say_;
  RasterFile dsm_;
  std::optional<RasterFile> dtm_;
  std::optional<FootprintFile> footprints_;
};

}  // namespace gable
