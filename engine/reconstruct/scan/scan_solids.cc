#include <gable/engine/closing/close_planes.h>
#include <gable/engine/closing/surface_distance.h>
#include <gable/engine/reconstruct/scan/overhangs.h>
#include <gable/engine/reconstruct/scan/scan_solids.h>
#include <gable/engine/reconstruct/scan/traced_outline.h>
#include <gable/engine/reconstruct/scan/wall_traces.h>
#include <gable/engine/scales/outline/inlier_polygon.h>
#include <gable/engine/scales/outline/ring_simplification.h>
#include <gable/grammar/ring.h>
#include <gable/grammar/solid/triangulate.h>
#include <glog/logging.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <utility>

namespace gable {
namespace {

// What is taken for a building: the diagonal of its bounding box, metres.
constexpr double kSmallest = 1.0;
constexpr double kLargest = 2000.0;

// Of what is seen from above: samples lower than the highest of their cell by more noises than this
// are below it, and by more of the cell's width.
constexpr double kNoisesBelow = 5.0;
constexpr double kWidthsBelow = 1.0;

// Misses smaller than this, metres, are nobody's concern.
constexpr double kLeastLossScale = 0.05;

// Slopes from which the height of a plane is limited to what is seen of it.
constexpr double kSteep = 0.3;

// Spacings of the points that a step takes up at least to get a line.
constexpr double kSpacingsPerStep = 4.0;

/// The points of a cloud, every so many; or places spread over the facets of a mesh, about evenly.
std::vector<SurfaceSample> surface_samples(const Scan& scan, const std::vector<int>& shape_of,
                                           const Eigen::Vector3d& origin, int most) {
  std::vector<SurfaceSample> samples;
  if (!scan.is_mesh()) {
    const size_t step = scan.points.size() / static_cast<size_t>(most) + 1;
    for (size_t i = 0; i < scan.points.size(); i += step) {
      samples.push_back({scan.points[i] - origin, 1.0, shape_of[i]});
    }
    return samples;
  }
  const auto for_triangles = [&](auto visit) {
    for (size_t f = 0; f < scan.facets.size(); ++f) {
      const auto corners = scan.facets[f];
      for (size_t k = 2; k < corners.size(); ++k) {
        const Eigen::Vector3d& a = scan.points[corners[0]];
        const Eigen::Vector3d& b = scan.points[corners[k - 1]];
        const Eigen::Vector3d& c = scan.points[corners[k]];
        visit(f, a, b, c, 0.5 * (b - a).cross(c - a).norm());
      }
    }
  };
  double area = 0.0;
  for_triangles([&](size_t, const auto&, const auto&, const auto&, double a) { area += a; });
  if (!(area > 0.0)) return samples;
  const double step = 2.0 * area / most;
  for_triangles([&](size_t f, const auto& a, const auto& b, const auto& c, double size) {
    if (!(size > 0.0)) return;
    const int count = static_cast<int>(std::ceil(size / step));
    for (int i = 0; i < count; ++i) {
      // The plastic number's sequence, folded into the triangle: even without being regular.
      double u = std::fmod(0.5 + 0.7548776662466927 * (i + 1), 1.0);
      double v = std::fmod(0.5 + 0.5698402909980532 * (i + 1), 1.0);
      if (count == 1) u = v = 1.0 / 3.0;
      if (u + v > 1.0) {
        u = 1.0 - u;
        v = 1.0 - v;
      }
      samples.push_back({a + u * (b - a) + v * (c - a) - origin, size / count, shape_of[f]});
    }
  });
  return samples;
}

/// Adds the samples that are no roof's to those of roofs where there are none of these in the cell
/// or beside it: what leans is a wall by its slope and yet covers ground, while the noise of walls
/// below a roof would only blur its outline.
void add_uncovered(const std::vector<SurfaceSample>& samples, const std::vector<bool>& is_roof,
                   double cell, std::vector<Eigen::Vector3d>* flat) {
  using Cell = std::pair<int, int>;
  const auto cell_of = [cell](const Eigen::Vector3d& p) {
    return Cell{static_cast<int>(std::floor(p.x() / cell)),
                static_cast<int>(std::floor(p.y() / cell))};
  };
  std::set<Cell> covered;
  for (const Eigen::Vector3d& p : *flat) {
    const auto [x, y] = cell_of(p);
    for (int k = 0; k < 9; ++k) covered.insert({x + k % 3 - 1, y + k / 3 - 1});
  }
  for (const SurfaceSample& sample : samples) {
    if (sample.shape < 0 || is_roof[sample.shape] || covered.count(cell_of(sample.point))) continue;
    flat->emplace_back(sample.point.x(), sample.point.y(), 0.0);
  }
}

/// The pieces of the ground that points on it cover, largest first.
std::vector<PlanPolygon> plan_pieces(const std::vector<Eigen::Vector3d>& flat,
                                     const OrientedPlane& ground, double spacing, double tolerance,
                                     double least_piece) {
  std::vector<PlanPolygon> pieces;
  double largest = 0.0;
  for (const SpacePolygon& polygon : inlier_polygons(flat, ground, {spacing})) {
    std::vector<Ring> rings(1);
    for (const auto& p : polygon.outer) rings[0].push_back(p.head<2>());
    const double area = std::abs(signed_area(rings[0]));
    largest = std::max(largest, area);
    if (area < least_piece * largest) continue;
    for (const auto& hole : polygon.holes) {
      Ring ring;
      for (const auto& p : hole) ring.push_back(p.head<2>());
      if (std::abs(signed_area(ring)) >= least_piece * area) rings.push_back(std::move(ring));
    }
    rings = simplified(rings, tolerance);
    if (rings.empty()) continue;
    PlanPolygon piece{std::move(rings.front()), {}};
    piece.holes.assign(std::make_move_iterator(rings.begin() + 1),
                       std::make_move_iterator(rings.end()));
    pieces.push_back(std::move(piece));
  }
  return pieces;
}

/// Heights, and which plane's each of them is.
struct SeenFromAbove {
  std::vector<HeightSample> heights;
  std::vector<int> planes;
};

/// The heights that are seen from above where there are no overhangs, each speaking for its share
/// of a cell of the plan.
SeenFromAbove seen_from_above(const std::vector<SurfaceSample>& samples,
                              const std::vector<bool>& overhangs,
                              const std::vector<int>& plane_of_shape,
                              const std::vector<Plane>& planes, double cell, double noise) {
  struct Seen {
    int sample;
    double top;  // height of the sample's plane there: free of noise
  };
  std::map<std::pair<int, int>, std::vector<Seen>> cells;
  for (size_t i = 0; i < samples.size(); ++i) {
    const SurfaceSample& sample = samples[i];
    if (sample.shape < 0 || plane_of_shape[sample.shape] < 0 || overhangs[i]) continue;
    const Eigen::Vector2d p = sample.point.head<2>();
    cells[{static_cast<int>(std::floor(p.x() / cell)), static_cast<int>(std::floor(p.y() / cell))}]
        .push_back({static_cast<int>(i), planes[plane_of_shape[sample.shape]].at(p)});
  }
  SeenFromAbove seen;
  for (auto& [key, members] : cells) {
    double top = members.front().top;
    for (const Seen& s : members) top = std::max(top, s.top);
    std::erase_if(members, [&](const Seen& s) {
      return s.top < top - kNoisesBelow * noise - kWidthsBelow * cell;
    });
    for (const Seen& s : members) {
      const SurfaceSample& sample = samples[s.sample];
      seen.heights.push_back({sample.point, cell * cell / static_cast<double>(members.size())});
      seen.planes.push_back(plane_of_shape[sample.shape]);
    }
  }
  return seen;
}

/// Planes, and where each is seen.
struct OfferedPlanes {
  std::vector<Plane> planes;
  std::vector<Eigen::AlignedBox3d> reaches;
};

/// The planes of which most is seen, until they hold a share of all that is; each may be used
/// within `margin` of where it is seen in plan, and in height where it is steep.
OfferedPlanes offered_planes(const std::vector<Plane>& planes, const SeenFromAbove& seen,
                             double share, double margin) {
  std::vector<double> areas(planes.size(), 0.0);
  std::vector<Eigen::AlignedBox3d> boxes(planes.size());
  double left = 0.0;
  for (size_t i = 0; i < seen.heights.size(); ++i) {
    areas[seen.planes[i]] += seen.heights[i].weight;
    boxes[seen.planes[i]].extend(seen.heights[i].point);
    left += share * seen.heights[i].weight;
  }
  std::vector<size_t> order(planes.size());
  std::iota(order.begin(), order.end(), size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](size_t a, size_t b) { return areas[a] > areas[b]; });
  OfferedPlanes offered;
  for (const size_t i : order) {
    if (left <= 0.0 || areas[i] <= 0.0) break;
    left -= areas[i];
    const double slope = std::hypot(planes[i].a, planes[i].b);
    const double up = slope < kSteep ? kLargest : margin;
    const Eigen::Vector3d around(margin, margin, up);
    offered.planes.push_back(planes[i]);
    offered.reaches.emplace_back(boxes[i].min() - around, boxes[i].max() + around);
  }
  return offered;
}

/// The options at a scale whose shapes are `rms` from their elements.
ClosingOptions closing_options(double rms, double spacing, const ScanSolidOptions& options) {
  ClosingOptions closing = options.closing;
  const double part = std::max(rms, options.least_rms) / options.coarse_rms;
  closing.loss_scale = std::clamp(3.0 * rms, kLeastLossScale, closing.loss_scale);
  closing.refinement.loss_scale = closing.loss_scale;
  closing.boundary_cost *= part;
  closing.step_cost *= part;
  closing.plane_charge *= part;
  // What is shorter is not seen at this spacing.
  closing.least_step_length =
      std::max(std::min(part, 1.0) * closing.least_step_length, kSpacingsPerStep * spacing);
  return closing;
}

void measure(const std::vector<SurfaceSample>& samples, ScanSolid* model) {
  for (const Solid& solid : model->solids) {
    model->facets += static_cast<int>(solid.faces.size());
    for (const Face& face : solid.faces) {
      model->triangles += static_cast<int>(triangulate(solid, face).size());
    }
  }
  const SurfaceDistance distance(model->solids);
  double weight = 0.0, sum = 0.0, squares = 0.0;
  for (const SurfaceSample& sample : samples) {
    const double d = distance(sample.point);
    weight += sample.weight;
    sum += sample.weight * d;
    squares += sample.weight * d * d;
  }
  model->mean = sum / weight;
  model->rms = std::sqrt(squares / weight);
}

}  // namespace

std::string check(const ScanSolidOptions& options) {
  if (std::string error = check(options.closing); !error.empty()) return error;
  if (!(options.least_up > 0.0 && options.least_up <= 1.0)) return "least_up must lie in (0, 1]";
  if (!(options.outline_tolerance >= 0.0 && options.outline_tolerance <= 100.0)) {
    return "outline_tolerance must lie in [0, 100] m";
  }
  if (!(options.least_piece >= 0.0 && options.least_piece <= 1.0)) {
    return "least_piece must lie in [0, 1]";
  }
  if (!(options.overhang >= 0.0 && options.overhang <= 10.0)) {
    return "overhang must lie in [0, 10] m";
  }
  if (!(options.coarse_rms > 0.0 && options.coarse_rms <= 100.0)) {
    return "coarse_rms must lie in (0, 100] m";
  }
  if (!(options.least_rms > 0.0 && options.least_rms <= options.coarse_rms)) {
    return "least_rms must lie in (0, coarse_rms]";
  }
  if (!(options.offered_share > 0.0 && options.offered_share <= 1.0)) {
    return "offered_share must lie in (0, 1]";
  }
  if (options.most_samples < 100 || options.most_samples > 10000000) {
    return "most_samples must lie in [100, 1e7]";
  }
  return "";
}

ScanSolid close_scale(const Scan& scan, const ScaleShapes& scale, const ScanSolidOptions& options) {
  CHECK(check(options).empty()) << check(options);
  CHECK_EQ(scale.shape_of.size(), scan.num_elements());
  ScanSolid model;
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& p : scan.points) box.extend(p);
  if (box.isEmpty() || box.diagonal().norm() < kSmallest || box.diagonal().norm() > kLargest) {
    model.reason = "the scan is not the size of a building in metres";
    return model;
  }
  model.origin = box.center().array().floor();
  const std::vector<SurfaceSample> samples =
      surface_samples(scan, scale.shape_of, model.origin, options.most_samples);
  std::vector<Plane> planes;
  std::vector<int> plane_of_shape(scale.shapes.size(), -1);
  for (size_t s = 0; s < scale.shapes.size(); ++s) {
    const OrientedPlane& plane = scale.shapes[s].plane;
    const Eigen::Vector3d normal = plane.normal();
    if (std::abs(normal.z()) < options.least_up) continue;
    plane_of_shape[s] = static_cast<int>(planes.size());
    planes.push_back({-normal.x() / normal.z(), -normal.y() / normal.z(),
                      -plane.signed_distance(model.origin) / normal.z()});
  }
  if (planes.empty()) {
    model.reason = "no shape of the scan faces up";
    return model;
  }
  std::vector<bool> is_roof(scale.shapes.size());
  for (size_t s = 0; s < is_roof.size(); ++s) is_roof[s] = plane_of_shape[s] >= 0;
  // Walls are seen edge-on in plan: their samples would say nothing of how dense the others are.
  const OrientedPlane ground(Eigen::Vector3d::UnitZ(), 0.0);
  const auto on_ground = [&](const auto& is_wanted) {
    std::vector<Eigen::Vector3d> flat;
    for (size_t i = 0; i < samples.size(); ++i) {
      const SurfaceSample& sample = samples[i];
      if (sample.shape < 0 || !is_roof[sample.shape] || !is_wanted(i)) continue;
      flat.emplace_back(sample.point.x(), sample.point.y(), 0.0);
    }
    return flat;
  };
  const double spacing =
      std::max(planar_spacing(on_ground([](size_t) { return true; }), ground), 1e-3);
  const double tolerance = std::max({options.outline_tolerance, spacing, 3.0 * scale.rms});
  const ClosingOptions closing = closing_options(scale.rms, spacing, options);
  const std::vector<WallTrace> walls =
      wall_traces(samples, scale.shapes, model.origin, options.least_up, closing.least_step_length);
  const std::vector<bool> overhangs = find_overhangs(samples, is_roof, walls, options.overhang);
  std::vector<Eigen::Vector3d> covered = on_ground([&](size_t i) { return !overhangs[i]; });
  add_uncovered(samples, is_roof, 2.0 * spacing, &covered);
  const SeenFromAbove seen =
      seen_from_above(samples, overhangs, plane_of_shape, planes, 2.0 * spacing, scale.rms);
  const OfferedPlanes offered = offered_planes(planes, seen, options.offered_share, 4.0 * spacing);
  ClosingEvidence evidence{{}, offered.reaches};
  for (const WallTrace& wall : walls) evidence.traces.push_back(wall.line);

  const double base = box.min().z() - model.origin.z() - 2.0 * closing.clearance;
  for (const PlanPolygon& piece :
       plan_pieces(covered, ground, spacing, tolerance, options.least_piece)) {
    const PlanPolygon outline = traced_outline(piece, evidence.traces, 2.0 * tolerance);
    ClosedPlanes closed =
        close_planes(outline, offered.planes, seen.heights, base, closing, evidence);
    if (!closed.reason.empty()) {
      model.reason = closed.reason;
      continue;
    }
    model.planes += static_cast<int>(closed.roof.planes.size());
    std::move(closed.solids.begin(), closed.solids.end(), std::back_inserter(model.solids));
  }
  if (model.solids.empty()) {
    if (model.reason.empty()) model.reason = "the points cover no part of the plan";
    return model;
  }
  model.reason.clear();
  measure(samples, &model);
  return model;
}

std::vector<ScanSolid> close_scales(const Scan& scan, const std::vector<ScaleShapes>& scales,
                                    const ScanSolidOptions& options) {
  std::vector<ScanSolid> models;
  std::vector<size_t> closed;
  for (size_t k = 0; k < scales.size(); ++k) {
    models.push_back(close_scale(scan, scales[k], options));
    models.back().scale = static_cast<int>(k);
    if (models.back().reason.empty()) closed.push_back(k);
  }
  for (size_t i = 1; i < closed.size(); ++i) {
    const ScanSolid& finer = models[closed[i - 1]];
    if (models[closed[i]].facets > finer.facets) models[closed[i]] = finer;
  }
  for (size_t i = closed.size(); i-- > 1;) {
    const ScanSolid& coarser = models[closed[i]];
    if (models[closed[i - 1]].rms > coarser.rms) models[closed[i - 1]] = coarser;
  }
  return models;
}

}  // namespace gable
