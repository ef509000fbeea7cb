#include <gable/engine/detectors/crop_sums.h>
#include <gable/engine/detectors/crop_tasks.h>
#include <gable/engine/detectors/polygon_candidates.h>
#include <glog/logging.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <span>

namespace gable {
namespace {

constexpr int kLeast = 2;  // of wings and steps, crop pixels

// The roles of an L's and a U's corners along the boundary.
constexpr int kRingL[] = {crop_map::kOuter,   crop_map::kOuterEnd, crop_map::kInnerEnd,
                          crop_map::kConcave, crop_map::kInnerEnd, crop_map::kOuterEnd};
constexpr int kRingU[] = {crop_map::kOuter,    crop_map::kOuterEnd, crop_map::kInnerEnd,
                          crop_map::kConcave,  crop_map::kConcave,  crop_map::kInnerEnd,
                          crop_map::kOuterEnd, crop_map::kOuter};
constexpr int kMostCorners = 8;

// The coordinates of a polygon's edges, edge i between corners i and i + 1: of every other edge
// all x, of those between all y.
using EdgeCoordinates = std::array<double, kMostCorners>;

// Enumerates choices of corners along a ring of roles, one corner or none for each, and hands those
// that agree to `found`. Edge 0 has the x or the y of its corners in common.
class RingSearch {
 public:
  using Found = std::function<void(const EdgeCoordinates& edges, double corners)>;

  RingSearch(std::span<const int> roles, bool first_shares_x, const CornerPeaks& peaks,
             double agreement, Found found)
      : roles_(roles),
        first_shares_x_(first_shares_x),
        peaks_(peaks),
        agreement_(agreement),
        found_(std::move(found)) {}

  void run() { choose(0, 0); }

 private:
  int size() const { return static_cast<int>(roles_.size()); }

  // The coordinate that the corners of an edge have in common.
  double shared(int edge, const Peak& peak) const {
    return (edge % 2 == 0) == first_shares_x_ ? peak.crop.x() : peak.crop.y();
  }

  bool agrees(int edge, const Peak* a, const Peak* b) const {
    return std::abs(shared(edge, *a) - shared(edge, *b)) <= agreement_;
  }

  void choose(int corner, int missing) {
    if (corner == size()) {
      finish();
      return;
    }
    const Peak* before = corner > 0 ? chosen_[corner - 1] : nullptr;
    const bool last = corner + 1 == size();
    for (const Peak& peak : peaks_[roles_[corner]]) {
      if (std::find(chosen_.begin(), chosen_.begin() + corner, &peak) != chosen_.begin() + corner) {
        continue;
      }
      if (before && !agrees(corner - 1, before, &peak)) continue;
      if (last && chosen_[0] && !agrees(corner, chosen_[0], &peak)) continue;
      chosen_[corner] = &peak;
      choose(corner + 1, missing);
    }
    // An edge without any corner has no coordinate.
    if (missing == kMostMissingCorners || (corner > 0 && !before) || (last && !chosen_[0])) return;
    chosen_[corner] = nullptr;
    choose(corner + 1, missing + 1);
  }

  void finish() const {
    EdgeCoordinates edges{};
    double corners = 0.0;
    for (int i = 0; i < size(); ++i) {
      const Peak* a = chosen_[i];
      const Peak* b = chosen_[(i + 1) % size()];
      if (a) corners += a->value / size();
      edges[i] = a && b ? 0.5 * (shared(i, *a) + shared(i, *b)) : shared(i, a ? *a : *b);
    }
    found_(edges, corners);
  }

  std::span<const int> roles_;
  bool first_shares_x_;
  const CornerPeaks& peaks_;
  double agreement_;
  Found found_;
  std::array<const Peak*, kMostCorners> chosen_{};
};

// Whether each value is beyond the one before by kLeast, in the direction of the first step.
bool in_order(std::initializer_list<double> values) {
  const double* v = values.begin();
  const double direction = v[1] > v[0] ? 1.0 : -1.0;
  for (size_t i = 1; i < values.size(); ++i) {
    if (!(direction * (v[i] - v[i - 1]) >= kLeast)) return false;
  }
  return true;
}

double step(double from, double to) { return to > from ? 1.0 : -1.0; }

CropRectangle rectangle(double xa, double xb, double ya, double yb) {
  return {std::min(xa, xb), std::max(xa, xb), std::min(ya, yb), std::max(ya, yb)};
}

// The L with outer corner (outer_x, outer_y), concave corner (inner_x, inner_y) and ends (end_x,
// end_y); nothing where that is no L.
std::optional<CropFoundation> l_of(double outer_x, double inner_x, double end_x, double outer_y,
                                   double inner_y, double end_y) {
  if (!in_order({outer_x, inner_x, end_x}) || !in_order({outer_y, inner_y, end_y})) {
    return std::nullopt;
  }
  CropFoundation out;
  out.foundation = Foundation::kL;
  out.rectangles = {rectangle(outer_x, end_x, outer_y, inner_y),
                    rectangle(outer_x, inner_x, outer_y, end_y)};
  // House y runs against crop y.
  out.side = {-step(outer_x, end_x), step(outer_y, end_y)};
  return out;
}

// The walls of a U, those along its base in order.
struct UWalls {
  double outer_a, inner_a, inner_b, outer_b;  // along the base
  double base, concave, end_a, end_b;         // across it
};

std::optional<CropFoundation> u_of(const UWalls& w, bool base_along_x) {
  if (!in_order({w.outer_a, w.inner_a, w.inner_b, w.outer_b}) ||
      !in_order({w.base, w.concave, w.end_a}) || !in_order({w.base, w.concave, w.end_b})) {
    return std::nullopt;
  }
  const auto place = [&](double along_a, double along_b, double across_a, double across_b) {
    return base_along_x ? rectangle(along_a, along_b, across_a, across_b)
                        : rectangle(across_a, across_b, along_a, along_b);
  };
  CropFoundation out;
  out.foundation = Foundation::kU;
  out.rectangles = {place(w.outer_a, w.outer_b, w.base, w.concave),
                    place(w.outer_a, w.inner_a, w.base, w.end_a),
                    place(w.inner_b, w.outer_b, w.base, w.end_b)};
  const double open = step(w.base, w.end_a);
  // House y runs against crop y.
  out.side = base_along_x ? Eigen::Vector2d(0.0, -open) : Eigen::Vector2d(open, 0.0);
  return out;
}

// The IoU of polygons made of a mask's bounds less a rectangle of whole pixels.
class NotchScore {
 public:
  NotchScore(const CropBits& mask, const CropRectangle& bounds)
      : sums_(mask),
        mask_(mask.count()),
        box_(static_cast<int>(bounds.width() * bounds.height())) {}

  double operator()(int x0, int x1, int y0, int y1) const {
    const int lost = sums_.count(x0, x1, y0, y1);
    const int area = box_ - (x1 - x0) * (y1 - y0);
    return static_cast<double>(mask_ - lost) / (area + lost);
  }

 private:
  CropSums sums_;
  int mask_;  // pixels of the mask, all within the box
  int box_;   // pixels of the box
};

// The mask's bounds less the best rectangle at a corner.
std::optional<CropFoundation> notched_l(const CropBits& mask) {
  const CropRectangle box = bounds_of(mask);
  const int x0 = static_cast<int>(box.x0), x1 = static_cast<int>(box.x1);
  const int y0 = static_cast<int>(box.y0), y1 = static_cast<int>(box.y1);
  const NotchScore score(mask, box);
  std::optional<CropFoundation> best;
  double best_iou = -1.0;
  for (int x = x0 + kLeast; x <= x1 - kLeast; ++x) {
    for (int y = y0 + kLeast; y <= y1 - kLeast; ++y) {
      for (const bool right : {false, true}) {
        for (const bool bottom : {false, true}) {
          const double iou =
              score(right ? x : x0, right ? x1 : x, bottom ? y : y0, bottom ? y1 : y);
          if (iou <= best_iou) continue;
          best_iou = iou;
          best = l_of(right ? x0 : x1, x, right ? x1 : x0, bottom ? y0 : y1, y, bottom ? y1 : y0);
        }
      }
    }
  }
  return best;
}

// The mask's bounds less the best rectangle at a side.
std::optional<CropFoundation> notched_u(const CropBits& mask) {
  const CropRectangle box = bounds_of(mask);
  const NotchScore score(mask, box);
  std::optional<CropFoundation> best;
  double best_iou = -1.0;
  for (const bool along_x : {true, false}) {
    const int a0 = static_cast<int>(along_x ? box.x0 : box.y0);
    const int a1 = static_cast<int>(along_x ? box.x1 : box.y1);
    const int c0 = static_cast<int>(along_x ? box.y0 : box.x0);
    const int c1 = static_cast<int>(along_x ? box.y1 : box.x1);
    for (const bool open_high : {false, true}) {
      for (int concave = c0 + kLeast; concave <= c1 - kLeast; ++concave) {
        const int from = open_high ? concave : c0, to = open_high ? c1 : concave;
        for (int a = a0 + kLeast; a <= a1 - 2 * kLeast; ++a) {
          for (int b = a + kLeast; b <= a1 - kLeast; ++b) {
            const double iou = along_x ? score(a, b, from, to) : score(from, to, a, b);
            if (iou <= best_iou) continue;
            best_iou = iou;
            const double base = open_high ? c0 : c1, end = open_high ? c1 : c0;
            best = u_of({1.0 * a0, 1.0 * a, 1.0 * b, 1.0 * a1, base, 1.0 * concave, end, end},
                        along_x);
          }
        }
      }
    }
  }
  return best;
}

// Scores a candidate and adds it.
void add(std::optional<CropFoundation> candidate, double corners, const CropBits& mask,
         std::vector<CropFoundation>* out) {
  if (!candidate) return;
  candidate->corners = corners;
  candidate->iou = intersection_over_union(candidate->bits(), mask);
  out->push_back(std::move(*candidate));
}

}  // namespace

std::vector<CropFoundation> l_candidates(const CornerPeaks& peaks, const CropBits& mask,
                                         const CandidateOptions& options) {
  CHECK(check(options).empty()) << check(options);
  std::vector<CropFoundation> out;
  // From the outer corner along x, around the boundary, back along y.
  RingSearch(kRingL, false, peaks, options.agreement,
             [&](const EdgeCoordinates& e, double corners) {
               add(l_of(e[5], e[3], e[1], e[0], e[2], e[4]), corners, mask, &out);
             })
      .run();
  add(notched_l(mask), 0.0, mask, &out);
  keep_best(options, &out);
  return out;
}

std::vector<CropFoundation> u_candidates(const CornerPeaks& peaks, const CropBits& mask,
                                         const CandidateOptions& options) {
  CHECK(check(options).empty()) << check(options);
  std::vector<CropFoundation> out;
  for (const bool base_along_x : {true, false}) {
    // From an outer corner along its wing, around the boundary, back along the base. Each U is met
    // twice, from either outer corner.
    RingSearch(kRingU, base_along_x, peaks, options.agreement,
               [&](const EdgeCoordinates& e, double corners) {
                 if (e[0] > e[6]) return;
                 add(u_of({e[0], e[2], e[4], e[6], e[7], e[3], e[1], e[5]}, base_along_x), corners,
                     mask, &out);
               })
        .run();
  }
  add(notched_u(mask), 0.0, mask, &out);
  keep_best(options, &out);
  return out;
}

}  // namespace gable
