#pragma once

#include <gable/engine/io/raster/height_source.h>
#include <gable/engine/io/raster/scratch_heights.h>
#include <gable/engine/reconstruct/finding/find_houses.h>
#include <gable/engine/reconstruct/heights/terrain.h>

#include <optional>
#include <string>
#include <vector>

namespace gable {

/// How the terrain of a tile is made. Lengths in metres.
struct TileTerrainOptions {
  TerrainOptions terrain;
  int block_cells = 2048;  ///< it is made in blocks of at most this size, >= 1
  double margin = 100.0;   ///< and what lies around them, >= 0
  std::string scratch;     ///< folder of temporary files; empty: the system's
};

/// The terrain under a surface of any size, with a height in every cell (but where there is no
/// surface near it). A given terrain is taken as it is, its gaps filled smoothly; where it does not
/// reach, and where there is none, the terrain is derived from the surface. What is made is made
/// block by block as it is asked for and kept on disk, so that a cell has one height whichever
/// window asks for it.
class TileTerrain {
 public:
  /// `dtm` may be null. Both must outlive this.
  TileTerrain(const HeightSource& dsm, const HeightSource* dtm, const TileTerrainOptions& options);

  /// The terrain of these cells of the surface's grid. From one thread at a time. Throws Error
  /// where a file is damaged or the folder of temporary files cannot be written.
  HeightRaster read(const CellBox& box);

 private:
  HeightRaster block(const CellBox& core) const;
  HeightRaster surface(const CellBox& box) const;

  const HeightSource& dsm_;
  const HeightSource* dtm_;
  const TileTerrainOptions options_;
  const std::vector<CellBox> cores_;
  std::vector<char> made_;
  std::optional<ScratchHeights> kept_;
};

}  // namespace gable
