#include <gable/engine/parallel_ranges.h>
#include <gable/engine/scales/region_adjacency.h>

#include <algorithm>
#include <mutex>

namespace gable {

std::vector<std::pair<int, int>> adjacent_regions(const Neighbours& neighbours,
                                                  const std::vector<int>& region_of, int threads) {
  std::vector<std::pair<int, int>> pairs;
  std::mutex mutex;
  for_ranges(
      region_of.size(), threads,
      [&](size_t begin, size_t end) {
        std::vector<std::pair<int, int>> found;
        for (int p = static_cast<int>(begin); p < static_cast<int>(end); ++p) {
          if (region_of[p] < 0) continue;
          for (int q : neighbours.of(p)) {
            if (q < p || region_of[q] < 0 || region_of[q] == region_of[p]) continue;
            const auto back = neighbours.of(q);
            if (std::find(back.begin(), back.end(), p) == back.end()) continue;
            found.push_back(std::minmax(region_of[p], region_of[q]));
          }
        }
        std::sort(found.begin(), found.end());
        found.erase(std::unique(found.begin(), found.end()), found.end());
        const std::lock_guard lock(mutex);
        pairs.insert(pairs.end(), found.begin(), found.end());
      },
      65536);
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

}  // namespace gable
