#include <gable/engine/reconstruct/finding/vegetation.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <opencv2/imgproc.hpp>

namespace gable {
namespace {

// Root mean square deviation from the plane fitted to the 3 x 3 pixels around (row, col), `step`
// apart; infinite at the border.
float plane_deviation(const HeightImage& image, int row, int col, int step) {
  if (row < step || col < step || row + step >= image.rows || col + step >= image.cols) {
    return std::numeric_limits<float>::infinity();
  }
  double sum = 0.0, sum_x = 0.0, sum_y = 0.0, squares = 0.0;
  const double center = image.height[image.index(row, col)];
  for (int dy = -1; dy <= 1; ++dy) {
    for (int dx = -1; dx <= 1; ++dx) {
      const size_t i = image.index(row + dy * step, col + dx * step);
      const double z = image.height[i] - center;
      sum += z;
      sum_x += dx * z;
      sum_y += dy * z;
      squares += z * z;
    }
  }
  const double residual = squares - sum * sum / 9.0 - (sum_x * sum_x + sum_y * sum_y) / 6.0;
  // Six degrees of freedom are left of nine.
  return static_cast<float>(std::sqrt(std::max(residual, 0.0) / 6.0));
}

// Removes the patches of rough pixels that are too small or, on average, too smooth for crowns.
void drop_roofs(const cv::Mat& roughness, double gsd, const VegetationOptions& options,
                cv::Mat* crowns) {
  cv::Mat labels;
  const int count = cv::connectedComponents(*crowns, labels, 8, CV_32S);
  std::vector<int> pixels(count, 0);
  std::vector<double> sum(count, 0.0);
  for (int row = 0; row < labels.rows; ++row) {
    for (int col = 0; col < labels.cols; ++col) {
      const int label = labels.at<int>(row, col);
      ++pixels[label];
      sum[label] += roughness.at<float>(row, col);
    }
  }
  const double least = options.least_contrast * options.roughness;
  for (int row = 0; row < labels.rows; ++row) {
    for (int col = 0; col < labels.cols; ++col) {
      const int label = labels.at<int>(row, col);
      const bool crown =
          pixels[label] * gsd * gsd >= options.least_area && sum[label] >= least * pixels[label];
      if (!crown) crowns->at<unsigned char>(row, col) = 0;
    }
  }
}

}  // namespace

// On coarse cells a ridge or the eaves lie in every neighbourhood of a narrow steep roof, and only
// how rough a patch is tells it from a crown.
constexpr double kContrastPerScale = 0.33;

VegetationOptions vegetation_at(const VegetationOptions& options, double gsd) {
  VegetationOptions scaled = options;
  const double scale = std::max(1.0, gsd / 0.5);
  scaled.roughness *= scale;
  scaled.least_width *= scale;
  scaled.least_contrast += kContrastPerScale * (scale - 1.0);
  return scaled;
}

std::vector<unsigned char> find_vegetation(const HeightImage& image,
                                           const VegetationOptions& options) {
  const int step = std::max(1, static_cast<int>(std::lround(0.5 / image.gsd)));
  cv::Mat deviation(image.rows, image.cols, CV_32F);
  for (int row = 0; row < image.rows; ++row) {
    for (int col = 0; col < image.cols; ++col) {
      deviation.at<float>(row, col) = plane_deviation(image, row, col, step);
    }
  }
  cv::Mat smoothest(image.rows, image.cols, CV_32F);
  for (int row = 0; row < image.rows; ++row) {
    for (int col = 0; col < image.cols; ++col) {
      float least = std::numeric_limits<float>::infinity();
      for (int dy = -step; dy <= step; dy += step) {
        for (int dx = -step; dx <= step; dx += step) {
          const int r = row + dy, c = col + dx;
          if (r < 0 || c < 0 || r >= image.rows || c >= image.cols) continue;
          least = std::min(least, deviation.at<float>(r, c));
        }
      }
      smoothest.at<float>(row, col) = std::isfinite(least) ? least : 0.0f;
    }
  }
  // Single rough pixels are outliers or chimneys.
  cv::Mat typical;
  cv::medianBlur(smoothest, typical, step == 1 ? 3 : 5);
  cv::Mat rough(image.rows, image.cols, CV_8U);
  for (int row = 0; row < image.rows; ++row) {
    for (int col = 0; col < image.cols; ++col) {
      const size_t i = image.index(row, col);
      const bool high = image.height[i] - image.ground[i] > options.least_height;
      rough.at<unsigned char>(row, col) = high && typical.at<float>(row, col) > options.roughness;
    }
  }
  const int width = std::max(2, static_cast<int>(std::lround(options.least_width / image.gsd)));
  cv::Mat crowns;
  cv::morphologyEx(rough, crowns, cv::MORPH_OPEN, cv::Mat::ones(width, width, CV_8U));
  // Gaps between leaves and the crowns' rims, whose neighbourhoods reach out to open ground.
  const int rim = std::max(1, static_cast<int>(std::lround(options.rim / image.gsd)));
  cv::morphologyEx(crowns, crowns, cv::MORPH_CLOSE, cv::Mat::ones(width + 1, width + 1, CV_8U));
  drop_roofs(typical, image.gsd, options, &crowns);
  cv::dilate(crowns, crowns, cv::Mat::ones(2 * rim + 1, 2 * rim + 1, CV_8U));
  std::vector<unsigned char> out(image.size(), 0);
  for (int row = 0; row < image.rows; ++row) {
    for (int col = 0; col < image.cols; ++col) {
      const size_t i = image.index(row, col);
      out[i] = crowns.at<unsigned char>(row, col) != 0 &&
               image.height[i] - image.ground[i] > options.least_height;
    }
  }
  return out;
}

void set_aside(size_t pixel, HeightImage* image) {
  constexpr float kWeight = 0.05f;
  image->weight[pixel] = kWeight;
  image->height[pixel] = image->ground[pixel];
}

int leave_out_vegetation(const VegetationOptions& options, HeightImage* image) {
  const std::vector<unsigned char> crowns = find_vegetation(*image, options);
  int count = 0;
  for (size_t i = 0; i < crowns.size(); ++i) {
    if (!crowns[i]) continue;
    set_aside(i, image);
    if (!image->inside.empty()) image->inside[i] = 0;
    ++count;
  }
  return count;
}

}  // namespace gable
