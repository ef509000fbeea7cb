#include <gable/engine/reconstruct/heights/morphology.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <vector>

namespace gable {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

struct Smaller {
  float operator()(float a, float b) const { return a < b ? a : b; }
  static constexpr float kNothing = kInfinity;
};
struct Larger {
  float operator()(float a, float b) const { return a > b ? a : b; }
  static constexpr float kNothing = -kInfinity;
};

/// A plain image; missing values are the operation's neutral element.
struct Image {
  int rows = 0, cols = 0;
  std::vector<float> values;
  float* row(int r) { return values.data() + static_cast<size_t>(r) * cols; }
  const float* row(int r) const { return values.data() + static_cast<size_t>(r) * cols; }
};

Image transposed(const Image& image) {
  constexpr int kTile = 32;
  Image out{image.cols, image.rows, std::vector<float>(image.values.size())};
  for (int r0 = 0; r0 < image.rows; r0 += kTile) {
    for (int c0 = 0; c0 < image.cols; c0 += kTile) {
      for (int r = r0; r < std::min(r0 + kTile, image.rows); ++r) {
        for (int c = c0; c < std::min(c0 + kTile, image.cols); ++c) {
          out.row(c)[r] = image.row(r)[c];
        }
      }
    }
  }
  return out;
}

/// Running extremum down the columns. Blocks of one window length: `down` holds the extremum from
/// the start of a row's block to the row, `up` from the row to the end of its block. A full window
/// meets two blocks at most, so two values give its extremum; a window cut by the border lies in
/// one block and at one of that block's ends.
template <typename Extremum>
Image running(const Image& image, int radius, Extremum better) {
  const int rows = image.rows, cols = image.cols;
  const int window = 2 * radius + 1;
  Image down = image, up = image, out = image;
  for (int r = 1; r < rows; ++r) {
    if (r % window == 0) continue;
    const float* before = down.row(r - 1);
    float* here = down.row(r);
    for (int c = 0; c < cols; ++c) here[c] = better(here[c], before[c]);
  }
  for (int r = rows - 2; r >= 0; --r) {
    if ((r + 1) % window == 0) continue;
    const float* after = up.row(r + 1);
    float* here = up.row(r);
    for (int c = 0; c < cols; ++c) here[c] = better(here[c], after[c]);
  }
  for (int r = 0; r < rows; ++r) {
    const int first = std::max(0, r - radius), last = std::min(rows - 1, r + radius);
    const float* head = up.row(first);
    const float* tail = down.row(last);
    float* here = out.row(r);
    if (first / window != last / window) {
      for (int c = 0; c < cols; ++c) here[c] = better(head[c], tail[c]);
    } else {
      std::copy_n(first % window == 0 ? tail : head, cols, here);
    }
  }
  return out;
}

template <typename Extremum>
Image to_image(const HeightRaster& heights, Extremum) {
  Image image{heights.grid.rows, heights.grid.cols, heights.values};
  for (float& z : image.values) {
    if (std::isnan(z)) z = Extremum::kNothing;
  }
  return image;
}

template <typename Extremum>
HeightRaster filter(const HeightRaster& heights, int radius, Extremum better) {
  assert(radius >= 0);
  HeightRaster out;
  out.grid = heights.grid;
  const Image columns = running(to_image(heights, better), radius, better);
  out.values = transposed(running(transposed(columns), radius, better)).values;
  for (float& z : out.values) {
    if (z == Extremum::kNothing) z = std::numeric_limits<float>::quiet_NaN();
  }
  return out;
}

}  // namespace

HeightRaster erode(const HeightRaster& heights, int radius) {
  return filter(heights, radius, Smaller());
}

HeightRaster dilate(const HeightRaster& heights, int radius) {
  return filter(heights, radius, Larger());
}

HeightRaster open(const HeightRaster& heights, int radius) {
  return dilate(erode(heights, radius), radius);
}

}  // namespace gable
