#include <gable/engine/error.h>
#include <gable/engine/io/models/building_json.h>
#include <gable/engine/io/models/glb_writer.h>
#include <gable/grammar/solid/triangulate.h>

#include <Eigen/Geometry>
#include <bit>
#include <cmath>
#include <limits>
#include <unordered_map>

namespace gable {
namespace {

static_assert(std::endian::native == std::endian::little, "glTF stores little-endian numbers");

// Numbers of the glTF 2.0 and GLB specifications.
constexpr int kFloat = 5126;
constexpr int kUnsignedInt = 5125;
constexpr int kArrayBuffer = 34962;
constexpr int kElementArrayBuffer = 34963;
constexpr uint32_t kMagic = 0x46546C67;
constexpr uint32_t kVersion = 2;
constexpr uint32_t kJsonChunk = 0x4E4F534A;
constexpr uint32_t kBinaryChunk = 0x004E4942;

struct Look {
  const char* name;
  std::array<double, 3> color;  ///< linear RGB
};
/// By SurfaceType.
constexpr Look kLooks[3] = {
    {"ground", {0.18, 0.18, 0.16}}, {"wall", {0.62, 0.58, 0.50}}, {"roof", {0.30, 0.10, 0.07}}};

Eigen::Vector3d normal_of(const Solid& solid, const std::vector<std::array<int, 3>>& triangles) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const auto& t : triangles) {
    sum += (solid.vertices[t[1]] - solid.vertices[t[0]])
               .cross(solid.vertices[t[2]] - solid.vertices[t[0]]);
  }
  return sum.normalized();
}

template <typename T>
void append_bytes(const std::vector<T>& values, std::string* bytes) {
  bytes->append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T));
}

void append_word(uint32_t word, std::string* bytes) {
  bytes->append(reinterpret_cast<const char*>(&word), sizeof word);
}

/// Adds a view of the bytes appended since `start` and an accessor to it; returns its number.
int add_accessor(size_t start, size_t end, int target, int component, const char* type,
                 size_t count, Json* gltf) {
  Json& views = (*gltf)["bufferViews"];
  views.push_back(
      {{"buffer", 0}, {"byteOffset", start}, {"byteLength", end - start}, {"target", target}});
  Json& accessors = (*gltf)["accessors"];
  accessors.push_back({{"bufferView", views.size() - 1},
                       {"componentType", component},
                       {"count", count},
                       {"type", type}});
  return static_cast<int>(accessors.size()) - 1;
}

}  // namespace

GlbWriter::GlbWriter(const std::string& path, const ModelWriterOptions& options)
    : file_(path), options_(options), local_origin_(options.anchor.array().floor()) {}

void GlbWriter::append(const Building&, const BuildingModel& model) {
  const Eigen::Vector3d shift = model.origin - local_origin_;
  for (const PartModel& part : model.parts) {
    const Solid& solid = finest_solid(part);
    for (const Face& face : solid.faces) {
      const auto triangles = triangulate(solid, face);
      const Eigen::Vector3f normal = normal_of(solid, triangles).cast<float>();
      Mesh& mesh = meshes_[static_cast<size_t>(drawn_type(part.role, face.type))];
      std::unordered_map<int, uint32_t> index;
      for (const auto& triangle : triangles) {
        for (const int v : triangle) {
          const auto next = static_cast<uint32_t>(mesh.positions.size() / 3);
          const auto [it, is_new] = index.try_emplace(v, next);
          if (is_new) {
            const Eigen::Vector3f p = (solid.vertices[v] + shift).cast<float>();
            mesh.positions.insert(mesh.positions.end(), p.data(), p.data() + 3);
            mesh.normals.insert(mesh.normals.end(), normal.data(), normal.data() + 3);
          }
          mesh.triangles.push_back(it->second);
        }
      }
    }
  }
}

void GlbWriter::close() {
  Json gltf;
  gltf["asset"] = {{"version", "2.0"}, {"generator", "gable"}};
  gltf["scene"] = 0;
  gltf["scenes"] = Json::array({{{"nodes", {0}}}});
  const double half = std::sqrt(0.5);
  Json root = {{"name", "gable"}, {"rotation", {-half, 0.0, 0.0, half}}};
  root["extras"]["local_origin"] = {local_origin_.x(), local_origin_.y(), local_origin_.z()};
  if (options_.crs.epsg != 0) {
    root["extras"]["reference_system"] = "EPSG:" + std::to_string(options_.crs.epsg);
  }
  gltf["nodes"] = Json::array({root});
  std::string binary;
  for (size_t type = 0; type < meshes_.size(); ++type) {
    const Mesh& mesh = meshes_[type];
    if (mesh.triangles.empty()) continue;
    const size_t count = mesh.positions.size() / 3;
    size_t start = binary.size();
    append_bytes(mesh.positions, &binary);
    const int positions =
        add_accessor(start, binary.size(), kArrayBuffer, kFloat, "VEC3", count, &gltf);
    Eigen::Map<const Eigen::Matrix3Xf> points(mesh.positions.data(), 3,
                                              static_cast<Eigen::Index>(count));
    const Eigen::Vector3f low = points.rowwise().minCoeff(), high = points.rowwise().maxCoeff();
    gltf["accessors"].back()["min"] = {low.x(), low.y(), low.z()};
    gltf["accessors"].back()["max"] = {high.x(), high.y(), high.z()};
    start = binary.size();
    append_bytes(mesh.normals, &binary);
    const int normals =
        add_accessor(start, binary.size(), kArrayBuffer, kFloat, "VEC3", count, &gltf);
    start = binary.size();
    append_bytes(mesh.triangles, &binary);
    const int indices = add_accessor(start, binary.size(), kElementArrayBuffer, kUnsignedInt,
                                     "SCALAR", mesh.triangles.size(), &gltf);
    const Look& look = kLooks[type];
    gltf["materials"].push_back(
        {{"name", look.name},
         {"pbrMetallicRoughness",
          {{"baseColorFactor", {look.color[0], look.color[1], look.color[2], 1.0}},
           {"metallicFactor", 0.0},
           {"roughnessFactor", 0.9}}}});
    Json primitive = {{"attributes", {{"POSITION", positions}, {"NORMAL", normals}}},
                      {"indices", indices},
                      {"material", gltf["materials"].size() - 1}};
    gltf["meshes"].push_back({{"name", look.name}, {"primitives", Json::array({primitive})}});
    gltf["nodes"][0]["children"].push_back(gltf["nodes"].size());
    gltf["nodes"].push_back({{"name", look.name}, {"mesh", gltf["meshes"].size() - 1}});
  }
  if (!binary.empty()) gltf["buffers"] = Json::array({{{"byteLength", binary.size()}}});

  std::string json = dump_json(gltf);
  json.resize((json.size() + 3) / 4 * 4, ' ');
  const size_t length = 12 + 8 + json.size() + (binary.empty() ? 0 : 8 + binary.size());
  if (length > std::numeric_limits<uint32_t>::max()) {
    throw Error(ExitCode::kCannotWrite, file_.path() +
                                            ": a GLB holds 4 GiB at most; write fewer buildings "
                                            "or another format");
  }
  std::string head;
  for (const uint32_t word : {kMagic, kVersion, static_cast<uint32_t>(length),
                              static_cast<uint32_t>(json.size()), kJsonChunk}) {
    append_word(word, &head);
  }
  file_.write(head + json);
  if (!binary.empty()) {
    std::string chunk;
    append_word(static_cast<uint32_t>(binary.size()), &chunk);
    append_word(kBinaryChunk, &chunk);
    file_.write(chunk);
    file_.write(binary);
  }
  file_.commit();
}

}  // namespace gable
