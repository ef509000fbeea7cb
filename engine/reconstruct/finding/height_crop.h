#pragma once

#include <gable/engine/reconstruct/finding/find_houses.h>
#include <gable/engine/reconstruct/finding/vegetation.h>
#include <gable/grammar/raster.h>
#include <gable/residuals/height_image.h>

#include <cstdint>
#include <optional>
#include <vector>

namespace gable {

/// What a cell is to the building that a crop is made for.
enum class CellRole : uint8_t {
  kOpen,       ///< of no building
  kBuilding,   ///< its own
  kNeighbour,  ///< of another building, or of something else that stands there
  kRow,        ///< of another piece of the row that it was cut from
  kCrown,      ///< a tree crown
  kCovered,    ///< its own, under a tree crown
};

/// How crops are made.
struct HeightCropOptions {
  double margin = 3.5;    ///< of terrain around the building's cells, metres, [0, 100]
  int max_cells = 40000;  ///< larger crops are thinned by a whole factor, [100, 1e8]
  /// Weight of a neighbour's cells where the outline is known, [0, 0.1); see `is_taken`.
  double neighbour = 0.05;
  /// Weight of the cells of other pieces of a row, [0, 1]: they are not its own, but where it ends
  /// between them is known to a cell only.
  double row = 0.15;
  /// Weight of open cells where the outline is known, [0.1, 1]: the building ends at it in any
  /// case.
  double outside = 0.2;
  /// HeightImage::spread of the crops, metres, [0, 100]. Unset: where whole tiles are worked on,
  /// what the walls of the surface tell (`tile_spread`); otherwise 0.
  std::optional<double> spread;
};

/// Empty if the options are in range; otherwise names the violated bound.
std::string check(const HeightCropOptions& options);

/// The cells of `grid` around a box with a margin, cut at the grid's edge; the result's cells are
/// cells of `grid`.
CellBox with_margin(const CellBox& box, double margin, const Grid& grid);

/// Cuts the height image of one building out of `dsm` and `dtm` (one grid, NaN where there is no
/// height; `dtm` without NaN). `roles` holds the cells of `box`, row by row. The origin is the
/// box's centre at the median terrain under the building.
///
/// Where the building was found in the heights, neighbours (and cells beside them) and crowns are
/// left out; cells of other pieces of its row become ground. Where its outline is known, it ends
/// there whatever stands beyond: open and neighbours' cells get the terrain's height, neighbours'
/// with a small weight since they are no evidence of terrain. Its own covered cells are inside and
/// left out.
HeightImage crop_heights(const HeightRaster& dsm, const HeightRaster& dtm, const CellBox& box,
                         const std::vector<CellRole>& roles, bool outline_known,
                         const HeightCropOptions& options);

/// Whether a pixel of a crop is known to be another building's, or nothing is known of it: crops
/// weigh these less than open ground.
inline bool is_taken(const HeightImage& image, size_t pixel) { return image.weight[pixel] < 0.1f; }

/// Expresses an image relative to another origin; the world points of its pixels stay.
void move_origin(const Eigen::Vector3d& origin, HeightImage* image);

}  // namespace gable
