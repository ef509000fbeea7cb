#include <gable/grammar/block.h>
#include <gable/grammar/synthesis/houses/box_dormers.h>
#include <gable/grammar/synthesis/houses/rectangle.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace gable {
namespace {

constexpr double kLeastSlope = 0.577;  // 30 degrees
constexpr double kLeastOut = 1.0;      // of the front over the slope, metres
constexpr double kLeastDepth = 1.2, kMostDepth = 4.2;
constexpr double kAside = 0.2;  // from the ends of the ridge, metres

/// Whether one row fits; then it is added.
bool add_row(int component, const std::vector<Block<double>>& blocks, Random* random,
             House* house) {
  using namespace block_value;
  const Block<double>& block = blocks[component];
  if (block.flat) return false;
  const Rectangle r = rectangle_of(block);
  const bool along_x = block.ridge == Axis::kX;
  const double u0 = along_x ? r.x0 : r.y0, u1 = along_x ? r.x1 : r.y1;
  const double v0 = along_x ? r.y0 : r.x0, v1 = along_x ? r.y1 : r.x1;
  const double half_span = 0.5 * (v1 - v0);
  const double slope = block[kRise] / half_span;
  if (slope < kLeastSlope) return false;

  const double front = random->uniform(0.2, 1.3);
  const double top = block[kEaves] + block[kRise] - random->uniform(0.2, 1.0);
  const double out = top - block[kEaves] - front * slope;
  const double depth = out / slope;
  if (out < kLeastOut || depth < kLeastDepth || depth > kMostDepth) return false;

  const double share = (front + depth) / half_span;
  const double from = u0 + kAside + block[kHipStart] * (u1 - u0) * share;
  const double to = u1 - kAside - block[kHipEnd] * (u1 - u0) * share;
  const int count = to - from > 5.5 && random->chance(0.4) ? 2 : 1;
  const double gap = random->uniform(0.8, 1.8);
  const double most = std::min(4.0, (to - from - (count - 1) * gap) / count);
  if (most < 2.0) return false;
  const double width = random->uniform(2.0, most);
  const double row = count * width + (count - 1) * gap;
  const double first = from + random->uniform(0.0, to - from - row);
  const bool low_side = random->chance(0.5);
  const double va = low_side ? v0 + front : v1 - front - depth;
  std::vector<Rule> rules;
  for (int i = 0; i < count; ++i) {
    const double ua = first + i * (width + gap);
    const Rectangle at = along_x ? Rectangle{ua, ua + width, va, va + depth}
                                 : Rectangle{va, va + depth, ua, ua + width};
    for (int other = 0; other < house->num_components(); ++other) {
      if (other != component && distance(at, rectangle_of(blocks[other])) < 0.3) return false;
    }
    namespace d = param::dormer;
    Rule dormer = make_rule(RuleKind::kDormer);
    dormer.component = component;
    dormer[d::kCenterX] = at.mid_x();
    dormer[d::kCenterY] = at.mid_y();
    dormer[d::kWidth] = width;
    dormer[d::kDepth] = depth;
    dormer[d::kEaves] = top;
    dormer[d::kRise] = 0.0;
    rules.push_back(dormer);
  }
  house->dormers.insert(house->dormers.end(), rules.begin(), rules.end());
  return true;
}

}  // namespace

void add_box_dormers(Random* random, House* house) {
  const auto blocks = expand_blocks(*house);
  for (int attempt = 0; attempt < 12; ++attempt) {
    if (add_row(random->integer(0, house->num_components() - 1), blocks, random, house)) return;
  }
}

}  // namespace gable
