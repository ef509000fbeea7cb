#include <gable/engine/reconstruct/heights/rectified_view.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace gable {

RectifiedView rectify(const HeightImage& image, double azimuth, double cell, double margin) {
  RectifiedView view;
  view.azimuth = azimuth;
  view.cell = cell;
  view.spread = image.spread;
  const double cosine = std::cos(azimuth), sine = std::sin(azimuth);
  double x_min = std::numeric_limits<double>::infinity(), x_max = -x_min;
  double y_min = x_min, y_max = -x_min;
  for (int row = 0; row < image.rows; ++row) {
    for (int col = 0; col < image.cols; ++col) {
      if (!image.inside[image.index(row, col)]) continue;
      const Eigen::Vector2d p = image.center_of(row, col);
      const double x = cosine * p.x() + sine * p.y(), y = -sine * p.x() + cosine * p.y();
      x_min = std::min(x_min, x);
      x_max = std::max(x_max, x);
      y_min = std::min(y_min, y);
      y_max = std::max(y_max, y);
    }
  }
  if (x_min > x_max) return view;
  view.x0 = x_min - margin;
  view.y0 = y_min - margin;
  view.cols = static_cast<int>(std::ceil((x_max + margin - view.x0) / cell));
  view.rows = static_cast<int>(std::ceil((y_max + margin - view.y0) / cell));
  const size_t n = static_cast<size_t>(view.rows) * view.cols;
  view.height.assign(n, 0.0f);
  view.ground.assign(n, 0.0f);
  view.weight.assign(n, 0.0f);
  view.inside.assign(n, 0);
  for (int row = 0; row < view.rows; ++row) {
    for (int col = 0; col < view.cols; ++col) {
      const double x = view.x_edge(col) + 0.5 * cell, y = view.y_edge(row) + 0.5 * cell;
      const double local_x = cosine * x - sine * y, local_y = sine * x + cosine * y;
      const int c = static_cast<int>(std::lround((local_x - image.first_center.x()) / image.gsd));
      const int r = static_cast<int>(std::lround((image.first_center.y() - local_y) / image.gsd));
      if (c < 0 || c >= image.cols || r < 0 || r >= image.rows) continue;
      const size_t from = image.index(r, c), to = view.index(row, col);
      view.height[to] = image.height[from];
      view.ground[to] = image.ground[from];
      view.weight[to] = image.weight[from];
      view.inside[to] = image.inside[from];
    }
  }
  return view;
}

}  // namespace gable
