#pragma once

#include <cstdint>

namespace gable {

/// A small seeded generator (splitmix64). The same seed gives the same numbers on every platform
/// and standard library, which std:: distributions do not promise.
class Random {
 public:
  explicit Random(uint64_t seed) : state_(seed) {}

  uint64_t next();
  /// Uniform in [low, high).
  double uniform(double low, double high);
  /// Uniform integer in [low, high], both included.
  int integer(int low, int high);
  /// Standard normal times `sigma` (Box-Muller).
  double normal(double sigma);
  bool chance(double probability) { return uniform(0.0, 1.0) < probability; }
  /// An independent generator for a sub-task; does not depend on how much the sub-task draws.
  Random fork() { return Random(next()); }

 private:
  uint64_t state_;
};

}  // namespace gable
