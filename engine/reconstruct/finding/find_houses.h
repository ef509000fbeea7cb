#pragma once

#include <gable/engine/closing/plan_lines.h>
#include <gable/engine/reconstruct/finding/vegetation.h>
#include <gable/grammar/raster.h>
#include <gable/grammar/solid/extrusion.h>

#include <string>
#include <vector>

namespace gable {

/// How houses are told from the rest (NPR section 5.1).
struct FindHousesOptions {
  double least_height = 2.0;  ///< of a house's cells over the terrain, metres, (0, 100]
  double least_area = 16.0;   ///< smaller ones are dropped, square metres, [0, 1e6]
  /// Pieces are parts of trees where the crowns around them, up to this distance, and their own
  /// parts of under 2 m width are together more than all their cells, metres, [0, 10].
  double crown_reach = 1.5;
  /// Crowns that houses surround by more than this share of their rim are clutter on roofs, [0, 1]:
  /// dormers side by side, plant, the edges of narrow roofs. 1: none is.
  double roof_rim = 0.5;
  /// Cells of crowns this near to a house are what stands at its facades, balconies, bays,
  /// creepers, and count as the house, metres, [0, 10].
  double facade = 1.0;
  VegetationOptions vegetation;
};

/// Empty if the options are in range; otherwise names the violated bound.
std::string check(const FindHousesOptions& options);

/// Cells [row0, row1) x [col0, col1) of a grid.
struct CellBox {
  int row0 = 0, col0 = 0, row1 = 0, col1 = 0;

  void add(int row, int col);
  bool empty() const { return row0 >= row1 || col0 >= col1; }
};

/// A building as the cells that it covers.
struct FoundHouse {
  CellBox box;
  int num_cells = 0;
  int row = 0;                 ///< pieces of one row have one number, others 0
  std::vector<PlanLine> cuts;  ///< of a row's piece, world; it lies on their negative sides
};

/// Buildings on a grid.
struct FoundHouses {
  static constexpr int kDropped = -1;

  /// 1 + the index of the building that a cell belongs to; kDropped: of a piece that was dropped;
  /// 0.
  Raster<int> label;
  Raster<unsigned char> crown;     ///< 1: a tree crown
  std::vector<FoundHouse> houses;  ///< in the order of their first cells, row by row
  int num_rows = 0;                ///< that were cut into pieces
  int num_small = 0;               ///< pieces dropped as too small
  int num_crown = 0;               ///< pieces dropped as parts of tree crowns
};

/// Finds houses in a surface over its terrain, both on one grid: cells higher than `least_height`
/// that are no tree crown, connected over their edges. Cells without a height belong to none.
FoundHouses find_houses(const HeightRaster& dsm, const HeightRaster& dtm,
                        const FindHousesOptions& options);

/// The paper's filter: keeps the houses that lie wholly inside the bounding box, enlarged to twice
/// its size, of at least one polygon (world coordinates). Returns how many were dropped.
int keep_near_footprints(const std::vector<PlanPolygon>& polygons, FoundHouses* found);

}  // namespace gable
