#include <gable/residuals/layered_sample.h>

#include <algorithm>

namespace gable {

SeenLayers seen_layers(const std::vector<Block<double>>& blocks,
                       std::span<const ColumnRange> ranges, int column, double x, double y,
                       double support) {
  using namespace block_value;
  SeenLayers seen;
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
    const double center_x = 0.5 * (layer.part.x0 + layer.part.x1);
    const double center_y = 0.5 * (layer.part.y0 + layer.part.y1);
    layer.facet = roof_facet<double, double>(block, center_x, center_y);
    layer.height = facet_height<double, double>(block, layer.facet, center_x, center_y);
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

double layered_cost(const SeenLayers& seen, const RobustLoss& loss, double ground, double height,
                    double support, const FacetGradients* gradients, BlockGradient* derivatives) {
  const double inverse_area = 1.0 / (support * support);
  const double ground_cost = loss.cost(ground - height);
  // d E / d edge of each layer's covered part.
  std::array<std::array<double, 4>, kMaxLayers> edges{};
  double total = ground_cost;
  for (int k = 0; k < seen.count; ++k) {
    const SeenLayer& layer = seen.layers[k];
    double robust, slope;
    loss.evaluate(layer.height - height, &robust, &slope);
    const double gain = (robust * robust - ground_cost) * inverse_area;
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
    const FacetGradient& gradient = (*gradients)[layer.block][static_cast<int>(layer.facet)];
    const double by_height = visible * inverse_area * 2.0 * robust * slope;
    derivatives[k] = by_height * gradient.at(0.5 * (layer.part.x0 + layer.part.x1),
                                             0.5 * (layer.part.y0 + layer.part.y1));
    const double by_x = 0.5 * by_height * gradient.slope.x();
    const double by_y = 0.5 * by_height * gradient.slope.y();
    edges[k][0] += by_x;
    edges[k][1] += by_x;
    edges[k][2] += by_y;
    edges[k][3] += by_y;
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

}  // namespace gable
