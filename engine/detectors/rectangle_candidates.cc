#include <gable/engine/detectors/crop_tasks.h>
#include <gable/engine/detectors/rectangle_candidates.h>
#include <glog/logging.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

namespace gable {
namespace {

constexpr double kLeastSide = 2.0;  // crop pixels

// One coordinate of a rectangle, from up to two corners of its edge.
class Edge {
 public:
  // False where the corners disagree.
  bool add(double value, double agreement) {
    if (count_ > 0 && std::abs(value - sum_) > agreement) return false;
    sum_ += value;
    ++count_;
    return true;
  }
  bool known() const { return count_ > 0; }
  double value() const { return sum_ / count_; }

 private:
  double sum_ = 0.0;
  int count_ = 0;
};

struct Edges {
  Edge x0, x1, y0, y1;

  bool add(int corner, const Eigen::Vector2d& p, double agreement) {
    using namespace crop_map;
    const bool left = corner == kTopLeft || corner == kBottomLeft;
    const bool top = corner == kTopLeft || corner == kTopRight;
    return (left ? x0 : x1).add(p.x(), agreement) && (top ? y0 : y1).add(p.y(), agreement);
  }
};

bool is_large_enough(const CropRectangle& r) {
  return r.width() >= kLeastSide && r.height() >= kLeastSide;
}

// The rectangle of edges, at most one of which is unknown: that one is the mask's within the band
// between the two it runs across.
std::optional<CropRectangle> rectangle_of(const Edges& edges, const CropBits& mask) {
  const int known = edges.x0.known() + edges.x1.known() + edges.y0.known() + edges.y1.known();
  if (known < 3) return std::nullopt;
  CropRectangle r{0.0, kCropSize, 0.0, kCropSize};
  if (edges.x0.known()) r.x0 = edges.x0.value();
  if (edges.x1.known()) r.x1 = edges.x1.value();
  if (edges.y0.known()) r.y0 = edges.y0.value();
  if (edges.y1.known()) r.y1 = edges.y1.value();
  if (known == 3) {
    const CropRectangle tight = bounds_of(bits_of(r) & mask);
    if (!is_large_enough(tight)) return std::nullopt;
    if (!edges.x0.known()) r.x0 = tight.x0;
    if (!edges.x1.known()) r.x1 = tight.x1;
    if (!edges.y0.known()) r.y0 = tight.y0;
    if (!edges.y1.known()) r.y1 = tight.y1;
  }
  if (!is_large_enough(r)) return std::nullopt;
  return r;
}

// Tries all choices of one or no peak for each corner from `corner` on; `chosen` holds those
// before.
void add_choices(const CornerPeaks& peaks, const CropBits& mask, double agreement, int corner,
                 const Edges& edges, const RectangleCandidate& chosen,
                 std::vector<RectangleCandidate>* out) {
  if (corner == 4) {
    if (const std::optional<CropRectangle> r = rectangle_of(edges, mask)) {
      out->push_back(chosen);
      out->back().rectangle = *r;
    }
    return;
  }
  add_choices(peaks, mask, agreement, corner + 1, edges, chosen, out);
  for (size_t i = 0; i < peaks[corner].size(); ++i) {
    Edges with = edges;
    if (!with.add(corner, peaks[corner][i].crop, agreement)) continue;
    RectangleCandidate more = chosen;
    more.peaks[corner] = static_cast<int>(i);
    more.values[corner] = peaks[corner][i].value;
    add_choices(peaks, mask, agreement, corner + 1, with, more, out);
  }
}

// Of candidates that are alike keeps the one with the best corners.
std::vector<RectangleCandidate> without_likes(std::vector<RectangleCandidate> candidates,
                                              double distinct) {
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const RectangleCandidate& a, const RectangleCandidate& b) {
                     return a.corners() > b.corners();
                   });
  std::vector<RectangleCandidate> kept;
  for (const RectangleCandidate& candidate : candidates) {
    if (std::none_of(kept.begin(), kept.end(), [&](const RectangleCandidate& better) {
          return largest_step(better.rectangle, candidate.rectangle) < distinct;
        })) {
      kept.push_back(candidate);
    }
  }
  return kept;
}

// How promising a rectangle is as a part of a set: the share of it that the mask covers, and its
// corners.
double single_score(const RectangleCandidate& candidate, const CropBits& bits, const CropBits& mask,
                    double corner_weight) {
  const int size = bits.count();
  if (size == 0) return 0.0;
  return static_cast<double>(common_pixels(bits, mask)) / size +
         corner_weight * candidate.corners();
}

double distance(const CropRectangle& a, const CropRectangle& b) {
  return std::max({0.0, a.x0 - b.x1, b.x0 - a.x1, a.y0 - b.y1, b.y0 - a.y1});
}

double area(const CropRectangle& r) { return r.width() * r.height(); }

// A set of rectangles among those that are combined, by their numbers.
struct RectangleSet {
  double score = 0.0, iou = 0.0, corners = 0.0;
  std::array<int, 3> members{};
};

class SetSearch {
 public:
  SetSearch(std::span<const RectangleCandidate> candidates, int count, const CropBits& mask,
            const RectangleSetOptions& options)
      : count_(count), mask_(mask), options_(options) {
    const double weight = options.candidates.corner_weight;
    std::vector<std::pair<double, size_t>> order;
    std::vector<CropBits> bits(candidates.size());
    for (size_t i = 0; i < candidates.size(); ++i) {
      bits[i] = bits_of(candidates[i].rectangle);
      // One rectangle is judged as it will be; parts only promise something.
      const double score =
          count == 1 ? intersection_over_union(bits[i], mask) + weight * candidates[i].corners()
                     : single_score(candidates[i], bits[i], mask, weight);
      order.push_back({-score, i});
    }
    std::sort(order.begin(), order.end());
    if (static_cast<int>(order.size()) > options.singles) order.resize(options.singles);
    for (const auto& [score, i] : order) {
      singles_.push_back(candidates[i]);
      bits_.push_back(bits[i]);
    }
  }

  std::vector<CropFoundation> best() {
    extend(0, CropBits());
    std::stable_sort(sets_.begin(), sets_.end(), [](const RectangleSet& a, const RectangleSet& b) {
      return a.score > b.score;
    });
    // Enough for the distinct ones to be among them.
    constexpr size_t kMost = 200;
    if (sets_.size() > kMost) sets_.resize(kMost);
    std::vector<CropFoundation> out;
    for (const RectangleSet& set : sets_) out.push_back(foundation_of(set));
    keep_best(options_.candidates, &out);
    return out;
  }

 private:
  // Adds rectangles from number `first` on to the chosen ones, which cover `covered`.
  void extend(int first, const CropBits& covered) {
    if (static_cast<int>(chosen_.size()) == count_) {
      finish(covered);
      return;
    }
    for (int i = first; i < static_cast<int>(singles_.size()); ++i) {
      chosen_.push_back(i);
      extend(i + 1, covered | bits_[i]);
      chosen_.pop_back();
    }
  }

  void finish(const CropBits& covered) {
    if (count_ > 1 && !(hangs_together() && each_adds(covered))) return;
    RectangleSet set;
    std::copy(chosen_.begin(), chosen_.end(), set.members.begin());
    set.iou = intersection_over_union(covered, mask_);
    set.corners = distinct_corners();
    set.score = set.iou + options_.candidates.corner_weight * set.corners;
    sets_.push_back(set);
  }

  bool hangs_together() const {
    int near = 0;
    for (size_t i = 0; i < chosen_.size(); ++i) {
      for (size_t j = i + 1; j < chosen_.size(); ++j) {
        near += distance(singles_[chosen_[i]].rectangle, singles_[chosen_[j]].rectangle) <=
                options_.gap;
      }
    }
    return near >= count_ - 1;
  }

  // Mean value of the chosen rectangles' corners, each peak counted once.
  double distinct_corners() const {
    double sum = 0.0;
    for (size_t i = 0; i < chosen_.size(); ++i) {
      const RectangleCandidate& mine = singles_[chosen_[i]];
      for (int type = 0; type < 4; ++type) {
        const bool counted = std::any_of(chosen_.begin(), chosen_.begin() + i, [&](int other) {
          return singles_[other].peaks[type] == mine.peaks[type];
        });
        if (mine.peaks[type] >= 0 && !counted) sum += mine.values[type];
      }
    }
    return sum / (4.0 * count_);
  }

  bool each_adds(const CropBits& covered) const {
    const int all = covered.count();
    for (const int i : chosen_) {
      CropBits others;
      for (const int j : chosen_) {
        if (j != i) others |= bits_[j];
      }
      if (all - others.count() < options_.own_share * all) return false;
    }
    return true;
  }

  CropFoundation foundation_of(const RectangleSet& set) const {
    CropFoundation out;
    out.foundation = count_ == 1   ? Foundation::kI
                     : count_ == 2 ? Foundation::kII
                                   : Foundation::kIII;
    out.iou = set.iou;
    out.corners = set.corners;
    for (int i = 0; i < count_; ++i) out.rectangles.push_back(singles_[set.members[i]].rectangle);
    std::stable_sort(
        out.rectangles.begin(), out.rectangles.end(),
        [](const CropRectangle& a, const CropRectangle& b) { return area(a) > area(b); });
    return out;
  }

  int count_;
  const CropBits& mask_;
  const RectangleSetOptions& options_;
  std::vector<RectangleCandidate> singles_;
  std::vector<CropBits> bits_;
  std::vector<int> chosen_;  // numbers of singles, rising
  std::vector<RectangleSet> sets_;
};

}  // namespace

std::vector<RectangleCandidate> rectangle_candidates(const CornerPeaks& peaks, const CropBits& mask,
                                                     const CandidateOptions& options) {
  CHECK(check(options).empty()) << check(options);
  std::vector<RectangleCandidate> out;
  add_choices(peaks, mask, options.agreement, 0, Edges(), {}, &out);
  const CropRectangle whole = bounds_of(mask);
  if (is_large_enough(whole)) out.push_back({whole});
  return without_likes(std::move(out), options.distinct);
}

std::string check(const RectangleSetOptions& options) {
  const std::string in_candidates = check(options.candidates);
  if (!in_candidates.empty()) return in_candidates;
  if (!(options.singles >= 3 && options.singles <= 200)) return "singles must be in [3, 200]";
  if (!(options.own_share >= 0.0 && options.own_share <= 1.0)) {
    return "own_share must be in [0, 1]";
  }
  if (!(options.gap >= 0.0 && options.gap <= kCropSize)) return "gap must be in [0, 64]";
  return {};
}

std::vector<CropFoundation> rectangle_sets(std::span<const RectangleCandidate> candidates,
                                           int count, const CropBits& mask,
                                           const RectangleSetOptions& options) {
  CHECK(check(options).empty()) << check(options);
  CHECK(count >= 1 && count <= 3) << count;
  return SetSearch(candidates, count, mask, options).best();
}

}  // namespace gable
