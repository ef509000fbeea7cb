#pragma once

#include <ceres/cost_function.h>
#include <gable/grammar/house.h>
#include <gable/residuals/robust_loss.h>

#include <Eigen/Core>
#include <vector>

namespace gable {

/// How a house's footprint is compared with an outline.
struct OutlineOptions {
  double spacing = 0.5;     ///< metres between samples along the outline at most, (0, 100]
  double loss_scale = 0.3;  ///< soft L1 scale, metres, (0, 100]
  double weight = 1.0;      ///< of one metre of outline; > 0
};

/// Signed distance from a point to a rectangle [x0, x1] x [y0, y1], metres: negative inside. With
/// q = max(x0 - x, x - x1) and likewise for y, it is max(q_x, q_y) unless both are positive, when
/// the nearest point is a corner.
template <typename T>
T rectangle_distance(const T& x0, const T& x1, const T& y0, const T& y1, const T& x, const T& y) {
  using std::sqrt;
  const T left = x0 - x, right = x - x1, below = y0 - y, above = y - y1;
  const T& qx = left > right ? left : right;
  const T& qy = below > above ? below : above;
  if (qx > T(0.0) && qy > T(0.0)) return sqrt(qx * qx + qy * qy);
  return qx > qy ? qx : qy;
}

/// Pulls the edges of a house's components to a given outline (a cadastral footprint, say).
///
/// Samples p_i stand at the middles of equal pieces (of length l_i <= spacing) of the outline's
/// edges, local frame. One residual per sample, in outline order:
///   r_i = sqrt(weight * l_i) * robust(d(p_i)),   d = min over components of rectangle_distance,
/// in metres times sqrt(metres of outline times weight). d is taken in the house frame, where the
/// components are rectangles; turning by the azimuth moves the sample points. Outside the union d
/// is the exact distance; inside it is exact up to seams between components, where it is nearer to
/// zero. An outline that the house does not reach gives positive distances, one it reaches over
/// gives negative ones, so both are pulled back.
/// The derivative is exact except on the rectangles' medial axes, at equal distance to two
/// components and at the corners of the outside: a set of measure zero.
/// Parameter blocks: the azimuth, then the footprint rules, i.e. the first rules of
/// House::derivation(). The robust loss is inside: add it to a problem without one.
class OutlineToFootprint : public ceres::CostFunction {
 public:
  /// outline: vertices in the local frame, metres, either orientation, the first not repeated.
  OutlineToFootprint(const House& house, const std::vector<Eigen::Vector2d>& outline,
                     const OutlineOptions& options);

  bool Evaluate(double const* const* parameters, double* residuals,
                double** jacobians) const override;

 private:
  struct Sample {
    Eigen::Vector2d local;
    double root_weight;
  };

  House house_;
  RobustLoss loss_;
  std::vector<Sample> samples_;
};

}  // namespace gable
