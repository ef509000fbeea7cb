#include <gable/engine/scales/outline/raster_outline.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <opencv2/imgproc.hpp>
#include <utility>

namespace gable {
namespace {

constexpr float kLeastHalfWidth = 0.8f;  ///< pixels, of a region that is kept
constexpr double kClearOfPixels = 1e-3;  ///< so that rings never share a corner

/// Marching squares: the lines where a field crosses 0, the positive side on their left. Edges
/// between pixels are numbered 2 i (to the right of pixel i) and 2 i + 1 (to the row after it).
class Contours {
 public:
  explicit Contours(const cv::Mat1f& field)
      : field_(field), next_(2 * static_cast<size_t>(field.total()), -1) {
    for (int y = 0; y + 1 < field_.rows; ++y) {
      for (int x = 0; x + 1 < field_.cols; ++x) link(x, y);
    }
  }

  struct Contour {
    Ring ring;
    cv::Point inside;  ///< a pixel on the positive side
  };

  std::vector<Contour> trace() {
    std::vector<Contour> contours;
    for (size_t start = 0; start < next_.size(); ++start) {
      if (next_[start] < 0) continue;
      Contour contour;
      contour.inside = inside(start);
      for (int64_t edge = static_cast<int64_t>(start); edge >= 0;) {
        contour.ring.push_back(crossing(edge));
        edge = std::exchange(next_[edge], -1);
      }
      contour.ring.pop_back();
      contours.push_back(std::move(contour));
    }
    return contours;
  }

 private:
  bool positive(const cv::Point& p) const { return field_(p) > 0.0f; }

  void link(int x, int y) {
    const std::array<cv::Point, 4> corner = {{{x, y}, {x + 1, y}, {x + 1, y + 1}, {x, y + 1}}};
    std::array<bool, 4> in;
    for (int i = 0; i < 4; ++i) in[i] = positive(corner[i]);
    if (in[0] == in[1] && in[1] == in[2] && in[2] == in[3]) return;
    const int64_t i = static_cast<int64_t>(y) * field_.cols + x;
    const std::array<int64_t, 4> edge = {2 * i, 2 * (i + 1) + 1, 2 * (i + field_.cols), 2 * i + 1};
    // Each run of positive corners is cut off by one line; opposite corners are two runs.
    for (int last = 0; last < 4; ++last) {
      if (!in[last] || in[(last + 1) % 4]) continue;
      int first = last;
      while (in[(first + 3) % 4]) first = (first + 3) % 4;
      next_[edge[last]] = static_cast<int32_t>(edge[(first + 3) % 4]);
    }
  }

  std::pair<cv::Point, cv::Point> ends(int64_t edge) const {
    const cv::Point a(static_cast<int>(edge / 2 % field_.cols),
                      static_cast<int>(edge / 2 / field_.cols));
    return {a, edge % 2 == 0 ? a + cv::Point(1, 0) : a + cv::Point(0, 1)};
  }

  cv::Point inside(int64_t edge) const {
    const auto [a, b] = ends(edge);
    return positive(a) ? a : b;
  }

  Eigen::Vector2d crossing(int64_t edge) const {
    const auto [a, b] = ends(edge);
    const double fa = field_(a), fb = field_(b);
    const double t = std::clamp(fa / (fa - fb), kClearOfPixels, 1.0 - kClearOfPixels);
    return {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)};
  }

  const cv::Mat1f& field_;
  std::vector<int32_t> next_;  ///< the edge that the line goes on to, or -1
};

/// Distance (pixels) to the outside of the closing, less `inset`; positive inside.
cv::Mat1f closing_field(const cv::Mat& mask, double radius, double inset) {
  cv::Mat1f distance;
  const cv::Mat unmarked = mask == 0;
  cv::distanceTransform(unmarked, distance, cv::DIST_L2, cv::DIST_MASK_PRECISE);
  const cv::Mat dilated = distance <= radius;
  cv::distanceTransform(dilated, distance, cv::DIST_L2, cv::DIST_MASK_PRECISE);
  // The outside begins half a pixel before the first pixel outside.
  distance -= radius + 0.5 + inset;
  return distance;
}

}  // namespace

std::vector<OutlinedRegion> outlines_of_closing(const cv::Mat& mask, double radius, double inset,
                                                double tolerance) {
  const cv::Mat1f field = closing_field(mask, radius, inset);
  // Lines part at opposite corners, so regions are connected by edges alone.
  cv::Mat1i region_at;
  const cv::Mat positive = field > 0.0f;
  const int num_regions = cv::connectedComponents(positive, region_at, 4, CV_32S);
  std::vector<float> half_width(num_regions, 0.0f);
  for (int y = 0; y < field.rows; ++y) {
    for (int x = 0; x < field.cols; ++x) {
      float& widest = half_width[region_at(y, x)];
      widest = std::max(widest, field(y, x));
    }
  }
  std::vector<std::vector<Ring>> rings(num_regions);
  for (Contours::Contour& contour : Contours(field).trace()) {
    const int region = region_at(contour.inside);
    if (half_width[region] + inset < kLeastHalfWidth) continue;
    rings[region].push_back(std::move(contour.ring));
  }
  std::vector<OutlinedRegion> regions;
  for (const std::vector<Ring>& traced : rings) {
    OutlinedRegion region;
    for (Ring& ring : simplified(traced, tolerance)) {
      const double area = signed_area(ring);
      region.area += area;
      if (area > 0.0) {
        region.outer = std::move(ring);
      } else {
        region.holes.push_back(std::move(ring));
      }
    }
    if (!region.outer.empty() && region.area > 0.0) regions.push_back(std::move(region));
  }
  return regions;
}

}  // namespace gable
