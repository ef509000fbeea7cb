#include <gable/engine/io/models/building_json.h>
#include <gable/engine/io/models/city_objects.h>

#include <cmath>
#include <vector>

namespace gable {
namespace {

/// The list of surfaces that every geometry carries, by SurfaceType; a slab's lower faces are seen
/// from below.
constexpr const char* kSurfaces =
    R"([{"type":"GroundSurface"},{"type":"WallSurface"},{"type":"RoofSurface"}])";
constexpr const char* kSlabSurfaces =
    R"([{"type":"OuterCeilingSurface"},{"type":"WallSurface"},{"type":"RoofSurface"}])";

const char* object_type(PartRole role) {
  return role == PartRole::kMain || role == PartRole::kGarage ? "BuildingPart"
                                                              : "BuildingInstallation";
}

/// Two vertices that round to the same stored point are one; a ring that loses its area goes.
std::vector<int> without_repeats(const std::vector<int>& ring) {
  std::vector<int> kept;
  for (const int v : ring) {
    if (kept.empty() || kept.back() != v) kept.push_back(v);
  }
  while (kept.size() > 1 && kept.front() == kept.back()) kept.pop_back();
  return kept;
}

void append_list(const std::vector<std::string>& items, std::string* text) {
  *text += '[';
  for (size_t i = 0; i < items.size(); ++i) {
    if (i > 0) *text += ',';
    *text += items[i];
  }
  *text += ']';
}

}  // namespace

size_t CityObjects::CellHash::operator()(const Cell& cell) const {
  uint64_t hash = 0;
  for (const int64_t v : cell) {
    hash = (hash ^ static_cast<uint64_t>(v)) * 0x9e3779b97f4a7c15ull;
    hash ^= hash >> 29;
  }
  return hash;
}

int CityObjects::vertex(const Eigen::Vector3d& world) {
  const Eigen::Vector3d scaled = (world - translate_) / kCityJsonStep;
  const Cell cell = {std::llround(scaled.x()), std::llround(scaled.y()), std::llround(scaled.z())};
  const auto [it, is_new] = index_.try_emplace(cell, num_vertices());
  if (is_new) {
    if (it->second > 0) vertices_text_ += ',';
    vertices_text_ += '[' + std::to_string(cell[0]) + ',' + std::to_string(cell[1]) + ',' +
                      std::to_string(cell[2]) + ']';
    const Eigen::Vector3d stored(cell[0], cell[1], cell[2]);
    low_ = low_.cwiseMin(stored);
    high_ = high_.cwiseMax(stored);
  }
  return it->second;
}

std::string CityObjects::solid_text(const Solid& solid, const Eigen::Vector3d& origin, Lod lod,
                                    PartRole role) {
  std::vector<int> stored(solid.vertices.size(), -1);
  std::vector<std::string> faces, types;
  for (const Face& face : solid.faces) {
    std::vector<std::string> rings;
    for (const std::vector<int>& ring : face.rings) {
      std::vector<int> indices;
      for (const int v : ring) {
        if (stored[v] < 0) stored[v] = vertex(origin + solid.vertices[v]);
        indices.push_back(stored[v]);
      }
      indices = without_repeats(indices);
      if (indices.size() < 3) {
        if (rings.empty()) break;  // the outer ring is gone, and its holes with it
        continue;
      }
      std::vector<std::string> numbers;
      for (const int v : indices) numbers.push_back(std::to_string(v));
      append_list(numbers, &rings.emplace_back());
    }
    if (rings.empty()) continue;
    append_list(rings, &faces.emplace_back());
    types.push_back(std::to_string(static_cast<int>(face.type)));
  }
  std::string text =
      std::string(R"({"type":"Solid","lod":")") + lod_name(lod) + R"(","boundaries":[)";
  append_list(faces, &text);
  text += std::string(R"(],"semantics":{"surfaces":)") +
          (role == PartRole::kRoofSlab ? kSlabSurfaces : kSurfaces) + R"(,"values":[)";
  append_list(types, &text);
  return text + "]}}";
}

void CityObjects::add(const Building& building, const BuildingModel& model) {
  const std::string parent = dump_json(building.id);
  std::vector<std::string> names, parts;
  for (const PartModel& part : model.parts) {
    names.push_back(dump_json(building.id + "-" + part_name(part)));
    std::vector<std::string> geometries;
    for (const LodSolid& solid : part.solids) {
      geometries.push_back(solid_text(solid.solid, model.origin, solid.lod, part.role));
    }
    std::string& text = parts.emplace_back(names.back() + R"(:{"type":")" + object_type(part.role) +
                                           R"(","parents":[)" + parent + R"(],"geometry":)");
    append_list(geometries, &text);
    text += '}';
  }
  if (!objects_text_.empty()) objects_text_ += ',';
  objects_text_ +=
      parent + R"(:{"type":"Building","attributes":)" + dump_json(attributes_json(building));
  if (!names.empty()) {
    objects_text_ += R"(,"children":)";
    append_list(names, &objects_text_);
  }
  objects_text_ += '}';
  for (const std::string& part : parts) objects_text_ += ',' + part;
}

}  // namespace gable
