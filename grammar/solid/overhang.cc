#include <gable/grammar/solid/overhang.h>

#include <cmath>

namespace gable {
namespace {

// Overhangs nearer than this are made equal, metres: more than solids resolve.
constexpr double kSameReach = 5e-3;

}  // namespace

Block<double> with_overhang(const Block<double>& block, double overhang) {
  using namespace block_value;
  Block<double> grown = block;
  const bool along_x = block.flat || block.ridge == Axis::kX;
  const int u0 = along_x ? kX0 : kY0, u1 = along_x ? kX1 : kY1;
  const int v0 = along_x ? kY0 : kX0, v1 = along_x ? kY1 : kX1;
  const double half_width = 0.5 * (block[v1] - block[v0]);
  const double length = block[u1] - block[u0];
  const auto reach_of = [&](double hip) {
    const double reach = overhang * hip * length / half_width;
    const bool gable = block.flat || block.mansard || hip <= 0.0;
    return gable || std::abs(reach - overhang) < kSameReach ? overhang : reach;
  };
  const double start = reach_of(block[kHipStart]), end = reach_of(block[kHipEnd]);
  grown[u0] -= start;
  grown[u1] += end;
  grown[v0] -= overhang;
  grown[v1] += overhang;
  if (block.flat) return grown;
  // A mansard's lower sides go on.
  const double slope = block.mansard
                           ? block[kRise] * block[kBreakHeight] / (half_width * block[kBreakRun])
                           : block[kRise] / half_width;
  const double drop = overhang * slope;
  grown[kEaves] -= drop;
  grown[kRise] += drop;
  if (block.mansard) {
    grown[kBreakHeight] = (block[kRise] * block[kBreakHeight] + drop) / grown[kRise];
    grown[kBreakRun] = (half_width * block[kBreakRun] + overhang) / (half_width + overhang);
    return grown;
  }
  const auto grow_hip = [&](int hip, double reach) {
    if (block[hip] > 0.0) grown[hip] = (block[hip] * length + reach) / (length + start + end);
  };
  grow_hip(kHipStart, start);
  grow_hip(kHipEnd, end);
  return grown;
}

}  // namespace gable
