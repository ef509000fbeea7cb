#include <gable/engine/reconstruct/heights/raster_noise.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace gable {
namespace {

// Nine heights about their plane have six degrees of freedom.
constexpr double kMedianOfChiSquared = 5.348;

}  // namespace

double raster_noise(const HeightImage& image) {
  std::vector<double> squares;
  for (int row = 1; row + 1 < image.rows; ++row) {
    for (int col = 1; col + 1 < image.cols; ++col) {
      const double middle = image.height[image.index(row, col)];
      double sum = 0.0, by_row = 0.0, by_col = 0.0, all = 0.0;
      bool seen = true;
      for (int dr = -1; dr <= 1; ++dr) {
        for (int dc = -1; dc <= 1; ++dc) {
          const size_t i = image.index(row + dr, col + dc);
          seen = seen && image.inside[i] && is_evidence(image, i);
          const double h = image.height[i] - middle;
          sum += h;
          by_row += dr * h;
          by_col += dc * h;
          all += h * h;
        }
      }
      // The three numbers of a plane are orthogonal on the grid.
      const double rest = all - sum * sum / 9.0 - by_row * by_row / 6.0 - by_col * by_col / 6.0;
      if (seen) squares.push_back(std::max(0.0, rest));
    }
  }
  if (squares.empty()) return 0.0;
  const auto middle = squares.begin() + static_cast<std::ptrdiff_t>(squares.size() / 2);
  std::nth_element(squares.begin(), middle, squares.end());
  return std::sqrt(*middle / kMedianOfChiSquared);
}

}  // namespace gable
