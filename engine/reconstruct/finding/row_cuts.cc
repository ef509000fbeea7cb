#include <gable/engine/reconstruct/finding/row_cuts.h>
#include <glog/logging.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <limits>
#include <map>
#include <opencv2/imgproc.hpp>
#include <utility>

namespace gable {
namespace {

// Pixels of one piece.
using Pixels = std::vector<size_t>;

// A piece, and the lines that it was cut along so far.
struct Piece {
  Pixels pixels;
  std::vector<PlanLine> cuts;
};

// Steps of one pixel to the east and to the south.
constexpr std::array<std::array<int, 2>, 2> kForward = {{{0, 1}, {1, 0}}};

/// A line across the plan: pixels with normal . p < offset lie on its first side.
struct Line {
  Eigen::Vector2d normal = Eigen::Vector2d::UnitX();
  double offset = 0.0;  ///< metres
  double ratio = std::numeric_limits<double>::infinity();
};

class RowCutter {
 public:
  RowCutter(const HeightImage& image, const RowCutOptions& options)
      : image_(image), options_(options), piece_(image.size(), -1), at_seam_(image.size(), 0) {
    find_steps();
    find_valleys();
  }

  RowPieces run() {
    Pixels all;
    for (size_t i = 0; i < image_.size(); ++i) {
      if (image_.inside[i]) all.push_back(i);
    }
    for (const size_t i : all) piece_[i] = 0;
    num_pieces_ = 1;
    if (all.size() * cell_area() <= options_.least_row) return {piece_, {{}}};
    std::vector<Piece> open;
    for (Pixels& pixels : components_of(all)) open.push_back({std::move(pixels), {}});
    std::vector<Piece> whole;
    while (!open.empty()) {
      Piece piece = std::move(open.back());
      open.pop_back();
      std::vector<Piece> parts = cut(piece);
      if (parts.empty()) whole.push_back(std::move(piece));
      for (Piece& part : parts) open.push_back(std::move(part));
    }
    return numbered_by_first_pixels(std::move(whole));
  }

 private:
  double cell_area() const { return image_.gsd * image_.gsd; }

  Eigen::Vector2d center_of(size_t i) const {
    return image_.center_of(static_cast<int>(i) / image_.cols, static_cast<int>(i) % image_.cols);
  }

  double over_ground(size_t i) const {
    return std::max(0.0, static_cast<double>(image_.height[i]) - image_.ground[i]);
  }

  /// Marks the pixels beside which heights jump by more than the roofs' own slopes.
  void find_steps() {
    const auto inside = [&](int row, int col) {
      return row >= 0 && col >= 0 && row < image_.rows && col < image_.cols &&
             image_.inside[image_.index(row, col)];
    };
    const auto z = [&](int row, int col) -> double {
      return image_.height[image_.index(row, col)];
    };
    for (const auto& [dr, dc] : kForward) {
      for (int row = 0; row < image_.rows; ++row) {
        for (int col = 0; col < image_.cols; ++col) {
          if (!inside(row, col) || !inside(row + dr, col + dc)) continue;
          const double jump = z(row + dr, col + dc) - z(row, col);
          double excess = std::abs(jump);
          if (inside(row - dr, col - dc)) {
            excess = std::min(excess, std::abs(jump - (z(row, col) - z(row - dr, col - dc))));
          }
          if (inside(row + 2 * dr, col + 2 * dc)) {
            const double slope = z(row + 2 * dr, col + 2 * dc) - z(row + dr, col + dc);
            excess = std::min(excess, std::abs(jump - slope));
          }
          // A wall that is smeared over two pixels is as even as a roof, but steeper than any.
          const bool wall = std::abs(jump) > kSteepest * image_.gsd + options_.step;
          if (excess <= options_.step && !wall) continue;
          at_seam_[image_.index(row, col)] = 1;
          at_seam_[image_.index(row + dr, col + dc)] = 1;
        }
      }
    }
  }

  /// Marks the pixels that lie lower than the roofs to both sides.
  void find_valleys() {
    const int reach = std::max(1, static_cast<int>(std::lround(kValleyReach / image_.gsd)));
    constexpr int kDirections[4][2] = {{0, 1}, {1, 0}, {1, 1}, {1, -1}};
    for (int row = reach; row + reach < image_.rows; ++row) {
      for (int col = reach; col + reach < image_.cols; ++col) {
        const size_t i = image_.index(row, col);
        if (!image_.inside[i]) continue;
        for (const auto& [dr, dc] : kDirections) {
          const size_t a = image_.index(row - reach * dr, col - reach * dc);
          const size_t b = image_.index(row + reach * dr, col + reach * dc);
          if (!image_.inside[a] || !image_.inside[b]) continue;
          const float sides = std::min(image_.height[a], image_.height[b]);
          if (sides - image_.height[i] > options_.step) at_seam_[i] = 1;
        }
      }
    }
  }

  /// Makes pieces of the parts of `pixels` that hang together over pixel edges; they all have one
  /// piece's number, which the first of them keeps.
  std::vector<Pixels> components_of(const Pixels& pixels) {
    std::vector<Pixels> parts;
    const int old = piece_[pixels.front()];
    for (const size_t i : pixels) piece_[i] = kUnvisited;
    for (const size_t seed : pixels) {
      if (piece_[seed] != kUnvisited) continue;
      const int number = parts.empty() ? old : num_pieces_++;
      Pixels cells = {seed};
      piece_[seed] = number;
      for (size_t next = 0; next < cells.size(); ++next) {
        for_neighbours(cells[next], [&](size_t j) {
          if (piece_[j] != kUnvisited) return;
          piece_[j] = number;
          cells.push_back(j);
        });
      }
      parts.push_back(std::move(cells));
    }
    return parts;
  }

  template <typename Visit>
  void for_neighbours(size_t i, Visit visit) const {
    const int row = static_cast<int>(i) / image_.cols, col = static_cast<int>(i) % image_.cols;
    if (row > 0) visit(i - image_.cols);
    if (col > 0) visit(i - 1);
    if (col + 1 < image_.cols) visit(i + 1);
    if (row + 1 < image_.rows) visit(i + image_.cols);
  }

  double seam_share(const Pixels& pixels) const {
    const auto seams =
        std::count_if(pixels.begin(), pixels.end(), [this](size_t i) { return at_seam_[i] != 0; });
    return static_cast<double>(seams) / static_cast<double>(pixels.size());
  }

  double fill_of(const Pixels& pixels) const {
    std::vector<cv::Point2f> points;
    for (const size_t i : pixels) {
      const Eigen::Vector2d p = center_of(i);
      points.emplace_back(static_cast<float>(p.x()), static_cast<float>(p.y()));
    }
    const cv::RotatedRect box = cv::minAreaRect(points);
    return pixels.size() * cell_area() /
           ((box.size.width + image_.gsd) * (box.size.height + image_.gsd));
  }

  /// The line of least ratio among those of one direction.
  Line best_line(const Pixels& pixels, const Eigen::Vector2d& normal) const {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const size_t i : pixels) {
      const double t = normal.dot(center_of(i));
      low = std::min(low, t);
      high = std::max(high, t);
    }
    const double bin = 0.5 * image_.gsd;
    const int num = static_cast<int>((high - low) / bin) + 2;
    const auto bin_of = [&](double t) { return static_cast<int>((t - low) / bin); };
    // Differences along the bins: what the pixel edges that a line crosses add to it.
    std::vector<double> cost(num + 1, 0.0);
    std::vector<double> area(num + 1, 0.0);
    // A line of unit length crosses so many pixel edges.
    const double edge = image_.gsd / (std::abs(normal.x()) + std::abs(normal.y()));
    for (const size_t i : pixels) {
      const double t = normal.dot(center_of(i));
      area[bin_of(t) + 1] += cell_area();
      const int row = static_cast<int>(i) / image_.cols, col = static_cast<int>(i) % image_.cols;
      for (const auto& [dr, dc] : kForward) {
        if (row + dr >= image_.rows || col + dc >= image_.cols) continue;
        const size_t j = image_.index(row + dr, col + dc);
        if (piece_[j] != piece_[i]) continue;
        const double other = normal.dot(center_of(j));
        const int from = bin_of(std::min(t, other)) + 1, to = bin_of(std::max(t, other)) + 1;
        const bool seam = at_seam_[i] && at_seam_[j];
        const double wall =
            edge * std::min(over_ground(i), over_ground(j)) * (seam ? options_.seam_price : 1.0);
        cost[from] += wall;
        cost[to] -= wall;
      }
    }
    Line best;
    double wall = 0.0, first = 0.0;
    const double whole = pixels.size() * cell_area();
    for (int k = 1; k < num; ++k) {
      wall += cost[k];
      first += area[k];
      const double smaller = std::min(first, whole - first);
      if (smaller < options_.least_part) continue;
      const double ratio = wall / smaller;
      if (ratio >= best.ratio) continue;
      best = {normal, low + k * bin, ratio};
    }
    return best;
  }

  /// Cuts a piece and returns the pieces that it is now; none where it stays whole.
  std::vector<Piece> cut(const Piece& piece) {
    const Pixels& pixels = piece.pixels;
    if (pixels.size() * cell_area() <= options_.most_area) return {};
    if (seam_share(pixels) <= options_.seams && fill_of(pixels) >= options_.fill) return {};
    const std::complex<double> axes = axes_of(pixels);
    std::vector<Line> lines;
    const double first = std::arg(axes) / 4.0;
    for (int k = 0; k < options_.directions; ++k) {
      const double angle = first + M_PI * k / options_.directions;
      Line line = best_line(pixels, {std::cos(angle), std::sin(angle)});
      if (!std::isfinite(line.ratio)) continue;
      // The cosine is 1 along the axes and -1 halfway between them.
      const double turned = 0.5 * (1.0 - std::cos(4.0 * (angle - first)));
      line.ratio *= 1.0 + options_.oblique_price * std::abs(axes) * turned;
      lines.push_back(line);
    }
    std::stable_sort(lines.begin(), lines.end(),
                     [](const Line& a, const Line& b) { return a.ratio < b.ratio; });
    // A line that only cuts crumbs off, which are given back, cuts nothing.
    for (const Line& line : lines) {
      std::vector<Pixels> parts = cut_along(line, pixels);
      if (parts.size() > 1) return with_cut(line, piece.cuts, std::move(parts));
    }
    return {};
  }

  std::vector<Pixels> cut_along(const Line& line, const Pixels& pixels) {
    Pixels first, second;
    for (const size_t i : pixels) {
      (line.normal.dot(center_of(i)) < line.offset ? first : second).push_back(i);
    }
    const int other = num_pieces_++;
    for (const size_t i : second) piece_[i] = other;
    std::vector<Pixels> parts = components_of(first);
    for (Pixels& part : components_of(second)) parts.push_back(std::move(part));
    give_away_crumbs(&parts);
    return parts;
  }

  /// Parts that a piece was cut into, each with the piece's cuts and `line`, turned so that the
  /// part lies on its negative side, unless it has pixels on both.
  std::vector<Piece> with_cut(const Line& line, const std::vector<PlanLine>& cuts,
                              std::vector<Pixels> parts) const {
    std::vector<Piece> pieces;
    for (Pixels& part : parts) {
      const auto before =
          static_cast<size_t>(std::count_if(part.begin(), part.end(), [&](size_t i) {
            return line.normal.dot(center_of(i)) < line.offset;
          }));
      Piece piece{std::move(part), cuts};
      const double sign = before > 0 ? 1.0 : -1.0;
      if (before == 0 || before == piece.pixels.size()) {
        piece.cuts.push_back({sign * line.normal, sign * line.offset});
      }
      pieces.push_back(std::move(piece));
    }
    return pieces;
  }

  /// Gives the parts that are too small to the neighbour that they share most edges with.
  void give_away_crumbs(std::vector<Pixels>* parts) {
    for (bool changed = true; changed;) {
      changed = false;
      for (size_t k = 0; k < parts->size(); ++k) {
        const Pixels& crumb = (*parts)[k];
        if (crumb.size() * cell_area() >= options_.least_part) continue;
        std::map<int, int> shared;  // by piece
        for (const size_t i : crumb) {
          for_neighbours(i, [&](size_t j) { ++shared[piece_[j]]; });
        }
        const auto shared_with = [&](const Pixels& part) { return shared[piece_[part.front()]]; };
        size_t most = k;
        for (size_t m = 0; m < parts->size(); ++m) {
          if (m == k || shared_with((*parts)[m]) == 0) continue;
          if (most == k || shared_with((*parts)[m]) > shared_with((*parts)[most])) most = m;
        }
        if (most == k) continue;
        const int piece = piece_[(*parts)[most].front()];
        for (const size_t i : crumb) piece_[i] = piece;
        (*parts)[most].insert((*parts)[most].end(), crumb.begin(), crumb.end());
        parts->erase(parts->begin() + static_cast<std::ptrdiff_t>(k));
        changed = true;
        break;
      }
    }
  }

  /// The direction that the roofs of a piece rise in, as the mean of unit vectors at four times the
  /// angle (directions modulo a quarter turn); its length tells how much they agree.
  std::complex<double> axes_of(const Pixels& pixels) const {
    std::complex<double> sum;
    double weight = 0.0;
    for (const size_t i : pixels) {
      const int row = static_cast<int>(i) / image_.cols, col = static_cast<int>(i) % image_.cols;
      if (row == 0 || col == 0 || row + 1 == image_.rows || col + 1 == image_.cols) continue;
      const size_t north = i - image_.cols, south = i + image_.cols;
      bool inner = true;
      for_neighbours(i, [&](size_t j) { inner = inner && piece_[j] == piece_[i]; });
      if (!inner) continue;
      const std::complex<double> slope(image_.height[i + 1] - image_.height[i - 1],
                                       image_.height[north] - image_.height[south]);
      const double steepness = std::abs(slope) / (2.0 * image_.gsd);
      if (steepness < kGentlest) continue;
      const double w = std::min(steepness, kSteepest);
      sum += std::polar(w, 4.0 * std::arg(slope));
      weight += w;
    }
    return weight > 0.0 ? sum / weight : sum;
  }

  RowPieces numbered_by_first_pixels(std::vector<Piece> whole) {
    RowPieces result;
    std::vector<int> number(num_pieces_, -1);
    int next = 0;
    for (int& piece : piece_) {
      if (piece < 0) continue;
      if (number[piece] < 0) number[piece] = next++;
      piece = number[piece];
    }
    result.cuts.resize(next);
    for (Piece& piece : whole) result.cuts[piece_[piece.pixels.front()]] = std::move(piece.cuts);
    result.piece = std::move(piece_);
    return result;
  }

  static constexpr int kUnvisited = -2;
  // Roofs flatter than this have no direction.
  static constexpr double kGentlest = 0.2;
  // Slope of the steepest roofs, 60 degrees.
  static constexpr double kSteepest = 1.73;
  // How far to either side of a valley roofs are looked at, metres.
  static constexpr double kValleyReach = 1.5;

  const HeightImage& image_;
  const RowCutOptions& options_;
  std::vector<int> piece_;
  std::vector<unsigned char> at_seam_;
  int num_pieces_ = 0;
};

}  // namespace

std::string check(const RowCutOptions& options) {
  if (!(options.least_row >= 20.0 && options.least_row <= 1e6)) {
    return "least_row must lie in [20, 1e6] square metres";
  }
  if (!(options.most_area >= 20.0 && options.most_area <= 1e6)) {
    return "most_area must lie in [20, 1e6] square metres";
  }
  if (!(options.least_part >= 0.0 && options.least_part <= 1000.0)) {
    return "least_part must lie in [0, 1000] square metres";
  }
  if (!(options.step > 0.0 && options.step <= 10.0)) return "step must lie in (0, 10] m";
  if (!(options.seam_price >= 0.0 && options.seam_price <= 1.0)) {
    return "seam_price must lie in [0, 1]";
  }
  if (!(options.fill > 0.0 && options.fill <= 1.0)) return "fill must lie in (0, 1]";
  if (!(options.oblique_price >= 0.0 && options.oblique_price <= 100.0)) {
    return "oblique_price must lie in [0, 100]";
  }
  if (!(options.seams >= 0.0 && options.seams <= 1.0)) return "seams must lie in [0, 1]";
  if (options.directions < 2 || options.directions > 360) return "directions must lie in [2, 360]";
  return "";
}

RowPieces cut_rows(const HeightImage& image, const RowCutOptions& options) {
  CHECK(check(options).empty()) << check(options);
  return RowCutter(image, options).run();
}

}  // namespace gable
