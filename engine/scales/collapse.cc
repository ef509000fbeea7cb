#include <gable/engine/scales/collapse.h>
#include <gable/engine/scales/feature_histograms.h>
#include <gable/engine/scales/shape_plane.h>

#include <algorithm>
#include <queue>
#include <tuple>

namespace gable {
namespace {

// A pair of shapes that could merge. It is out of date once either of them has merged.
struct Candidate {
  double weight;
  int a, b;
  bool operator>(const Candidate& other) const {
    return std::tie(weight, a, b) > std::tie(other.weight, other.a, other.b);
  }
};

class Collapse {
 public:
  explicit Collapse(const FirstShapes& first)
      : moments_(first.moments),
        neighbours_(first.moments.size()),
        merged_(first.moments.size(), 0),
        histograms_(first.diagonal) {
    for (const PointMoments& m : moments_) outlines_.push_back(outline_of(m));
    std::vector<Candidate> candidates;
    for (const auto& [a, b] : first.adjacent) {
      neighbours_[a].push_back(b);
      neighbours_[b].push_back(a);
      histograms_.add(outlines_[a], outlines_[b]);
      candidates.push_back(candidate(a, b));
    }
    queue_ = Queue(std::greater<>(), std::move(candidates));
    trajectory_.num_first = static_cast<int>(first.moments.size());
    trajectory_.features.push_back(histograms_.features());
  }

  Trajectory run() {
    while (!queue_.empty()) {
      const Candidate best = queue_.top();
      queue_.pop();
      if (!merged_[best.a] && !merged_[best.b]) merge(best);
    }
    return std::move(trajectory_);
  }

 private:
  using Queue = std::priority_queue<Candidate, std::vector<Candidate>, std::greater<>>;

  static ShapeOutline outline_of(const PointMoments& moments) {
    const ShapePlane plane = shape_plane(moments);
    return {plane.centroid, plane.normal, moments.weight};
  }

  Candidate candidate(int a, int b) const {
    PointMoments united = moments_[a];
    united += moments_[b];
    return {plane_rms(united), a, b};
  }

  void merge(const Candidate& best) {
    const int made = static_cast<int>(moments_.size());
    // The neighbours of both. Lists hold shapes that have merged since as well; what those became
    // stands further on in the same list.
    std::vector<int> around;
    histograms_.remove(outlines_[best.a], outlines_[best.b]);
    for (int part : {best.a, best.b}) {
      for (int other : neighbours_[part]) {
        if (merged_[other] || other == best.a || other == best.b) continue;
        histograms_.remove(outlines_[part], outlines_[other]);
        around.push_back(other);
      }
      neighbours_[part] = {};
      merged_[part] = 1;
    }
    std::sort(around.begin(), around.end());
    around.erase(std::unique(around.begin(), around.end()), around.end());

    PointMoments united = moments_[best.a];
    united += moments_[best.b];
    moments_.push_back(united);
    outlines_.push_back(outline_of(united));
    merged_.push_back(0);
    for (int other : around) {
      neighbours_[other].push_back(made);
      histograms_.add(outlines_[other], outlines_[made]);
      queue_.push(candidate(other, made));
    }
    neighbours_.push_back(std::move(around));
    trajectory_.merges.push_back({best.a, best.b, best.weight});
    trajectory_.features.push_back(histograms_.features());
  }

  std::vector<PointMoments> moments_;
  std::vector<ShapeOutline> outlines_;
  std::vector<std::vector<int>> neighbours_;
  std::vector<char> merged_;
  FeatureHistograms histograms_;
  Queue queue_;
  Trajectory trajectory_;
};

}  // namespace

Trajectory collapse(const FirstShapes& first) { return Collapse(first).run(); }

}  // namespace gable
