#include <gable/engine/closing/close_planes.h>
#include <gable/engine/closing/label_expansion.h>
#include <gable/engine/closing/labelled_plan.h>
#include <gable/engine/closing/plan_division.h>
#include <gable/engine/closing/plan_lines.h>
#include <gable/engine/closing/plan_mending.h>
#include <gable/engine/closing/sample_grid.h>
#include <gable/grammar/random.h>
#include <glog/logging.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>

namespace gable {
namespace {

// Attempts at a valid solid: by moving things, and by dearer boundaries where that does not help.
constexpr int kMovesPerPrice = 4;
constexpr int kNumPrices = 4;
constexpr double kDearer = 2.0;
constexpr double kMove = 0.003;  // metres per attempt

// Steeper than this, planes are walls: normals of which less than this points up.
constexpr double kLeastUp = 0.17;

// Heights that are one, metres, and what a boundary where two planes meet costs of one with a step.
constexpr double kSameHeight = 1e-4;
constexpr double kCreaseShare = 0.1;

// Slopes above this leave the heights of a building within its plan.
constexpr double kSteep = 0.3;
constexpr double kInside = 0.01;  // metres
constexpr double kNear = 4.0;     // metres, of what is seen of a plane

// Slopes below this are level.
constexpr double kLevel = 1e-3;

// More than anything else can cost, per cell.
constexpr double kForbidden = 1e7;

Eigen::AlignedBox3d everywhere() {
  const Eigen::Vector3d far = Eigen::Vector3d::Constant(std::numeric_limits<double>::max());
  return {-far, far};
}

/// Integral of |difference| along a border, where it is linear.
double step_area(double at_from, double at_to, double length) {
  const double a = std::abs(at_from), b = std::abs(at_to);
  if ((at_from >= 0.0) == (at_to >= 0.0) || a + b == 0.0) return 0.5 * length * (a + b);
  return 0.5 * length * (a * a + b * b) / (a + b);
}

class Closing {
 public:
  Closing(const PlanPolygon& outline, const std::vector<HeightSample>& samples, double base,
          const ClosingOptions& options, const ClosingEvidence& evidence)
      : base_(base), options_(options), evidence_(evidence) {
    for (const HeightSample& sample : samples) {
      if (polygon_holds(outline, sample.point.head<2>())) samples_.push_back(sample);
    }
    std::vector<double> heights;
    for (const HeightSample& sample : samples_) heights.push_back(sample.point.z());
    if (heights.empty()) return;
    const auto middle = heights.begin() + static_cast<std::ptrdiff_t>(heights.size() / 2);
    std::nth_element(heights.begin(), middle, heights.end());
    level_ = std::max(*middle, base + options.clearance);
    ceiling_ =
        std::max(*std::max_element(heights.begin(), heights.end()), level_) + options.headroom;
    grid_ = make_sample_grid(samples_, options.max_grid);
  }

  bool has_samples() const { return !samples_.empty(); }

  /// Appends level planes that are possible everywhere: at the median height, and one just above
  /// the base for ground that an outline takes in.
  void add_stand_ins(PlaneChoice* choice) const {
    for (const double z : {level_, base_ + options_.clearance}) {
      choice->add({0.0, 0.0, z}, -1, everywhere());
    }
  }

  /// Divides the plan by what the planes have to do with each other, and labels the cells.
  std::optional<LabelledPlan> label(const PlanPolygon& outline, const PlaneChoice& choice,
                                    const ClosingOptions& options) {
    grid_labels_ = label_grid(grid_, samples_, choice.planes, choice.reaches, options, {});
    std::vector<PlanLine> lines =
        find_plan_lines(grid_, grid_labels_, choice.planes, outline, evidence_.traces, options);
    add_level_lines(choice, options, &lines);
    std::optional<PlanDivision> division = PlanDivision::make(outline, lines);
    if (!division) return std::nullopt;
    LabelledPlan labelled{outline, std::move(lines), std::move(*division), {}, 0.0};
    const LabelProblem problem = problem_of(labelled.division, choice, options);
    labelled.labels.assign(problem.num_sites(), 0);
    for (int c = 0; c < problem.num_sites(); ++c) {
      for (int l = 1; l < problem.num_labels; ++l) {
        if (problem.at(c, l) < problem.at(c, labelled.labels[c])) labelled.labels[c] = l;
      }
    }
    labelled.cost = expand_labels(problem, &labelled.labels);
    return labelled;
  }

  /// The planes refitted to the samples of their cells.
  std::vector<Plane> refitted(const LabelledPlan& labelled,
                              const std::vector<Plane>& planes) const {
    std::vector<Eigen::Vector3d> points;
    std::vector<std::vector<int>> members(planes.size());
    for (const HeightSample& sample : samples_) {
      const int cell = labelled.division.cell_at(sample.point.head<2>());
      if (cell >= 0) members[labelled.labels[cell]].push_back(static_cast<int>(points.size()));
      points.push_back(sample.point);
    }
    std::vector<int> fitted;
    std::vector<PlaneSupport> supports;
    std::vector<OrientedPlane> oriented;
    std::vector<PointMoments> moments;
    for (size_t i = 0; i < planes.size(); ++i) {
      PointMoments sums;
      if (!members[i].empty()) sums.reference = points[members[i].front()];
      PlaneSupport support;
      for (const int m : members[i]) {
        sums.add(points[m]);
        support.weights.push_back(samples_[m].weight);
      }
      if (!spans_a_plane(sums)) continue;
      support.members = std::move(members[i]);
      fitted.push_back(static_cast<int>(i));
      supports.push_back(std::move(support));
      moments.push_back(sums);
      const Eigen::Vector3d normal = Eigen::Vector3d(-planes[i].a, -planes[i].b, 1.0);
      oriented.emplace_back(normal.normalized(), planes[i].c / normal.norm());
    }
    std::vector<Plane> result = planes;
    if (fitted.empty()) return result;
    std::vector<PlaneRegularity> regularities =
        detect_regularities(oriented, moments, {}, options_.regularities);
    // The slope of a level plane has no direction to change it in.
    std::erase_if(regularities, [&](const PlaneRegularity& regularity) {
      return regularity.kind == RegularityKind::kEqualSlope &&
             (is_level(oriented[regularity.a]) || is_level(oriented[regularity.b]));
    });
    refine_planes(points, supports, regularities, options_.refinement, &oriented);
    for (size_t k = 0; k < fitted.size(); ++k) {
      const Eigen::Vector3d normal = oriented[k].normal();
      if (normal.z() < kLeastUp) continue;
      result[fitted[k]] = {-normal.x() / normal.z(), -normal.y() / normal.z(),
                           oriented[k].offset() / normal.z()};
    }
    return result;
  }

 private:
  /// The heights between which a plane may be the roof.
  double lowest(const PlaneChoice& choice, size_t plane, const ClosingOptions& options) const {
    return std::max(base_ + options.clearance, choice.reaches[plane].min().z());
  }
  double highest(const PlaneChoice& choice, size_t plane) const {
    return std::min(ceiling_, choice.reaches[plane].max().z());
  }

  /// Where the planes that are seen come down or rise to as far as they may: a cell must not reach
  /// beyond.
  void add_level_lines(const PlaneChoice& choice, const ClosingOptions& options,
                       std::vector<PlanLine>* lines) const {
    for (size_t i = 0; i < choice.planes.size(); ++i) {
      const Plane& plane = choice.planes[i];
      const Eigen::Vector2d slope(plane.a, plane.b);
      const int label = static_cast<int>(i);
      if (slope.norm() < kSteep) continue;
      if (std::find(grid_labels_.begin(), grid_labels_.end(), label) == grid_labels_.end()) {
        continue;
      }
      for (const double z : {lowest(choice, i, options) + kInside, highest(choice, i) - kInside}) {
        if (static_cast<int>(lines->size()) >= options.max_lines) return;
        PlanLine line{slope.normalized(), (z - plane.c) / slope.norm()};
        if (find_stretch(label, &line)) lines->push_back(line);
      }
    }
  }

  /// Sets the stretch of a line beside which grid cells of a label lie; whether there is one.
  bool find_stretch(int label, PlanLine* line) const {
    line->begin = std::numeric_limits<double>::infinity();
    line->end = -line->begin;
    for (int row = 0; row < grid_.rows; ++row) {
      for (int col = 0; col < grid_.cols; ++col) {
        if (grid_labels_[grid_.index(row, col)] != label) continue;
        const Eigen::Vector2d p = grid_.center(row, col);
        if (std::abs(line->signed_distance(p)) >= kNear) continue;
        line->begin = std::min(line->begin, line->along(p) - grid_.cell);
        line->end = std::max(line->end, line->along(p) + grid_.cell);
      }
    }
    return line->begin < line->end;
  }

  static bool is_level(const OrientedPlane& plane) {
    return plane.normal().head<2>().norm() < kLevel;
  }

  static bool spans_a_plane(const PointMoments& moments) {
    if (moments.weight < 3.0) return false;
    const Eigen::Matrix2d spread = moments.scatter().topLeftCorner<2, 2>();
    // The less spread of the two directions of the plan is more than a millimetre.
    const double half = 0.5 * spread.trace();
    const double less = half - std::sqrt(std::max(0.0, half * half - spread.determinant()));
    return less > 1e-6 * moments.weight;
  }

  LabelProblem problem_of(const PlanDivision& division, const PlaneChoice& choice,
                          const ClosingOptions& options) const {
    const std::vector<Plane>& planes = choice.planes;
    LabelProblem problem;
    problem.num_labels = static_cast<int>(planes.size());
    problem.impossible = kForbidden;
    problem.charges.assign(planes.size(), options.plane_charge);
    problem.data.assign(static_cast<size_t>(division.num_cells()) * planes.size(), 0.0);
    for (int c = 0; c < division.num_cells(); ++c) {
      const std::vector<Eigen::Vector2d> corners = division.corners(c);
      Eigen::Vector2d low = corners[0], high = low;
      for (const Eigen::Vector2d& p : corners) {
        low = low.cwiseMin(p);
        high = high.cwiseMax(p);
      }
      for (size_t l = 0; l < planes.size(); ++l) {
        const Eigen::AlignedBox3d& reach = choice.reaches[l];
        const bool near = (low.array() <= reach.max().head<2>().array()).all() &&
                          (high.array() >= reach.min().head<2>().array()).all();
        const double least = lowest(choice, l, options), most = highest(choice, l);
        const bool stands = near && std::all_of(corners.begin(), corners.end(), [&](const auto& p) {
                              const double z = planes[l].at(p);
                              return z >= least && z <= most;
                            });
        if (!stands) {
          problem.data[c * planes.size() + l] = kForbidden;
        }
      }
    }
    for (const HeightSample& sample : samples_) {
      const int cell = division.cell_at(sample.point.head<2>());
      if (cell < 0) continue;
      for (size_t l = 0; l < planes.size(); ++l) {
        double& cost = problem.data[cell * planes.size() + l];
        if (cost < kForbidden) cost += sample_cost(sample, planes[l], options.loss_scale);
      }
    }
    for (const CellBorder& border : division.borders()) {
      problem.pairs.push_back({border.a, border.b});
    }
    problem.pair_cost = [&division, &planes, options](int pair, int a, int b) {
      if (a == b) return 0.0;
      const CellBorder& border = division.borders()[pair];
      const double length = (border.to - border.from).norm();
      const double at_from = planes[a].at(border.from) - planes[b].at(border.from);
      const double at_to = planes[a].at(border.to) - planes[b].at(border.to);
      // Planes that meet along the border belong there: no shortcut beside it may be cheaper.
      const bool crease = std::max(std::abs(at_from), std::abs(at_to)) < kSameHeight;
      return (crease ? kCreaseShare : 1.0) * options.boundary_cost * length +
             options.step_cost * step_area(at_from, at_to, length);
    };
    return problem;
  }

  const double base_;
  const ClosingOptions& options_;
  const ClosingEvidence& evidence_;
  std::vector<HeightSample> samples_;  // inside the outline
  double level_ = 0.0, ceiling_ = 0.0;
  SampleGrid grid_;
  std::vector<int> grid_labels_;
};

PlanPolygon moved(const PlanPolygon& outline, double amplitude, Random* random) {
  PlanPolygon result = outline;
  const auto move = [&](std::vector<Eigen::Vector2d>* ring) {
    for (Eigen::Vector2d& p : *ring) {
      p += Eigen::Vector2d(random->uniform(-amplitude, amplitude),
                           random->uniform(-amplitude, amplitude));
    }
  };
  move(&result.outer);
  for (auto& hole : result.holes) move(&hole);
  return result;
}

bool finite(const Plane& plane) {
  return std::isfinite(plane.a) && std::isfinite(plane.b) && std::isfinite(plane.c);
}

ClosedPlanes failed(const std::string& reason) {
  ClosedPlanes closed;
  closed.reason = reason;
  return closed;
}

}  // namespace

ClosedPlanes close_planes(const PlanPolygon& outline, const std::vector<Plane>& planes,
                          const std::vector<HeightSample>& samples, double base,
                          const ClosingOptions& options, const ClosingEvidence& evidence) {
  CHECK(check(options).empty()) << check(options);
  CHECK(evidence.reaches.empty() || evidence.reaches.size() == planes.size());
  for (const HeightSample& sample : samples) {
    CHECK(sample.point.allFinite() && sample.weight > 0.0) << "samples are finite and weigh";
  }
  Closing closing(outline, samples, base, options, evidence);
  if (!closing.has_samples()) return failed("no heights inside the outline");

  PlaneChoice choice;
  for (size_t i = 0; i < planes.size(); ++i) {
    if (!finite(planes[i])) continue;
    choice.add(planes[i], static_cast<int>(i),
               evidence.reaches.empty() ? everywhere() : evidence.reaches[i]);
  }
  closing.add_stand_ins(&choice);
  std::optional<LabelledPlan> best = closing.label(outline, choice, options);
  if (!best) return failed("the outline cannot be divided");
  ClosedPlanes closed;
  closed.costs.push_back(best->cost);
  choice = used_planes(choice, &*best);
  for (int refit = 0; refit < options.max_refits; ++refit) {
    PlaneChoice next_choice = choice;
    next_choice.planes = closing.refitted(*best, choice.planes);
    std::optional<LabelledPlan> next = closing.label(outline, next_choice, options);
    if (!next || !(next->cost < best->cost * (1.0 - 1e-6))) break;
    best = std::move(next);
    choice = used_planes(next_choice, &*best);
    closed.costs.push_back(best->cost);
  }

  ClosingOptions dearer = options;
  for (int price = 0; price < kNumPrices; ++price) {
    for (int move = 0; move < kMovesPerPrice; ++move) {
      PlaneChoice moved_choice = choice;
      std::optional<LabelledPlan> labelled;
      if (price == 0 && move == 0) {
        labelled = best;
      } else {
        if (std::find(choice.origins.begin(), choice.origins.end(), -1) == choice.origins.end()) {
          closing.add_stand_ins(&moved_choice);
        }
        Random random(static_cast<uint64_t>(price * kMovesPerPrice + move));
        const double amplitude = kMove * move;
        for (Plane& plane : moved_choice.planes) plane.c += random.uniform(-amplitude, amplitude);
        labelled = closing.label(moved(outline, amplitude, &random), moved_choice, dearer);
        if (labelled) moved_choice = used_planes(moved_choice, &*labelled);
      }
      if (!labelled || labelled->cost >= kForbidden) continue;
      if (std::optional<MendedPlan> mended =
              mend_plan(std::move(*labelled), moved_choice, base, options.clearance)) {
        closed.roof = std::move(mended->roof);
        closed.solids = std::move(mended->solids);
        closed.origins = std::move(mended->origins);
        closed.cells = mended->cells;
        return closed;
      }
    }
    dearer.boundary_cost *= kDearer;
    dearer.step_cost *= kDearer;
    dearer.plane_charge *= kDearer;
  }
  return failed("no valid solid can be made of the planes");
}

}  // namespace gable
