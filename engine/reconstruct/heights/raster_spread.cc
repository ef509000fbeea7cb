#include <gable/engine/reconstruct/heights/raster_spread.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

namespace gable {
namespace {

// A ramp is looked for within so many cells on either side of its steepest step.
constexpr int kReach = 3;

// And what lies beyond it: two more cells of ground, one more of the roof.
constexpr int kMargin = kReach + 3;

// Neighbouring cells of level ground differ by less than this, metres.
constexpr float kLevel = 0.15f;

// No roof rises by more than this, metres per metre; a ramp does.
constexpr float kSteepestRoof = 1.2f;

// Steps between the first cells of a roof differ by less than this, metres.
constexpr float kPlane = 0.3f;

// Walls are at least so high, metres: on lower ones noise counts for too much.
constexpr float kLeastHeight = 2.5f;

// The steepest step of a wall is at least this, metres per metre; at least kLeastStep metres.
constexpr float kLeastSlope = 0.8f;
constexpr float kLeastStep = 0.5f;

constexpr double kSharpCells = 0.6;
constexpr size_t kFewestWalls = 50;

// Heights along a row or column, from a cell on, in one of the two directions.
class Line {
 public:
  Line(const HeightRaster& heights, int row, int col, int row_step, int col_step)
      : first_(&heights.values[static_cast<size_t>(row) * heights.grid.cols + col]),
        step_(static_cast<ptrdiff_t>(row_step) * heights.grid.cols + col_step),
        aside_(static_cast<ptrdiff_t>(col_step) * heights.grid.cols + row_step) {}

  float at(int k) const { return first_[k * step_]; }
  /// On the next line to either side.
  float beside(int k, int side) const { return first_[k * step_ + side * aside_]; }
  float step(int k) const { return at(k + 1) - at(k); }

 private:
  const float* first_;
  ptrdiff_t step_, aside_;
};

// Comparisons are written so that a cell without a height, NaN, is never part of a wall.
bool is_steepest(const Line& line) {
  for (int k = -kReach; k <= kReach; ++k) {
    if (!(line.step(k) <= line.step(0)) || (k < 0 && line.step(k) == line.step(0))) return false;
  }
  return true;
}

bool is_level(const Line& line, int k) {
  return std::abs(line.step(k - 1)) < kLevel && std::abs(line.step(k - 2)) < kLevel;
}

// The width of the wall whose steepest step is from the line's cell 0 to its cell 1.
std::optional<double> width_at(const Line& line, double gsd) {
  int low = 0;
  while (low > -kReach && !is_level(line, low)) --low;
  if (!is_level(line, low)) return std::nullopt;
  const double ground = (line.at(low) + line.at(low - 1) + line.at(low - 2)) / 3.0;
  const float steepest = kSteepestRoof * static_cast<float>(gsd);
  int high = 1;
  while (high < kReach && line.step(high) > steepest) ++high;
  const float rise = line.step(high), next = line.step(high + 1);
  if (!(std::abs(rise) <= steepest && std::abs(next) <= steepest &&
        std::abs(next - rise) <= kPlane && line.at(high) - ground >= kLeastHeight)) {
    return std::nullopt;
  }
  const double along = 2.0 / 3.0 * (line.at(2) - line.at(-1));
  const double across =
      0.5 * (line.beside(0, 1) + line.beside(1, 1) - line.beside(0, -1) - line.beside(1, -1));
  if (!(std::abs(across) <= along)) return std::nullopt;
  // For a wall smeared over a width w the integral of share (1 - share) is w / 6, wherever the
  // cells lie.
  double sum = 0.0;
  for (int k = low; k <= high; ++k) {
    const double roof = line.at(high) - std::max(0.0f, rise) * static_cast<float>(high - k);
    const double share = std::clamp((line.at(k) - ground) / (roof - ground), 0.0, 1.0);
    sum += share * (1.0 - share);
  }
  return 6.0 * gsd * sum * along / std::hypot(along, across);
}

}  // namespace

std::vector<double> wall_widths(const HeightRaster& heights) {
  std::vector<double> widths;
  const Grid& grid = heights.grid;
  const float least_step = std::max(kLeastStep, kLeastSlope * static_cast<float>(grid.gsd));
  for (int row = kMargin; row < grid.rows - kMargin; ++row) {
    for (int col = kMargin; col < grid.cols - kMargin; ++col) {
      for (const auto& [row_step, col_step] : {std::pair{0, 1}, {0, -1}, {1, 0}, {-1, 0}}) {
        const Line line(heights, row, col, row_step, col_step);
        if (!(line.step(0) > least_step) || !is_steepest(line)) continue;
        if (const auto width = width_at(line, grid.gsd)) widths.push_back(*width);
      }
    }
  }
  return widths;
}

double raster_spread(std::vector<double> widths, double gsd) {
  if (widths.size() < kFewestWalls) return 0.0;
  std::sort(widths.begin(), widths.end());
  const size_t quarter = widths.size() / 4;
  const double middle = std::accumulate(widths.begin() + quarter, widths.end() - quarter, 0.0) /
                        static_cast<double>(widths.size() - 2 * quarter);
  return middle < kSharpCells * gsd ? 0.0 : middle;
}

}  // namespace gable
