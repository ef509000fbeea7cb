#include <gable/engine/reconstruct/first_values/roof_fit.h>
#include <gable/residuals/robust_loss.h>

#include <algorithm>
#include <cmath>

namespace gable {
namespace {

constexpr int kReweightings = 4;
constexpr double kLeastRise = 0.25;

// Mean robust cost of a cell that fits, square metres.
constexpr double kNoiseCost = 0.02;

// Cells whose means reach over the edge of a rectangle.
struct Rim {
  double share = 1.0;  // of the mean that lies in the rectangle, should a wall stand there
  bool reaches_over = false;
};

Rim rim_at(double x, double y, double size_x, double size_y, double spread) {
  const double to_edge = std::min(std::min(x, size_x - x), std::min(y, size_y - y));
  if (to_edge >= 0.5 * spread) return {};
  return {0.5 + to_edge / spread, true};
}

// One candidate shape: 0 at the eaves, 1 at the ridge.
double shape_at(double u, double v, double length, double width, double start_run, double end_run) {
  double t = std::min(v, width - v) / (0.5 * width);
  if (start_run > 0.0) t = std::min(t, u / start_run);
  if (end_run > 0.0) t = std::min(t, (length - u) / end_run);
  return t;
}

Rule roof_rule(const RoofFit& fit) {
  Rule rule = make_rule(fit.flat ? RuleKind::kRoofFlat : RuleKind::kRoofHip);
  rule.ridge = fit.ridge;
  rule[param::roof::kEaves] = std::max(fit.eaves, 1.0);
  if (!fit.flat) {
    rule[param::roof::kRise] = fit.rise;
    // The paper's common 0.1 where the fit sees a gable: a ratio of 0 has no derivative.
    rule[param::roof::kHipStart] = std::max(fit.hip_start, 0.1);
    rule[param::roof::kHipEnd] = std::max(fit.hip_end, 0.1);
  }
  return rule;
}

}  // namespace

RoofFit fit_roof(const RectifiedView& view, const CellRectangle& rectangle, Axis ridge,
                 double loss_scale, double rise_penalty) {
  const RobustLoss loss(LossKind::kSoftL1, loss_scale);
  const int n = rectangle.cols() * rectangle.rows();
  const bool along_x = ridge == Axis::kX;
  const double length = (along_x ? rectangle.cols() : rectangle.rows()) * view.cell;
  const double width = (along_x ? rectangle.rows() : rectangle.cols()) * view.cell;
  const double hip_run = std::min(0.5 * width, 0.5 * length);

  std::vector<double> z(n), w(n), t(n);
  std::vector<Rim> rim(n);
  double ground_cost = 0.0;
  bool has_middle = false;
  int k = 0;
  for (int row = rectangle.row0; row < rectangle.row1; ++row) {
    for (int col = rectangle.col0; col < rectangle.col1; ++col, ++k) {
      const size_t i = view.index(row, col);
      rim[k] =
          rim_at((col - rectangle.col0 + 0.5) * view.cell, (row - rectangle.row0 + 0.5) * view.cell,
                 rectangle.cols() * view.cell, rectangle.rows() * view.cell, view.spread);
      has_middle |= !rim[k].reaches_over;
      z[k] = view.height[i];
      w[k] = view.weight[i];
      ground_cost += w[k] * loss.cost(static_cast<double>(view.ground[i]) - z[k]);
    }
  }

  // What a cell costs under a roof: at an outer wall its mean is of roof and ground, at a wall
  // between two blocks of roofs alone, and which of them it is will be seen later.
  const auto cost_under = [&](int i, double roof, double ground) {
    const double cost = loss.cost(roof - z[i]);
    if (!rim[i].reaches_over) return cost;
    return std::min(cost, loss.cost(ground + rim[i].share * (roof - ground) - z[i]));
  };
  const auto ground_at = [&](int i) {
    return static_cast<double>(view.ground[view.index(rectangle.row0 + i / rectangle.cols(),
                                                      rectangle.col0 + i % rectangle.cols())]);
  };

  RoofFit best;
  best.rectangle = rectangle;
  best.cost = 1e300;
  double best_penalised = 1e300;
  // shape 0: flat; 1: gable; 2, 3: one hip; 4: both.
  for (int shape = 0; shape < 5; ++shape) {
    // A gable that leaves nothing but noise needs no hips.
    if (shape > 1 && !best.flat && best.cost < kNoiseCost * n) break;
    const double start_run = shape == 2 || shape == 4 ? hip_run : 0.0;
    const double end_run = shape == 3 || shape == 4 ? hip_run : 0.0;
    k = 0;
    for (int row = 0; row < rectangle.rows(); ++row) {
      for (int col = 0; col < rectangle.cols(); ++col, ++k) {
        const double x = (col + 0.5) * view.cell, y = (row + 0.5) * view.cell;
        t[k] = shape == 0
                   ? 0.0
                   : shape_at(along_x ? x : y, along_x ? y : x, length, width, start_run, end_run);
      }
    }
    double eaves = 0.0, rise = 0.0;
    for (int pass = 0; pass < kReweightings; ++pass) {
      double s = 0.0, st = 0.0, stt = 0.0, sz = 0.0, stz = 0.0;
      for (int i = 0; i < n; ++i) {
        double weight = has_middle && rim[i].reaches_over ? 0.0 : w[i];
        if (pass > 0) {
          const double r = (eaves + rise * t[i] - z[i]) / loss_scale;
          weight /= std::sqrt(1.0 + r * r);
        }
        s += weight;
        st += weight * t[i];
        stt += weight * t[i] * t[i];
        sz += weight * z[i];
        stz += weight * t[i] * z[i];
      }
      if (!(s > 0.0)) break;
      const double determinant = s * stt - st * st;
      if (shape == 0 || determinant < 1e-9 * s * s) {
        eaves = sz / s;
        rise = 0.0;
      } else {
        rise = (s * stz - st * sz) / determinant;
        eaves = (sz - rise * st) / s;
      }
    }
    if (shape > 0 && rise < kLeastRise) continue;
    double cost = 0.0;
    for (int i = 0; i < n; ++i) cost += w[i] * cost_under(i, eaves + rise * t[i], ground_at(i));
    const double penalised =
        cost + rise_penalty * (shape == 0 ? 0.0 : 1.0 + (start_run > 0.0) + (end_run > 0.0));
    if (penalised < best_penalised) {
      best_penalised = penalised;
      best.cost = cost;
      best.ridge = ridge;
      best.flat = shape == 0;
      best.eaves = eaves;
      best.rise = rise;
      best.hip_start = start_run / length;
      best.hip_end = end_run / length;
      best.heights.resize(n);
      for (int i = 0; i < n; ++i) best.heights[i] = static_cast<float>(eaves + rise * t[i]);
    }
  }
  best.gain = ground_cost - best.cost;
  best.gains.resize(n);
  for (int i = 0; i < n; ++i) {
    const double ground = ground_at(i);
    best.gains[i] = static_cast<float>(
        w[i] * (loss.cost(ground - z[i]) - cost_under(i, best.heights[i], ground)));
  }
  return best;
}

RoofedRectangle roofed_rectangle(const RectifiedView& view, const RoofFit& fit) {
  const CellRectangle& r = fit.rectangle;
  return {view.x_edge(r.col0), view.x_edge(r.col1), view.y_edge(r.row0), view.y_edge(r.row1),
          roof_rule(fit)};
}

}  // namespace gable
