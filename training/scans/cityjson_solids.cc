#include <gable/engine/error.h>
#include <gable/engine/io/readable.h>
#include <gable/training/scans/cityjson_solids.h>
#include <gable/training/scans/face_plane.h>

#include <array>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <utility>

namespace gable {
namespace {

using Json = nlohmann::ordered_json;

/// Faces whose normal has less z than this are walls where the file does not say.
constexpr double kWallNormalZ = 0.1;

/// Level of detail as text: a number in CityJSON 1.0, a string from 1.1 on.
std::string level_of(const Json& lod) {
  if (lod.is_string()) return lod.get<std::string>();
  std::string text = std::to_string(lod.get<double>());
  text.erase(text.find_last_not_of('0') + 1);
  if (text.ends_with('.')) text.pop_back();
  return text;
}

SurfaceType type_from_normal(const Solid& solid, const Face& face) {
  const double z = face_plane(solid, face).normal.z();
  if (std::abs(z) < kWallNormalZ) return SurfaceType::kWall;
  return z > 0.0 ? SurfaceType::kRoof : SurfaceType::kGround;
}

class Reader {
 public:
  explicit Reader(const std::string& path) : path_(path) {}

  std::vector<CityJsonObject> read() {
    require_readable(path_);
    std::ifstream stream(path_, std::ios::binary);
    const Json json = Json::parse(stream, nullptr, false);
    if (json.is_discarded()) fail("is not valid JSON; the file may be cut short");
    try {
      if (!json.is_object() || json.value("type", "") != "CityJSON") fail("is not CityJSON");
      read_vertices(json);
      std::vector<CityJsonObject> objects;
      for (const auto& [id, object] : json.at("CityObjects").items()) {
        CityJsonObject read = read_object(id, object);
        if (!read.solids.empty()) objects.push_back(std::move(read));
      }
      return objects;
    } catch (const Json::exception& error) {
      fail(std::string("is not well-formed CityJSON: ") + error.what());
    }
  }

 private:
  [[noreturn]] void fail(const std::string& what) const {
    throw Error(ExitCode::kBadInput, path_ + ": " + what);
  }

  void read_vertices(const Json& json) {
    Eigen::Vector3d scale = Eigen::Vector3d::Ones(), translate = Eigen::Vector3d::Zero();
    if (json.contains("transform")) {
      for (int axis = 0; axis < 3; ++axis) {
        scale[axis] = json["transform"].at("scale").at(axis).get<double>();
        translate[axis] = json["transform"].at("translate").at(axis).get<double>();
      }
    }
    for (const Json& vertex : json.at("vertices")) {
      Eigen::Vector3d& point = vertices_.emplace_back();
      for (int axis = 0; axis < 3; ++axis) {
        point[axis] = vertex.at(axis).get<double>() * scale[axis] + translate[axis];
      }
    }
  }

  CityJsonObject read_object(const std::string& id, const Json& json) {
    CityJsonObject object;
    object.id = id;
    bool has_origin = false;
    for (const Json& geometry : json.value("geometry", Json::array())) {
      const std::string type = geometry.at("type").get<std::string>();
      if (type != "Solid" && type != "MultiSurface" && type != "CompositeSurface") continue;
      Solid solid = read_solid(geometry, type == "Solid");
      if (solid.faces.empty()) continue;
      if (!has_origin) object.origin = solid.vertices[0], has_origin = true;
      for (Eigen::Vector3d& vertex : solid.vertices) vertex -= object.origin;
      object.solids.emplace(level_of(geometry.at("lod")), std::move(solid));
    }
    return object;
  }

  Solid read_solid(const Json& geometry, bool in_shells) {
    Solid solid;
    number_of_.clear();
    const Json& boundaries = geometry.at("boundaries");
    const Json empty = Json::object();
    const Json& semantics = geometry.contains("semantics") ? geometry["semantics"] : empty;
    const Json* values = semantics.contains("values") ? &semantics["values"] : nullptr;
    if (in_shells) {
      if (boundaries.empty()) return solid;
      if (values && values->is_array()) values = &values->at(0);
    }
    const Json& faces = in_shells ? boundaries[0] : boundaries;
    for (size_t i = 0; i < faces.size(); ++i) {
      Face face = read_face(faces[i], &solid);
      if (face.rings.empty()) continue;
      face.type = type_from_normal(solid, face);
      if (values && values->is_array() && values->at(i).is_number()) {
        const std::string type =
            semantics.at("surfaces").at(values->at(i).get<size_t>()).value("type", "");
        if (type == "RoofSurface") face.type = SurfaceType::kRoof;
        if (type == "WallSurface") face.type = SurfaceType::kWall;
        if (type == "GroundSurface") face.type = SurfaceType::kGround;
      }
      solid.faces.push_back(std::move(face));
    }
    return solid;
  }

  Face read_face(const Json& rings, Solid* solid) {
    Face face;
    for (const Json& corners : rings) {
      std::vector<int> ring;
      for (const Json& corner : corners) {
        const int number = vertex_number(corner.get<int64_t>(), solid);
        if (ring.empty() || ring.back() != number) ring.push_back(number);
      }
      while (ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
      if (ring.size() >= 3) {
        face.rings.push_back(std::move(ring));
      } else if (face.rings.empty()) {
        break;
      }
    }
    return face;
  }

  int vertex_number(int64_t index, Solid* solid) {
    if (index < 0 || index >= static_cast<int64_t>(vertices_.size())) {
      fail("a boundary names vertex " + std::to_string(index) + " of " +
           std::to_string(vertices_.size()));
    }
    const Eigen::Vector3d& point = vertices_[index];
    const auto [at, is_new] = number_of_.emplace(std::array{point.x(), point.y(), point.z()},
                                                 static_cast<int>(solid->vertices.size()));
    if (is_new) solid->vertices.push_back(point);
    return at->second;
  }

  std::string path_;
  std::vector<Eigen::Vector3d> vertices_;
  std::map<std::array<double, 3>, int> number_of_;  ///< of the solid that is being read
};

}  // namespace

std::vector<CityJsonObject> read_cityjson_solids(const std::string& path) {
  return Reader(path).read();
}

}  // namespace gable
