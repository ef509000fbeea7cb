#pragma once

#include <gable/engine/io/footprint_file.h>
#include <gable/engine/io/raster/height_source.h>
#include <gable/engine/reconstruct/tile/reconstruct_tile.h>

#include <CLI/CLI.hpp>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace gable {

/// The files that describe a tile, or tiles side by side.
struct TileFileOptions {
  std::string dsm, dtm, footprints, crs;
  std::vector<std::string> tiles;  ///< several surfaces in place of `dsm`: rasters or point clouds
  std::string dtm_folder;          ///< in place of `dtm`
  double gsd = 0.5;                ///< cells that point clouds are turned into, metres
  std::string scratch;             ///< folder of temporary files; empty: the system's

  std::vector<std::string> surfaces() const {
    return tiles.empty() ? std::vector<std::string>{dsm} : tiles;
  }
};

/// Adds DSM, --dtm, --footprints and --crs to a command. Returns --footprints, for options that
/// exclude it.
CLI::Option* add_tile_file_options(CLI::App* command, TileFileOptions* options);

/// The same with any number of DSM, with --dtm-dir and --gsd.
CLI::Option* add_tile_set_options(CLI::App* command, TileFileOptions* options);

/// The opened files of a tile. Notes on derived terrain, on what point clouds became and on
/// skipped, repaired and outside footprints go to `say`. Errors name the file.
class TileFiles {
 public:
  TileFiles(const TileFileOptions& options, const std::function<void(const std::string&)>& say);
  TileFiles(const TileFiles&) = delete;
  TileFiles& operator=(const TileFiles&) = delete;

  const HeightSource& dsm() const { return *dsm_; }
  /// The files that the terrain is read from; none where it is derived or made of point clouds.
  const std::vector<std::string>& terrain_files() const { return terrain_files_; }
  /// Points into this object.
  TileInput input() const;
  /// Reads more polygons for the same tile.
  FootprintFile read_polygons(const std::string& path) const;

 private:
  void open_surfaces();
  void open_terrain();

  TileFileOptions options_;
  std::function<void(const std::string&)> say_;
  std::unique_ptr<HeightSource> dsm_, dtm_;
  std::vector<std::string> terrain_files_;
  std::optional<FootprintFile> footprints_;
};

}  // namespace gable
