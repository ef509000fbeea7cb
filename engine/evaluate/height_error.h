#pragma once

#include <cmath>
#include <cstddef>

namespace gable {

/// Differences of heights, collected one by one. Differences that are not finite (nodata) do not
/// count.
class HeightError {
 public:
  void add(double difference) {
    if (!std::isfinite(difference)) return;
    ++pixels_;
    sum_ += std::abs(difference);
    sum_squares_ += difference * difference;
  }

  size_t pixels() const { return pixels_; }
  /// Mean absolute difference, metres; NaN without pixels.
  double mad() const { return sum_ / static_cast<double>(pixels_); }
  /// Root mean square difference, metres; NaN without pixels.
  double rmse() const { return std::sqrt(sum_squares_ / static_cast<double>(pixels_)); }

 private:
  size_t pixels_ = 0;
  double sum_ = 0.0;
  double sum_squares_ = 0.0;
};

}  // namespace gable
