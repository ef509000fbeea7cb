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
  Facet facet = Facet::kFlat;
  double height = 0.0;        ///< at the centroid of the covered part, metres
  CoveredPart<double> part;   ///< of the support, house frame
  std::array<bool, 4> cut{};  ///< whether part.x0, x1, y0, y1 are the block's edges
};

/// The blocks that a sample sees, highest first: the choice of `layers_at`, less what lies below a
/// block that covers the whole support.
struct SeenLayers {
  int count = 0;
  bool top_only = false;  ///< the highest block covers the whole support
  std::array<SeenLayer, kMaxLayers> layers;
};

/// support > 0. Only blocks whose range holds `column` are looked at.
SeenLayers seen_layers(const std::vector<Block<double>>& blocks,
                       std::span<const ColumnRange> ranges, int column, double x, double y,
                       double support);

using BlockGradient = Eigen::Matrix<double, kNumBlockValues, 1>;
/// The facets' gradients of every block, by facet.
using FacetGradients = std::vector<std::array<FacetGradient, kNumFacets>>;

/// E(p) of a sample (see HouseHeightEvaluator) over the layers it sees, square metres. Where
/// `derivatives` is not null, derivatives[k] is set to d E / d (values of the block of layer k).
///
/// The derivatives are written out because this is the innermost loop of every refinement; they are
/// tested against automatic differentiation of layers_at. With rho_k the losses and a_k the
/// visible areas, E = rho_ground + sum_k (rho_k - rho_ground) a_k / support^2. A visible area is a
/// signed sum of areas of rectangles common to covered parts, each of whose edges belongs to one
/// part; moving it sweeps the rectangle's other extent. Heights change with the block's values and,
/// half as fast as a cut edge, with the centroid of the covered part.
double layered_cost(const SeenLayers& seen, const RobustLoss& loss, double ground, double height,
                    double support, const FacetGradients* gradients, BlockGradient* derivatives);

}  // namespace gable
