#include <gable/engine/reconstruct/scan/wall_traces.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace gable {
namespace {

// Share of a wall's samples at either end that do not say how far it reaches.
constexpr double kStray = 0.02;

double quantile(std::vector<double>* values, double share) {
  const auto at = values->begin() + static_cast<std::ptrdiff_t>(
                                        share * static_cast<double>(values->size() - 1) + 0.5);
  std::nth_element(values->begin(), at, values->end());
  return *at;
}

}  // namespace

std::vector<WallTrace> wall_traces(const std::vector<SurfaceSample>& samples,
                                   const std::vector<PlanarShape>& shapes,
                                   const Eigen::Vector3d& origin, double least_up,
                                   double least_length) {
  std::vector<std::vector<const SurfaceSample*>> members(shapes.size());
  for (const SurfaceSample& sample : samples) {
    if (sample.shape >= 0) members[sample.shape].push_back(&sample);
  }
  std::vector<WallTrace> traces;
  for (size_t s = 0; s < shapes.size(); ++s) {
    const Eigen::Vector3d normal = shapes[s].plane.normal();
    if (std::abs(normal.z()) >= least_up || members[s].empty()) continue;
    std::vector<double> heights, places;
    for (const SurfaceSample* sample : members[s]) heights.push_back(sample->point.z());
    WallTrace trace;
    trace.low = quantile(&heights, kStray);
    trace.high = quantile(&heights, 1.0 - kStray);
    const double middle = 0.5 * (trace.low + trace.high);
    const double level = normal.head<2>().norm();
    PlanLine& line = trace.line;
    line.normal = normal.head<2>() / level;
    line.offset = -(shapes[s].plane.signed_distance(origin) + normal.z() * middle) / level;
    for (const SurfaceSample* sample : members[s]) {
      places.push_back(line.along(sample->point.head<2>()));
    }
    line.begin = quantile(&places, kStray);
    line.end = quantile(&places, 1.0 - kStray);
    // As far as an evenly seen wall with these quantiles.
    const double beyond = (line.end - line.begin) * kStray / (1.0 - 2.0 * kStray);
    line.begin -= beyond;
    line.end += beyond;
    if (line.end - line.begin >= least_length) traces.push_back(trace);
  }
  std::stable_sort(traces.begin(), traces.end(), [](const WallTrace& a, const WallTrace& b) {
    return a.line.end - a.line.begin > b.line.end - b.line.begin;
  });
  return traces;
}

}  // namespace gable
