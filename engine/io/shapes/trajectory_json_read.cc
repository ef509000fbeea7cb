#include <gable/engine/error.h>
#include <gable/engine/io/readable.h>
#include <gable/engine/io/shapes/trajectory_json.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>

namespace gable {
namespace {

using Json = nlohmann::json;

void require(bool holds, const char* problem) {
  if (!holds) throw std::runtime_error(problem);
}

/// An integer in [low, high).
int integer(const Json& json, int64_t low, int64_t high, const char* problem) {
  require(json.is_number_integer(), problem);
  const auto value = json.get<int64_t>();
  require(value >= low && value < high, problem);
  return static_cast<int>(value);
}

const Json& list(const Json& json, const char* key) {
  const Json& values = json.at(key);
  require(values.is_array(), key);
  return values;
}

const Json& tuple(const Json& json, size_t size, const char* key) {
  require(json.is_array() && json.size() == size, key);
  return json;
}

FirstShapes first_shapes(const Json& json) {
  FirstShapes first;
  first.diagonal = json.at("diagonal").get<double>();
  Eigen::Vector3d reference;
  const Json& at = tuple(json.at("reference"), 3, "reference");
  for (int k = 0; k < 3; ++k) reference[k] = at[k].get<double>();
  for (const Json& row : list(json, "moments")) {
    tuple(row, 10, "moments");
    PointMoments& m = first.moments.emplace_back();
    m.reference = reference;
    m.weight = row[0].get<double>();
    int next = 1;
    for (int k = 0; k < 3; ++k) m.sum[k] = row[next++].get<double>();
    for (int i = 0; i < 3; ++i) {
      for (int k = i; k < 3; ++k) m.squares(i, k) = m.squares(k, i) = row[next++].get<double>();
    }
  }
  const auto num_first = static_cast<int64_t>(first.moments.size());
  const Json& shape_of = list(json, "shape_of");
  first.shape_of.reserve(shape_of.size());
  for (const Json& shape : shape_of) {
    first.shape_of.push_back(integer(shape, -1, num_first, "shape_of"));
  }
  for (const Json& row : list(json, "adjacent")) {
    tuple(row, 2, "adjacent");
    const int a = integer(row[0], 0, num_first, "adjacent");
    first.adjacent.emplace_back(a, integer(row[1], a + 1, num_first, "adjacent"));
  }
  return first;
}

Trajectory trajectory(const Json& json, int num_first) {
  Trajectory out;
  out.num_first = num_first;
  const Json& merges = list(json, "merges");
  std::vector<bool> is_merged(num_first + merges.size());
  for (const Json& row : merges) {
    tuple(row, 3, "merges");
    const auto end = static_cast<int64_t>(num_first + out.merges.size());
    Merge merge;
    merge.a = integer(row[0], 0, end, "merges");
    merge.b = integer(row[1], merge.a + 1, end, "merges");
    merge.weight = row[2].get<double>();
    for (const int shape : {merge.a, merge.b}) {
      require(!is_merged[shape], "merges use a shape twice");
      is_merged[shape] = true;
    }
    out.merges.push_back(merge);
  }
  for (const Json& row : list(json, "features")) {
    tuple(row, kNumFeatures, "features");
    ScaleFeatures& features = out.features.emplace_back();
    for (int k = 0; k < kNumFeatures; ++k) features[k] = row[k].get<float>();
  }
  require(out.features.empty() || static_cast<int>(out.features.size()) == out.num_configurations(),
          "features are not one per configuration");
  return out;
}

ScaleLabels scales(const Json& json, int num_configurations) {
  ScaleLabels out;
  out.num_configurations = num_configurations;
  int last = 0;
  for (const Json& value : list(json, "scales")) {
    last = integer(value, last, int64_t{num_configurations} + 1, "scales");
    out.first.push_back(last);
  }
  return out;
}

}  // namespace

TrajectoryFile read_trajectory_json(const std::string& path) {
  require_readable(path);
  std::ifstream stream(path, std::ios::binary);
  try {
    const Json json = Json::parse(stream);
    require(json.is_object() && json.value("format", "") == "gable trajectory", "format");
    require(json.at("version") == 1, "version");
    TrajectoryFile file;
    file.first_shapes = first_shapes(json);
    file.trajectory = trajectory(json, static_cast<int>(file.first_shapes.moments.size()));
    file.scales = scales(json, file.trajectory.num_configurations());
    return file;
  } catch (const Json::exception&) {
    throw Error(ExitCode::kBadInput,
                path + ": is no trajectory, or a damaged one; give a trajectory.json of gable");
  } catch (const std::runtime_error& problem) {
    throw Error(ExitCode::kBadInput, path + ": is no trajectory, or a damaged one (" +
                                         problem.what() + "); give a trajectory.json of gable");
  }
}

}  // namespace gable
