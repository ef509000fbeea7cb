#include <gable/engine/error.h>
#include <gable/engine/io/scans/finish_scan.h>
#include <glog/logging.h>

#include <algorithm>

namespace gable {
namespace {

// Far beyond any survey, yet squares and their sums stay far from overflow.
constexpr double kFarthest = 1e12;
constexpr size_t kLongestProblem = 200;
constexpr float kShortestNormal = 1e-6f;

bool usable(const Eigen::Vector3d& point) {
  return (point.array().abs() <= kFarthest).all();  // false for NaN
}

template <typename T>
void keep(const std::vector<bool>& kept, std::vector<T>* values) {
  size_t to = 0;
  for (size_t from = 0; from < values->size(); ++from) {
    if (kept[from]) (*values)[to++] = (*values)[from];
  }
  values->resize(to);
}

void make_unit(std::vector<Eigen::Vector3f>* normals) {
  for (Eigen::Vector3f& normal : *normals) {
    const Eigen::Vector3d exact = normal.cast<double>();
    const double length = exact.norm();
    if (length >= kShortestNormal && length <= kFarthest) {
      normal = (exact / length).cast<float>();
    } else {
      normal.setZero();
    }
  }
}

}  // namespace

void refuse_scan(const std::string& path, const std::string& problem, std::string_view remedy) {
  // A problem may quote a file of any bytes.
  std::string line = problem.substr(0, kLongestProblem);
  for (char& c : line) {
    if (c < ' ' || c > '~') c = '?';
  }
  throw Error(ExitCode::kBadInput, path + ": " + line + "; " + std::string(remedy));
}

ScanFile finish_scan(Scan raw, const std::string& path) {
  const size_t num_points = raw.points.size();
  CHECK(raw.normals.empty() || raw.normals.size() == num_points);
  const bool was_mesh = raw.is_mesh();
  const size_t num_elements = raw.num_elements();
  for (const auto& [name, values] : raw.labels) CHECK_EQ(values.size(), num_elements) << name;

  ScanFile file;
  std::vector<bool> kept_points(num_points);
  std::vector<int> number(num_points, -1);
  int num_kept = 0;
  for (size_t i = 0; i < num_points; ++i) {
    kept_points[i] = usable(raw.points[i]);
    if (kept_points[i]) number[i] = num_kept++;
  }
  file.skipped_points = num_points - num_kept;

  std::vector<bool> kept_facets(raw.facets.size());
  bool all_facets = true;
  for (size_t f = 0; f < raw.facets.size(); ++f) {
    const auto corners = raw.facets[f];
    bool whole = corners.size() >= 3;
    for (const int corner : corners) {
      if (corner < 0 || static_cast<size_t>(corner) >= num_points) {
        refuse_scan(path,
                    "facet " + std::to_string(f + 1) + " uses a point that the file does not have");
      }
      whole = whole && kept_points[corner];
    }
    kept_facets[f] = whole;
    all_facets = all_facets && whole;
    if (!whole) ++file.skipped_facets;
  }
  if (num_kept == 0) {
    refuse_scan(path,
                num_points == 0 ? "holds no points" : "holds no point with finite coordinates",
                "give a scan with points");
  }

  Scan& scan = file.scan;
  if (file.skipped_points > 0) {
    keep(kept_points, &raw.points);
    if (!raw.normals.empty()) keep(kept_points, &raw.normals);
  }
  scan.points = std::move(raw.points);
  scan.normals = std::move(raw.normals);
  make_unit(&scan.normals);
  if (file.skipped_points == 0 && all_facets) {
    scan.facets = std::move(raw.facets);
  } else {
    std::vector<int> corners;
    for (size_t f = 0; f < raw.facets.size(); ++f) {
      if (!kept_facets[f]) continue;
      corners.assign(raw.facets[f].begin(), raw.facets[f].end());
      for (int& corner : corners) corner = number[corner];
      scan.facets.add(corners);
    }
  }
  // What is left of a mesh without a whole facet is a cloud, which facets' labels say nothing of.
  if (was_mesh && !scan.is_mesh()) return file;
  for (auto& [name, values] : raw.labels) {
    keep(was_mesh ? kept_facets : kept_points, &values);
    for (int& value : values) value = std::max(value, -1);
    scan.labels[name] = std::move(values);
  }
  return file;
}

}  // namespace gable
