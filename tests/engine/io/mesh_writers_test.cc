#include <gable/engine/io/models/model_writer.h>

#include <Eigen/Geometry>
#include <cstring>
#include <nlohmann/json.hpp>
#include <sstream>

#include "engine/io/sample_building.h"
#include "engine/io/scratch.h"

namespace gable {
namespace {

using nlohmann::json;

ModelWriterOptions options() {
  ModelWriterOptions options;
  options.crs = crs_from_text("EPSG:28992");
  options.anchor = {84900.7, 447500.2, 0.5};
  return options;
}

const Eigen::Vector3d kOrigin(84910.0, 447505.0, 2.0);
/// The box of 10 x 10 x 3 less its shaft of 3 x 3, and the chimney of 1 x 1 x 2.
constexpr double kVolume = 300.0 - 27.0 + 2.0;

std::string write_sample(const std::string& path) {
  const auto writer = open_model_writer(path, options());
  writer->append(sample_house("house 1"), sample_model(kOrigin));
  writer->close();
  return path;
}

/// Six times the volume that a triangle spans with the origin.
double volume6(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
  return a.dot(b.cross(c));
}

TEST(ObjWriter, EnclosesTheVolumeAtTheLocalOrigin) {
  const ScratchFolder scratch;
  std::istringstream stream(file_bytes(write_sample(scratch.path("out.obj"))));
  std::vector<Eigen::Vector3d> vertices;
  std::vector<std::string> groups;
  double volume = 0.0;
  std::string text;
  while (std::getline(stream, text)) {
    std::istringstream line(text);
    std::string key;
    line >> key;
    if (key == "v") {
      Eigen::Vector3d& p = vertices.emplace_back();
      line >> p.x() >> p.y() >> p.z();
    } else if (key == "g") {
      groups.push_back(text);
    } else if (key == "f") {
      std::vector<size_t> face;
      for (size_t i; line >> i;) face.push_back(i - 1);
      for (size_t i = 2; i < face.size(); ++i) {
        volume += volume6(vertices.at(face[0]), vertices.at(face[i - 1]), vertices.at(face[i])) / 6;
      }
    }
  }
  EXPECT_EQ(groups, std::vector<std::string>{"g house_1"});
  EXPECT_NEAR(volume, kVolume, 1e-6);
  EXPECT_EQ(vertices.at(0), kOrigin - Eigen::Vector3d(84900, 447500, 0));
  EXPECT_THAT(file_bytes(scratch.path("out.obj")),
              testing::HasSubstr("# local origin: 84900 447500 0\n"));
}

struct Glb {
  json head;
  std::string binary;
};

Glb parse_glb(const std::string& bytes) {
  const auto word = [&bytes](size_t at) {
    uint32_t value = 0;
    std::memcpy(&value, bytes.data() + at, sizeof value);
    return value;
  };
  EXPECT_EQ(bytes.substr(0, 4), "glTF");
  EXPECT_EQ(word(4), 2u);
  EXPECT_EQ(word(8), bytes.size());
  EXPECT_EQ(bytes.substr(16, 4), "JSON");
  EXPECT_EQ(word(12) % 4, 0u);
  Glb glb{json::parse(bytes.substr(20, word(12))), {}};
  const size_t chunk = 20 + word(12);
  if (chunk < bytes.size()) {
    EXPECT_EQ(bytes.substr(chunk + 4, 4), std::string("BIN\0", 4));
    glb.binary = bytes.substr(chunk + 8, word(chunk));
    EXPECT_EQ(chunk + 8 + word(chunk), bytes.size());
  }
  return glb;
}

template <typename T>
std::vector<T> accessor(const Glb& glb, int index, int components) {
  const json& a = glb.head["accessors"][index];
  const json& view = glb.head["bufferViews"][a["bufferView"].get<int>()];
  std::vector<T> values(a["count"].get<size_t>() * components);
  EXPECT_EQ(view["byteLength"].get<size_t>(), values.size() * sizeof(T));
  std::memcpy(values.data(), glb.binary.data() + view["byteOffset"].get<size_t>(),
              values.size() * sizeof(T));
  return values;
}

TEST(GlbWriter, EnclosesTheVolumeInOneMeshPerClassWithOutwardNormals) {
  const ScratchFolder scratch;
  const Glb glb = parse_glb(file_bytes(write_sample(scratch.path("out.glb"))));
  ASSERT_EQ(glb.head["meshes"].size(), 3u);
  EXPECT_EQ(glb.head["meshes"][0]["name"], "ground");
  EXPECT_EQ(glb.head["meshes"][2]["name"], "roof");
  EXPECT_EQ(glb.head["buffers"][0]["byteLength"], glb.binary.size());
  double volume = 0.0;
  for (const json& mesh : glb.head["meshes"]) {
    const json& primitive = mesh["primitives"][0];
    const auto positions = accessor<float>(glb, primitive["attributes"]["POSITION"], 3);
    const auto normals = accessor<float>(glb, primitive["attributes"]["NORMAL"], 3);
    const auto indices = accessor<uint32_t>(glb, primitive["indices"], 1);
    const auto at = [](const std::vector<float>& values, uint32_t i) {
      return Eigen::Vector3d(values.at(3 * i), values.at(3 * i + 1), values.at(3 * i + 2));
    };
    for (size_t i = 0; i < indices.size(); i += 3) {
      const Eigen::Vector3d a = at(positions, indices[i]), b = at(positions, indices[i + 1]),
                            c = at(positions, indices[i + 2]);
      volume += volume6(a, b, c) / 6;
      EXPECT_GT((b - a).cross(c - a).normalized().dot(at(normals, indices[i])), 0.999);
    }
    const json& box = glb.head["accessors"][primitive["attributes"]["POSITION"].get<int>()];
    EXPECT_EQ(box["min"][0], 10.0);
    EXPECT_EQ(box["min"][1], 5.0);
  }
  EXPECT_NEAR(volume, kVolume, 1e-3);
}

TEST(GlbWriter, RootNodeTurnsZUpIntoYUpAndNamesTheLocalOrigin) {
  const ScratchFolder scratch;
  const Glb glb = parse_glb(file_bytes(write_sample(scratch.path("out.glb"))));
  const json& root = glb.head["nodes"][glb.head["scenes"][0]["nodes"][0].get<int>()];
  EXPECT_EQ(root["children"].size(), 3u);
  const json& q = root["rotation"];
  const Eigen::Vector3d up =
      Eigen::Quaterniond(q[3], q[0], q[1], q[2]) * Eigen::Vector3d(0.0, 0.0, 1.0);
  EXPECT_NEAR((up - Eigen::Vector3d(0.0, 1.0, 0.0)).norm(), 0.0, 1e-9);
  EXPECT_EQ(root["extras"]["local_origin"], json({84900.0, 447500.0, 0.0}));
  EXPECT_EQ(root["extras"]["reference_system"], "EPSG:28992");
}

TEST(GlbWriter, NoBuildingIsStillAValidScene) {
  const ScratchFolder scratch;
  const std::string path = scratch.path("out.glb");
  open_model_writer(path, options())->close();
  const Glb glb = parse_glb(file_bytes(path));
  EXPECT_FALSE(glb.head.contains("meshes"));
  EXPECT_FALSE(glb.head.contains("buffers"));
}

class MeshWriters : public testing::TestWithParam<const char*> {};

TEST_P(MeshWriters, WritingTwiceGivesTheSameBytes) {
  const ScratchFolder scratch;
  const std::string once = file_bytes(write_sample(scratch.path(GetParam())));
  EXPECT_EQ(once, file_bytes(write_sample(scratch.path(GetParam()))));
}

TEST_P(MeshWriters, UnwritableFolderAndUnclosedFilesLeaveNothing) {
  const ScratchFolder scratch;
  const std::string path = scratch.path(std::string("none/") + GetParam());
  EXPECT_EQ(error_of([&] { open_model_writer(path, options()); }, path).code(),
            ExitCode::kCannotWrite);
  open_model_writer(scratch.path(GetParam()), options())
      ->append(sample_house("1"), sample_model(kOrigin));
  EXPECT_EQ(scratch.num_files(), 0);
}

INSTANTIATE_TEST_SUITE_P(Formats, MeshWriters, testing::Values("out.obj", "out.glb"));

}  // namespace
}  // namespace gable
