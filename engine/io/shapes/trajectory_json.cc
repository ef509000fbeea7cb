#include <gable/engine/io/atomic_file.h>
#include <gable/engine/io/number_text.h>
#include <gable/engine/io/shapes/trajectory_json.h>
#include <glog/logging.h>

#include <array>

namespace gable {
namespace {

void append_moments(const PointMoments& m, std::string* text) {
  // The lower triangle: the one that eigenvalues are computed from.
  const double values[] = {m.weight,        m.sum.x(),       m.sum.y(),       m.sum.z(),
                           m.squares(0, 0), m.squares(1, 0), m.squares(2, 0), m.squares(1, 1),
                           m.squares(2, 1), m.squares(2, 2)};
  append_numbers(values, text);
}

}  // namespace

void write_trajectory_json(const std::string& path, const TrajectoryFile& file) {
  const FirstShapes& first = file.first_shapes;
  CHECK_EQ(static_cast<int>(first.moments.size()), file.trajectory.num_first);
  const Eigen::Vector3d reference =
      first.moments.empty() ? Eigen::Vector3d::Zero().eval() : first.moments[0].reference;
  for (const PointMoments& moments : first.moments) CHECK(moments.reference == reference);

  AtomicFile out(path);
  std::string text = "{\"format\":\"gable trajectory\",\"version\":1";
  const auto begin_key = [&](const char* key) {
    out.write(text);
    text.clear();
    text += ",\n\"" + std::string(key) + "\":";
  };
  begin_key("diagonal");
  append_number(first.diagonal, &text);
  begin_key("shape_of");
  append_numbers(first.shape_of, &text);
  begin_key("reference");
  append_numbers(reference, &text);
  begin_key("moments");
  append_list(first.moments, &text, append_moments);
  begin_key("adjacent");
  append_list(first.adjacent, &text, [](const std::pair<int, int>& pair, std::string* t) {
    append_numbers(std::array<int, 2>{pair.first, pair.second}, t);
  });
  begin_key("merges");
  append_list(file.trajectory.merges, &text, [](const Merge& merge, std::string* t) {
    *t += '[';
    append_number(merge.a, t);
    *t += ',';
    append_number(merge.b, t);
    *t += ',';
    append_number(merge.weight, t);
    *t += ']';
  });
  begin_key("features");
  append_list(file.trajectory.features, &text,
              [](const ScaleFeatures& features, std::string* t) { append_numbers(features, t); });
  begin_key("scales");
  append_numbers(file.scales.first, &text);
  out.write(text + "}\n");
  out.commit();
}

}  // namespace gable
