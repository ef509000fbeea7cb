#include <gable/engine/parallel_ranges.h>
#include <gable/engine/scales/relax_regions.h>
#include <gable/engine/scales/shape_plane.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace gable {
namespace {

struct RegionPlane {
  Eigen::Vector3f normal = Eigen::Vector3f::UnitZ();
  float offset = 0.0f;
};

std::vector<RegionPlane> planes_of(const std::vector<PointMoments>& moments) {
  std::vector<RegionPlane> planes(moments.size());
  for (size_t r = 0; r < moments.size(); ++r) {
    if (moments[r].weight < 3.0) continue;
    const ShapePlane plane = shape_plane(moments[r]);
    planes[r] = {plane.normal.cast<float>(), static_cast<float>(plane.normal.dot(plane.centroid))};
  }
  return planes;
}

std::vector<PointMoments> moments_of_regions(const OrderedCloud& cloud,
                                             const std::vector<int>& region_of, size_t count) {
  std::vector<PointMoments> moments(count);
  for (int p = 0; p < cloud.size(); ++p) {
    if (region_of[p] >= 0) moments[region_of[p]].add(cloud.positions[p].cast<double>());
  }
  return moments;
}

// How many of a point's neighbours are in each of the regions around it: a short list.
class RegionCounts {
 public:
  void count(std::span<const int> neighbours, const std::vector<int>& region_of) {
    regions_.clear();
    counts_.clear();
    for (int q : neighbours) {
      const int region = region_of[q];
      size_t i = 0;
      while (i < regions_.size() && regions_[i] != region) ++i;
      if (i == regions_.size()) {
        regions_.push_back(region);
        counts_.push_back(0);
      }
      ++counts_[i];
    }
  }
  size_t size() const { return regions_.size(); }
  int region(size_t i) const { return regions_[i]; }
  int of(size_t i) const { return counts_[i]; }

 private:
  std::vector<int> regions_, counts_;
};

}  // namespace

void relax_regions(const OrderedCloud& cloud, const Neighbours& neighbours,
                   const LocalPlanes& local_planes, const RelaxOptions& options,
                   std::vector<int>* region_of, std::vector<PointMoments>* moments) {
  const float epsilon = static_cast<float>(options.epsilon);
  const float precision = static_cast<float>(0.5 / (options.deviation * options.deviation));
  const float tilt = static_cast<float>(options.tilt);
  const float price = static_cast<float>(options.smoothness / std::max(1, neighbours.k));
  for (int sweep = 0; sweep < options.sweeps; ++sweep) {
    const std::vector<RegionPlane> planes = planes_of(*moments);
    const std::vector<int> before = *region_of;
    for_ranges(before.size(), options.threads, [&](size_t begin, size_t end) {
      RegionCounts around;
      for (size_t p = begin; p < end; ++p) {
        // Most points lie inside a region and have no choice.
        const std::span<const int> nearest = neighbours.of(static_cast<int>(p));
        if (std::all_of(nearest.begin(), nearest.end(),
                        [&](int q) { return before[q] == before[p]; })) {
          continue;
        }
        around.count(nearest, before);
        // No region at all is as good as one at a distance of epsilon.
        float best = std::numeric_limits<float>::max();
        int choice = -1;
        for (size_t i = 0; i < around.size(); ++i) {
          const int region = around.region(i);
          float distance = epsilon, cosine = 0.5f;
          if (region >= 0) {
            const RegionPlane& plane = planes[region];
            distance = std::abs(plane.normal.dot(cloud.positions[p]) - plane.offset);
            if (distance > epsilon) continue;
            cosine = std::abs(plane.normal.dot(local_planes.normals[p]));
          }
          const float cost = precision * distance * distance + tilt * (1.0f - cosine) +
                             price * static_cast<float>(neighbours.k - around.of(i));
          if (cost < best || (cost == best && region < choice)) {
            best = cost;
            choice = region;
          }
        }
        (*region_of)[p] = choice;
      }
    });
    *moments = moments_of_regions(cloud, *region_of, moments->size());
    if (*region_of == before && sweep > 0) break;
  }

  std::vector<int> renumbered(moments->size(), -1);
  std::vector<PointMoments> kept;
  for (size_t r = 0; r < moments->size(); ++r) {
    if ((*moments)[r].weight < options.min_inliers) continue;
    renumbered[r] = static_cast<int>(kept.size());
    kept.push_back((*moments)[r]);
  }
  for (int& region : *region_of) {
    if (region >= 0) region = renumbered[region];
  }
  *moments = std::move(kept);
}

}  // namespace gable
