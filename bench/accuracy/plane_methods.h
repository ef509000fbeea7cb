#pragma once

#include <gable/engine/scan.h>

#include <functional>
#include <string>
#include <vector>

namespace gable {

/// A detector of planes that is compared with others. The best of all settings and tolerances of
/// one name counts.
struct PlaneMethod {
  std::string name;
  std::string setting;  ///< for the table; may be empty
  /// The tolerances to try, % of the diagonal of the points' bounding box; {0} for a method that
  /// has none to choose.
  std::vector<double> epsilons_percent;
  /// What is done once a cloud, whatever the tolerance (its normals, say); may be empty.
  std::function<void(Scan*)> prepare;
  /// The plane of every point, -1 for none. epsilon: metres. The scan's labels are the truth, for
  /// methods that say that they know it.
  std::function<std::vector<int>(const Scan&, double epsilon)> detect;
};

/// All that there is to compare in this build, with the settings that have a chance at a level of
/// noise (share of the diagonal).
std::vector<PlaneMethod> plane_methods(double noise);

}  // namespace gable
