#pragma once

#include <gable/grammar/house.h>
#include <gable/grammar/raster.h>
#include <gable/grammar/solid/extrusion.h>
#include <gable/grammar/synthesis/survey/lidar.h>

#include <cstdint>
#include <string>
#include <vector>

namespace gable {

struct TerraceOptions {
  int count = 5;  ///< houses, >= 1
  uint64_t seed = 1;
  double gsd = 0.5;      ///< metres, in [0.1, 2]
  double margin = 12.0;  ///< ground around the houses, metres, >= 0
  LidarOptions lidar;

  /// Empty, or one line that names the bound that does not hold.
  std::string check() const;
};

/// A surveyed row of houses that share party walls, and its truth.
struct Terrace {
  std::vector<House> houses;            ///< along the row, each with party walls to the next
  std::vector<PlanPolygon> footprints;  ///< world, garages included
  HeightRaster dsm;                     ///< surveyed, with noise
  HeightRaster dtm;                     ///< level ground at 0
};

/// One row house (foundation I or, one in three, II) over and over, each with details of its own
/// and, against the one before, on the same level (half of them), a little (U(0.1, 0.6) m) or much
/// (2.5 m at most) higher or lower, and in line with it (six in ten) or set back or forward by 0.3
/// to 1.5 m. The same options give the same terrace, bit for bit.
Terrace make_terrace(const TerraceOptions& options);

}  // namespace gable
