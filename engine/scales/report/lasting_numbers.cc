#include <gable/engine/scales/report/lasting_numbers.h>
#include <glog/logging.h>

namespace gable {

LastingNumbers::LastingNumbers(const Trajectory& trajectory, const FirstShapes& first_shapes)
    : num_first_(trajectory.num_first) {
  CHECK_EQ(static_cast<int>(first_shapes.moments.size()), num_first_);
  const int num_merges = static_cast<int>(trajectory.merges.size());
  parent_.assign(num_first_ + num_merges, -1);
  number_.assign(num_first_ + num_merges, -1);
  std::vector<double> weight;
  for (const PointMoments& moments : first_shapes.moments) weight.push_back(moments.weight);
  for (int i = 0; i < num_merges; ++i) {
    const Merge& merge = trajectory.merges[i];
    weight.push_back(weight[merge.a] + weight[merge.b]);
    parent_[merge.a] = parent_[merge.b] = num_first_ + i;
  }
  int next = 0;
  for (size_t shape = 0; shape < parent_.size(); ++shape) {
    if (parent_[shape] < 0) number_[shape] = next++;
  }
  for (int i = num_merges - 1; i >= 0; --i) {
    const auto [a, b, unused] = trajectory.merges[i];
    const bool a_lasts = weight[a] >= weight[b];
    number_[a_lasts ? a : b] = number_[num_first_ + i];
    number_[a_lasts ? b : a] = next++;
  }
}

std::vector<int> LastingNumbers::at(int configuration) const {
  const int end = num_first_ + configuration;
  CHECK(configuration >= 0 && end <= static_cast<int>(parent_.size()));
  // From the last merge backwards, every shape hands its number of this configuration down.
  std::vector<int> out(end);
  for (int shape = end - 1; shape >= 0; --shape) {
    const bool whole = parent_[shape] < 0 || parent_[shape] >= end;
    out[shape] = whole ? number_[shape] : out[parent_[shape]];
  }
  out.resize(num_first_);
  return out;
}

}  // namespace gable
