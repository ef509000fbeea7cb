#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace gable {

/// Numbers of values in bins of equal width from 0 on; the last bin holds all that is larger.
struct Histogram {
  double bin_width = 0.05;
  std::vector<size_t> counts;
};

/// Counts `values` (>= 0; others and NaN are left out) into `bins` bins.
Histogram make_histogram(const std::vector<double>& values, double bin_width, size_t bins);

/// The middle value; the mean of the middle two where their number is even; NaN where there is
/// none.
double median(std::vector<double> values);

/// A histogram as an SVG element: bars, numbers of houses, an axis in metres and a mark at the
/// median.
std::string histogram_svg(const Histogram& histogram, double median);

}  // namespace gable
