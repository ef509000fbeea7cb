#pragma once

#include <gable/training/scans/coplanar_faces.h>
#include <gable/training/scans/labelled_surface.h>

#include <Eigen/Core>
#include <array>
#include <string>
#include <vector>

namespace gable {

/// Which levels of a city model are which structural scales, and which of its buildings to keep.
struct CityJsonSurfaceOptions {
  std::string detail_level = "2.2";  ///< the surface, and its planes at scales 1 and 2
  std::string hull_level = "1.2";    ///< the planes at scale 3
  CoplanarTolerance coplanar;        ///< which polygons are one plane at scale 1 and in the hull
  CoplanarTolerance structure;       ///< which polygons are one plane at scale 2
  int least_planes = 5;              ///< at scale 2, >= 1
};

/// A building as a surface whose triangles know their planes.
struct BuildingSurface {
  std::string id;
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();  ///< of the surface's frame, in the file's CRS
  LabelledSurface surface;
  std::array<int, kNumKnownScales> num_planes{};  ///< per scale, from the finest
};

struct CityJsonSurfaces {
  std::vector<BuildingSurface> buildings;  ///< in the order of the file
  int with_both_levels = 0;                ///< objects that have both levels of detail
  int too_simple = 0;                      ///< left out: fewer than the least planes
  int invalid = 0;  ///< left out: the boundary is not closed or not outward, or a polygon is bent
};

/// The buildings of a city model, from the solids of two of its levels of detail. A triangle's
/// plane at scales 1 and 2 is the plane of its polygon (touching coplanar polygons have one); at
/// scale 3 the plane of the hull level's face that stands for it (see HullFaces). Throws Error as
/// `read_cityjson_solids`; kBadInput also where no building has both levels.
CityJsonSurfaces read_cityjson_surfaces(const std::string& path,
                                        const CityJsonSurfaceOptions& options = {});

}  // namespace gable
