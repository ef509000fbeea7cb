#pragma once

#include <gable/engine/closing/plan_lines.h>
#include <gable/residuals/height_image.h>

#include <string>
#include <vector>

namespace gable {

/// How rows of houses that hang together are cut into pieces of few blocks.
struct RowCutOptions {
  /// What covers no more than this is one house and left whole, square metres, [20, 1e6]. The
  /// largest houses of the prior (docs/prior.md) cover 260.
  double least_row = 300.0;
  /// Pieces of a row are cut again until they cover no more than this, square metres, [20, 1e6].
  double most_area = 150.0;
  /// A cut leaves no piece smaller than this, square metres, [0, 1000].
  double least_part = 16.0;
  /// Houses of a row meet at seams: where heights of two neighbouring pixels differ by this more
  /// than the roofs on either side slope, and in valleys this much lower than the roofs to both
  /// sides, metres, (0, 10].
  double step = 0.5;
  /// What a wall along a seam costs, as a share of one through a roof, [0, 1].
  double seam_price = 0.2;
  /// By how much dearer a wall halfway between the axes that the roofs of a piece agree on is, as a
  /// share, [0, 100]: blocks can end along their axes only.
  double oblique_price = 2.0;
  /// Pieces that fill this share of their smallest rectangle, (0, 1],
  double fill = 0.85;
  /// and have no more than this share of their pixels at seams are one building whatever its size,
  /// [0, 1].
  double seams = 0.03;
  int directions = 36;  ///< of cuts that are tried, [2, 360]
};

/// Empty if the options are in range; otherwise names the violated bound.
std::string check(const RowCutOptions& options);

/// A row as the pieces that it is cut into.
struct RowPieces {
  std::vector<int> piece;  ///< of every pixel, -1 outside, numbered by their first pixels
  /// The lines that a piece was cut along, by piece: its signed distance to them is negative. The
  /// image's frame. Those that crumbs of the piece lie beyond are left out.
  std::vector<std::vector<PlanLine>> cuts;
};

/// Cuts the inside pixels of an image along straight lines, again and again, until every piece is
/// no larger than `most_area` or looks like one building. Each cut is the line of least ratio of
/// the wall that would stand there (its length times the height above the terrain of its lower
/// side, less along seams, more across the roofs' axes) to the area of the smaller side: the ratio
/// cut of image segmentation (Wang and Siskind, PAMI 2003) with lines for curves. What a cut leaves
/// in crumbs goes to the piece that it touches most.
RowPieces cut_rows(const HeightImage& image, const RowCutOptions& options);

}  // namespace gable
