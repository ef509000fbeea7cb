#include <gable/engine/error.h>
#include <gable/grammar/solid/triangulate.h>
#include <gable/training/scans/cityjson_solids.h>
#include <gable/training/scans/cityjson_surfaces.h>
#include <gable/training/scans/face_plane.h>
#include <gable/training/scans/hull_faces.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

namespace gable {
namespace {

/// Corners further from their polygon's plane than this make a building invalid, metres.
constexpr double kMostBend = 0.05;

/// Every edge is used once in each direction: no holes in the boundary.
bool is_closed(const Solid& solid) {
  std::map<std::pair<int, int>, int> balance;
  for (const Face& face : solid.faces) {
    for (const std::vector<int>& ring : face.rings) {
      for (size_t i = 0; i < ring.size(); ++i) {
        const int a = ring[i], b = ring[(i + 1) % ring.size()];
        balance[std::minmax(a, b)] += a < b ? 1 : -1;
      }
    }
  }
  return std::all_of(balance.begin(), balance.end(),
                     [](const auto& edge) { return edge.second == 0; });
}

/// Closed, outward and of flat polygons.
bool is_valid(const Solid& solid) {
  if (!is_closed(solid)) return false;
  double volume = 0.0;
  for (const Face& face : solid.faces) {
    const FacePlane plane = face_plane(solid, face);
    volume += plane.offset * plane.area / 3.0;
    for (const std::vector<int>& ring : face.rings) {
      for (const int corner : ring) {
        if (std::abs(plane.distance(solid.vertices[corner])) > kMostBend) return false;
      }
    }
  }
  return volume > 0.0;
}

/// Gives numbers from 0 to whatever comes, in the order in which it comes.
class Numbering {
 public:
  int operator()(int key) {
    return numbers_.emplace(key, static_cast<int>(numbers_.size())).first->second;
  }
  int size() const { return static_cast<int>(numbers_.size()); }

 private:
  std::map<int, int> numbers_;
};

BuildingSurface building_surface(const CityJsonObject& object, const Solid& detail,
                                 const Solid& hull, const CityJsonSurfaceOptions& options) {
  const std::vector<int> detail_plane = coplanar_faces(detail, options.coplanar);
  const std::vector<int> structure_plane = coplanar_faces(detail, options.structure);
  const std::vector<int> hull_plane = coplanar_faces(hull, options.coplanar);
  const HullFaces hull_faces(hull);
  BuildingSurface building;
  building.id = object.id;
  building.origin = object.origin;
  LabelledSurface& surface = building.surface;
  surface.vertices = detail.vertices;
  std::array<Numbering, kNumKnownScales> numbering;
  for (size_t i = 0; i < detail.faces.size(); ++i) {
    const Face& face = detail.faces[i];
    const FacePlane plane = face_plane(detail, face);
    for (const std::array<int, 3>& triangle : triangulate(detail, face)) {
      Eigen::Vector3d centre = Eigen::Vector3d::Zero();
      for (const int corner : triangle) centre += detail.vertices[corner] / 3.0;
      const int hull_face = hull_faces.face_for(face.type, centre, plane.normal);
      std::array<int, kNumKnownScales> planes = {detail_plane[i], structure_plane[i],
                                                 hull_face < 0 ? -1 : hull_plane[hull_face]};
      for (int k = 0; k < kNumKnownScales; ++k) planes[k] = numbering[k](planes[k]);
      surface.triangles.push_back(triangle);
      surface.planes.push_back(planes);
    }
  }
  for (int k = 0; k < kNumKnownScales; ++k) building.num_planes[k] = numbering[k].size();
  return building;
}

}  // namespace

CityJsonSurfaces read_cityjson_surfaces(const std::string& path,
                                        const CityJsonSurfaceOptions& options) {
  CityJsonSurfaces result;
  for (const CityJsonObject& object : read_cityjson_solids(path)) {
    const auto detail = object.solids.find(options.detail_level);
    const auto hull = object.solids.find(options.hull_level);
    if (detail == object.solids.end() || hull == object.solids.end()) continue;
    ++result.with_both_levels;
    if (!is_valid(detail->second) || !is_valid(hull->second)) {
      ++result.invalid;
      continue;
    }
    BuildingSurface building = building_surface(object, detail->second, hull->second, options);
    if (building.num_planes[1] < options.least_planes) {
      ++result.too_simple;
      continue;
    }
    result.buildings.push_back(std::move(building));
  }
  if (result.with_both_levels == 0) {
    throw Error(ExitCode::kBadInput, path + ": no building has geometry at levels of detail " +
                                         options.detail_level + " and " + options.hull_level);
  }
  return result;
}

}  // namespace gable
