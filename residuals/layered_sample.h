#pragma once

#include <gable/grammar/height_field.h>
#include <gable/residuals/facet_gradient.h>
#include <gable/residuals/robust_loss.h>

#include <array>
#include <span>
#include <vector>

namespace gable {

/// Columns [begin, end) of an image row in which a block can be seen.
struct ColumnRange {
  int begin = 0;
  int end = 0;
};

/// A block as one sample sees it, with what its derivatives need.
struct SeenLayer {
  int block = -1;
  double height = 0.0;  ///< of the roof over the covered part, metres
  /// The facets at the points that the height is taken from: the centroid's alone, or those at
  /// kGaussPoints in x by kGaussPoints in y.
  std::array<Facet, 4> facets{};
  CoveredPart<double> part;   ///< of the support, house frame
  std::array<bool, 4> cut{};  ///< whether part.x0, x1, y0, y1 are the block's edges
};

/// The blocks that a sample sees, highest first: the choice of `layers_at`, less what lies below a
/// block that covers the whole support.
struct SeenLayers {
  int count = 0;
  bool top_only = false;  ///< the highest block covers the whole support
  RoofSampling sampling = RoofSampling::kCentroid;
  std::array<SeenLayer, kMaxLayers> layers;
};

/// support > 0. Only blocks whose range holds `column` are looked at.
SeenLayers seen_layers(const std::vector<Block<double>>& blocks,
                       std::span<const ColumnRange> ranges, int column, double x, double y,
                       double support, RoofSampling sampling);

/// The only facet that a sample sees, if it is only one.
inline bool sees_one_facet(const SeenLayers& seen) {
  if (!seen.top_only || seen.sampling == RoofSampling::kCentroid) return seen.top_only;
  const auto& f = seen.layers[0].facets;
  return f[0] == f[1] && f[0] == f[2] && f[0] == f[3];
}

using BlockGradient = Eigen::Matrix<double, kNumBlockValues, 1>;
/// The facets' gradients of every block, by facet.
using FacetGradients = std::vector<std::array<FacetGradient, kNumFacets>>;

/// Something that each layer of a sample and the ground have, in their order.
struct LayerValues {
  double ground = 0.0;
  std::array<double, kMaxLayers> value{};
  std::array<double, kMaxLayers> by_height{};  ///< d value / d height of the layer
};

/// What a sample costs by each layer, square metres: rho(z_k - height).
LayerValues layer_costs(const SeenLayers& seen, const RobustLoss& loss, double ground,
                        double height);

/// The layers' heights themselves, metres.
LayerValues layer_heights(const SeenLayers& seen, double ground);

/// The mean of the values over the support: ground + sum_k (value_k - ground) a_k / support^2 with
/// the visible areas a_k. Where `derivatives` is not null, derivatives[k] is set to d mean /
/// d (values of the block of layer k).
///
/// The derivatives are written out because this is the innermost loop of every refinement; they are
/// tested against automatic differentiation of layers_at. A visible area is a signed sum of areas
/// of rectangles common to covered parts, each of whose edges belongs to one part; moving it sweeps
/// the rectangle's other extent. Heights change with the block's values and with the points that
/// they are taken at; these follow a cut edge, the centroid half as fast as it moves.
double layered_mean(const SeenLayers& seen, const LayerValues& values, double support,
                    const FacetGradients* gradients, BlockGradient* derivatives);

}  // namespace gable
