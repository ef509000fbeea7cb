#include <gable/engine/detectors/component_heights.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace gable {
namespace {

// The middle value; the lower one of two. `values` are not empty and get reordered.
double median(std::vector<double>* values) {
  const auto middle = values->begin() + (values->size() - 1) / 2;
  std::nth_element(values->begin(), middle, values->end());
  return *middle;
}

// Calls visit(pixel) for a pixel and those around it that the image has.
template <typename Visit>
void for_neighbourhood(const HeightImage& image, int row, int col, Visit visit) {
  for (int r = std::max(0, row - 1); r <= std::min(image.rows - 1, row + 1); ++r) {
    for (int c = std::max(0, col - 1); c <= std::min(image.cols - 1, col + 1); ++c) {
      visit(image.index(r, c));
    }
  }
}

template <typename Iterator>
double mean(Iterator first, Iterator last) {
  return std::accumulate(first, last, 0.0) / static_cast<double>(last - first);
}

}  // namespace

std::optional<ComponentHeights> component_heights(const HeightImage& image,
                                                  const TurnedRectangle& rectangle,
                                                  double least_height) {
  const double cosine = std::cos(rectangle.azimuth), sine = std::sin(rectangle.azimuth);
  const double half = 0.5 * image.gsd;
  std::vector<unsigned char> member(image.size(), 0);
  for (int row = 0; row < image.rows; ++row) {
    for (int col = 0; col < image.cols; ++col) {
      const size_t pixel = image.index(row, col);
      if (!is_evidence(image, pixel)) continue;
      if (!(image.height[pixel] - image.ground[pixel] >= least_height)) continue;
      const Eigen::Vector2d p = image.center_of(row, col);
      const double x = cosine * p.x() + sine * p.y(), y = -sine * p.x() + cosine * p.y();
      member[pixel] = x >= rectangle.x0 + half && x <= rectangle.x1 - half &&
                      y >= rectangle.y0 + half && y <= rectangle.y1 - half;
    }
  }
  std::vector<double> heights, ground, around;
  for (int row = 0; row < image.rows; ++row) {
    for (int col = 0; col < image.cols; ++col) {
      const size_t pixel = image.index(row, col);
      if (!member[pixel]) continue;
      around.clear();
      for_neighbourhood(image, row, col, [&](size_t other) {
        if (member[other]) around.push_back(image.height[other] - image.ground[other]);
      });
      heights.push_back(median(&around));
      ground.push_back(image.ground[pixel]);
    }
  }
  if (heights.empty()) return std::nullopt;
  std::sort(heights.begin(), heights.end());
  const auto share = [&](double part) {
    return std::max<std::ptrdiff_t>(1, std::lround(part * static_cast<double>(heights.size())));
  };
  const double terrain = median(&ground);
  ComponentHeights out;
  out.eaves = terrain + mean(heights.begin(), heights.begin() + share(0.1));
  out.middle = terrain + heights[(heights.size() - 1) / 2];
  out.top = terrain + mean(heights.end() - share(0.05), heights.end());
  return out;
}

std::optional<double> height_near(const HeightImage& image, const Eigen::Vector2d& local) {
  const double col = std::round((local.x() - image.first_center.x()) / image.gsd);
  const double row = std::round((image.first_center.y() - local.y()) / image.gsd);
  if (!(row >= 0.0 && row < image.rows && col >= 0.0 && col < image.cols)) return std::nullopt;
  std::vector<double> around;
  for_neighbourhood(image, static_cast<int>(row), static_cast<int>(col), [&](size_t pixel) {
    if (is_evidence(image, pixel)) around.push_back(image.height[pixel]);
  });
  if (around.empty()) return std::nullopt;
  return median(&around);
}

}  // namespace gable
