#include <gable/residuals/layered_sample.h>

#include <algorithm>

namespace gable {
namespace {

// Points of a rectangle as shares of its sides, and what each counts.
struct SamplePoints {
  int count;
  std::array<std::array<double, 2>, 4> share;
};

constexpr double kG0 = kGaussPoints[0], kG1 = kGaussPoints[1];
constexpr SamplePoints kCentroidPoint = {1, {{{0.5, 0.5}}}};
constexpr SamplePoints kMeanPoints = {4, {{{kG0, kG0}, {kG0, kG1}, {kG1, kG0}, {kG1, kG1}}}};

const SamplePoints& points_of(RoofSampling sampling) {
  return sampling == RoofSampling::kMean ? kMeanPoints : kCentroidPoint;
}

double along(double from, double to, double share) { return from + (to - from) * share; }

// Means are rare. Out of line, they cost first returns nothing.
[[gnu::noinline]] void sample_mean(const Block<double>& block, SeenLayer* layer) {
  const CoveredPart<double>& part = layer->part;
  layer->height = 0.0;
  for (int i = 0; i < kMeanPoints.count; ++i) {
    const double x = along(part.x0, part.x1, kMeanPoints.share[i][0]);
    const double y = along(part.y0, part.y1, kMeanPoints.share[i][1]);
    layer->facets[i] = roof_facet<double, double>(block, x, y);
    layer->height += facet_height<double, double>(block, layer->facets[i], x, y);
  }
  layer->height /= kMeanPoints.count;
}

}  // namespace

SeenLayers seen_layers(const std::vector<Block<double>>& blocks,
                       std::span<const ColumnRange> ranges, int column, double x, double y,
                       double support, RoofSampling sampling) {
  using namespace block_value;
  SeenLayers seen;
  seen.sampling = sampling;
  const double half = 0.5 * support;
  const double x_low = x - half, x_high = x + half, y_low = y - half, y_high = y + half;
  for (int b = 0; b < static_cast<int>(blocks.size()); ++b) {
    if (column < ranges[b].begin || column >= ranges[b].end) continue;
    const Block<double>& block = blocks[b];
    SeenLayer layer;
    layer.cut = {x_low<block[kX0], x_high> block[kX1], y_low<block[kY0], y_high> block[kY1]};
    layer.part = {layer.cut[0] ? block[kX0] : x_low, layer.cut[1] ? block[kX1] : x_high,
                  layer.cut[2] ? block[kY0] : y_low, layer.cut[3] ? block[kY1] : y_high};
    if (layer.part.empty()) continue;
    layer.block = b;
    if (sampling == RoofSampling::kMean) [[unlikely]] {
      sample_mean(block, &layer);
    } else {
      const double center_x = 0.5 * (layer.part.x0 + layer.part.x1);
      const double center_y = 0.5 * (layer.part.y0 + layer.part.y1);
      layer.facets[0] = roof_facet<double, double>(block, center_x, center_y);
      layer.height = facet_height<double, double>(block, layer.facets[0], center_x, center_y);
    }
    int at = seen.count;
    while (at > 0 && seen.layers[at - 1].height < layer.height) --at;
    if (at == kMaxLayers) continue;
    seen.count = std::min(seen.count + 1, kMaxLayers);
    for (int i = seen.count - 1; i > at; --i) seen.layers[i] = seen.layers[i - 1];
    seen.layers[at] = layer;
  }
  for (int k = 0; k < seen.count; ++k) {
    const auto& cut = seen.layers[k].cut;
    if (cut[0] || cut[1] || cut[2] || cut[3]) continue;
    seen.count = k + 1;
    seen.top_only = k == 0;
  }
  return seen;
}

double layered_mean(const SeenLayers& seen, const LayerValues& values, double support,
                    const FacetGradients* gradients, BlockGradient* derivatives) {
  const double inverse_area = 1.0 / (support * support);
  // d mean / d edge of each layer's covered part.
  std::array<std::array<double, 4>, kMaxLayers> edges{};
  double total = values.ground;
  for (int k = 0; k < seen.count; ++k) {
    const SeenLayer& layer = seen.layers[k];
    const double gain = (values.value[k] - values.ground) * inverse_area;
    double visible = 0.0;
    for (int set = 0; set < (1 << k); ++set) {
      CoveredPart<double> common = layer.part;
      std::array<int, 4> owner = {k, k, k, k};
      double sign = 1.0;
      for (int j = 0; j < k; ++j) {
        if (!(set & (1 << j))) continue;
        const CoveredPart<double>& part = seen.layers[j].part;
        if (common.x0 < part.x0) common.x0 = part.x0, owner[0] = j;
        if (common.x1 > part.x1) common.x1 = part.x1, owner[1] = j;
        if (common.y0 < part.y0) common.y0 = part.y0, owner[2] = j;
        if (common.y1 > part.y1) common.y1 = part.y1, owner[3] = j;
        sign = -sign;
      }
      if (common.empty()) continue;
      const double size_x = common.x1 - common.x0, size_y = common.y1 - common.y0;
      visible += sign * size_x * size_y;
      edges[owner[0]][0] -= sign * gain * size_y;
      edges[owner[1]][1] += sign * gain * size_y;
      edges[owner[2]][2] -= sign * gain * size_x;
      edges[owner[3]][3] += sign * gain * size_x;
    }
    total += gain * visible;
    if (derivatives == nullptr) continue;
    const SamplePoints& points = points_of(seen.sampling);
    const double by_height = visible * inverse_area * values.by_height[k] / points.count;
    derivatives[k].setZero();
    for (int i = 0; i < points.count; ++i) {
      const FacetGradient& gradient = (*gradients)[layer.block][static_cast<int>(layer.facets[i])];
      const auto [u, v] = points.share[i];
      derivatives[k] += by_height * gradient.at(along(layer.part.x0, layer.part.x1, u),
                                                along(layer.part.y0, layer.part.y1, v));
      const double by_x = by_height * gradient.slope.x();
      const double by_y = by_height * gradient.slope.y();
      edges[k][0] += (1.0 - u) * by_x;
      edges[k][1] += u * by_x;
      edges[k][2] += (1.0 - v) * by_y;
      edges[k][3] += v * by_y;
    }
  }
  if (derivatives == nullptr) return total;
  static_assert(block_value::kX0 == 0 && block_value::kX1 == 1 && block_value::kY0 == 2 &&
                block_value::kY1 == 3);
  for (int k = 0; k < seen.count; ++k) {
    for (int e = 0; e < 4; ++e) {
      if (seen.layers[k].cut[e]) derivatives[k][e] += edges[k][e];
    }
  }
  return total;
}

LayerValues layer_costs(const SeenLayers& seen, const RobustLoss& loss, double ground,
                        double height) {
  LayerValues values;
  values.ground = loss.cost(ground - height);
  for (int k = 0; k < seen.count; ++k) {
    double robust, slope;
    loss.evaluate(seen.layers[k].height - height, &robust, &slope);
    values.value[k] = robust * robust;
    values.by_height[k] = 2.0 * robust * slope;
  }
  return values;
}

LayerValues layer_heights(const SeenLayers& seen, double ground) {
  LayerValues values;
  values.ground = ground;
  for (int k = 0; k < seen.count; ++k) {
    values.value[k] = seen.layers[k].height;
    values.by_height[k] = 1.0;
  }
  return values;
}

}  // namespace gable
