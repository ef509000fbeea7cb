#include "training/scans/merging_agreement.h"

#include <gable/training/scans/plane_attachment.h>
#include <gable/training/scans/triangle_contact.h>

#include <map>
#include <numeric>

namespace gable {
namespace {

/// The adjusted Rand index of two partitions of an area: that of infinitely many points on it.
double rand_index(const std::vector<int>& a, const std::vector<int>& b,
                  const std::vector<double>& area) {
  std::map<std::pair<int, int>, double> both;
  std::map<int, double> of_a, of_b;
  double total = 0.0;
  for (size_t i = 0; i < a.size(); ++i) {
    both[{a[i], b[i]}] += area[i];
    of_a[a[i]] += area[i];
    of_b[b[i]] += area[i];
    total += area[i];
  }
  const auto pairs = [&](const auto& areas) {
    double sum = 0.0;
    for (const auto& [key, value] : areas) sum += value * value;
    return sum / (total * total);
  };
  const double same = pairs(both), in_a = pairs(of_a), in_b = pairs(of_b);
  return (same - in_a * in_b) / (0.5 * (in_a + in_b) - in_a * in_b);
}

}  // namespace

MergingAgreement merging_agreement(const LabelledSurface& surface, double contact) {
  std::vector<TriangleCorners> triangles;
  std::vector<int> detail;
  std::vector<PointMoments> moments;
  std::array<std::vector<int>, 2> truth;
  for (size_t i = 0; i < surface.triangles.size(); ++i) {
    const auto& [a, b, c] = surface.triangles[i];
    triangles.push_back({surface.vertices[a], surface.vertices[b], surface.vertices[c]});
    const auto& planes = surface.planes[i];
    detail.push_back(planes[0]);
    if (planes[0] >= static_cast<int>(moments.size())) {
      moments.resize(planes[0] + 1);
      for (std::vector<int>& t : truth) t.resize(planes[0] + 1);
    }
    moments[planes[0]] += triangle_moments(triangles.back()[0], triangles.back()[1],
                                           triangles.back()[2], Eigen::Vector3d::Zero());
    truth[0][planes[0]] = planes[1];
    truth[1][planes[0]] = planes[2];
  }
  const int n = static_cast<int>(moments.size());
  std::vector<double> area;
  for (const PointMoments& m : moments) area.push_back(m.weight);
  const std::vector<int> open(n, -1);
  const std::vector<Merge> merges =
      merge_planes(moments, touching_groups(triangles, detail, contact), open);
  std::vector<int> shape(n);
  std::iota(shape.begin(), shape.end(), 0);
  MergingAgreement out = {{-1.0, -1.0}, {0, 0}};
  for (int i = 0; i <= static_cast<int>(merges.size()); ++i) {
    for (int scale : {0, 1}) {
      const double index = rand_index(shape, truth[scale], area);
      if (index <= out.best[scale]) continue;
      out.best[scale] = index;
      out.num_shapes[scale] = n - i;
    }
    if (i == static_cast<int>(merges.size())) break;
    for (int& s : shape) {
      if (s == merges[i].a || s == merges[i].b) s = n + i;
    }
  }
  return out;
}

double diagonal(const LabelledSurface& surface) {
  Eigen::Vector3d low = surface.vertices.at(0), high = low;
  for (const Eigen::Vector3d& v : surface.vertices) {
    low = low.cwiseMin(v);
    high = high.cwiseMax(v);
  }
  return (high - low).norm();
}

}  // namespace gable
