#include <gable/engine/scales/trajectory.h>
#include <glog/logging.h>

namespace gable {

std::vector<int> shapes_at(const Trajectory& trajectory, int configuration) {
  CHECK_GE(configuration, 0);
  CHECK_LT(configuration, trajectory.num_configurations());
  const int n = trajectory.num_first;
  // Later shapes come first: what a merge made knows its own fate before its parts ask for it.
  std::vector<int> top(n + configuration);
  for (int i = 0; i < n + configuration; ++i) top[i] = i;
  for (int i = configuration - 1; i >= 0; --i) {
    top[trajectory.merges[i].a] = top[n + i];
    top[trajectory.merges[i].b] = top[n + i];
  }
  std::vector<int> number(top.size(), -1), shapes(n);
  int next = 0;
  for (int i = 0; i < n; ++i) {
    if (number[top[i]] < 0) number[top[i]] = next++;
    shapes[i] = number[top[i]];
  }
  return shapes;
}

}  // namespace gable
