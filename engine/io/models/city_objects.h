#pragma once

#include <gable/engine/io/models/building.h>
#include <gable/engine/io/models/building_model.h>

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <string>
#include <unordered_map>

namespace gable {

/// Grid step of stored coordinates, metres: fine enough that faces stay planar to 1 mm.
inline constexpr double kCityJsonStep = 1e-4;

/// Builds the CityObjects of buildings over one shared list of integer vertices.
class CityObjects {
 public:
  /// `translate`: world point of the stored coordinates' zero.
  explicit CityObjects(const Eigen::Vector3d& translate) : translate_(translate) {}

  /// Adds a Building with its parts. Parts are called <id>-main-1, <id>-garage-1, ...
  void add(const Building& building, const BuildingModel& model);

  /// The members of "CityObjects": "id":{...},"id-main-1":{...}
  const std::string& objects() const { return objects_text_; }
  /// The elements of "vertices": [x,y,z],... of the stored coordinates, in order of first use.
  const std::string& vertices() const { return vertices_text_; }
  int num_vertices() const { return static_cast<int>(index_.size()); }
  /// World bounding box of all vertices; empty (min > max) where there are none.
  Eigen::Vector3d min() const { return translate_ + kCityJsonStep * low_; }
  Eigen::Vector3d max() const { return translate_ + kCityJsonStep * high_; }

 private:
  using Cell = std::array<int64_t, 3>;
  struct CellHash {
    size_t operator()(const Cell& cell) const;
  };

  int vertex(const Eigen::Vector3d& world);
  /// A geometry of CityJSON as text.
  std::string solid_text(const Solid& solid, const Eigen::Vector3d& origin, Lod lod, PartRole role);

  Eigen::Vector3d translate_;
  std::string objects_text_;
  std::unordered_map<Cell, int, CellHash> index_;
  std::string vertices_text_;
  Eigen::Vector3d low_ = Eigen::Vector3d::Constant(1e300);
  Eigen::Vector3d high_ = Eigen::Vector3d::Constant(-1e300);
};

}  // namespace gable
