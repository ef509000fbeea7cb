#include <gable/engine/evaluate/rand_index.h>
#include <glog/logging.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace gable {
namespace {

/// Number of pairs of elements with equal values.
template <typename Value>
double equal_pairs(std::vector<Value> values) {
  std::sort(values.begin(), values.end());
  double pairs = 0.0;
  for (auto begin = values.begin(); begin != values.end();) {
    const auto end = std::upper_bound(begin, values.end(), *begin);
    const double count = static_cast<double>(end - begin);
    pairs += 0.5 * count * (count - 1.0);
    begin = end;
  }
  return pairs;
}

}  // namespace

double adjusted_rand_index(std::span<const int> a, std::span<const int> b) {
  CHECK_EQ(a.size(), b.size());
  const double n = static_cast<double>(a.size());
  const double all = 0.5 * n * (n - 1.0);
  if (all <= 0.0) return 1.0;
  std::vector<std::pair<int, int>> both(a.size());
  for (size_t i = 0; i < a.size(); ++i) both[i] = {a[i], b[i]};
  const double together = equal_pairs(std::move(both));
  const double in_a = equal_pairs(std::vector<int>(a.begin(), a.end()));
  const double in_b = equal_pairs(std::vector<int>(b.begin(), b.end()));
  const double expected = in_a * in_b / all;
  const double most = 0.5 * (in_a + in_b);
  return most == expected ? 1.0 : (together - expected) / (most - expected);
}

}  // namespace gable
