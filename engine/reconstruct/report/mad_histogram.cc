#include <gable/engine/drawing/fixed.h>
#include <gable/engine/reconstruct/report/mad_histogram.h>

#include <algorithm>
#include <cmath>

namespace gable {
namespace {

constexpr double kLeft = 44.0, kTop = 18.0, kWidth = 560.0, kHeight = 150.0;

std::string text(double x, double y, const char* anchor, const std::string& content) {
  return "<text x=\"" + fixed(x, 1) + "\" y=\"" + fixed(y, 1) + "\" text-anchor=\"" + anchor +
         "\">" + content + "</text>\n";
}

std::string line(double x0, double y0, double x1, double y1, const char* css_class) {
  return "<line x1=\"" + fixed(x0, 1) + "\" y1=\"" + fixed(y0, 1) + "\" x2=\"" + fixed(x1, 1) +
         "\" y2=\"" + fixed(y1, 1) + "\" class=\"" + css_class + "\"/>\n";
}

}  // namespace

Histogram make_histogram(const std::vector<double>& values, double bin_width, size_t bins) {
  Histogram histogram{bin_width, std::vector<size_t>(bins, 0)};
  for (const double value : values) {
    if (!(value >= 0.0)) continue;
    const double bin = std::min(std::floor(value / bin_width), static_cast<double>(bins - 1));
    ++histogram.counts[static_cast<size_t>(bin)];
  }
  return histogram;
}

double median(std::vector<double> values) {
  std::erase_if(values, [](double value) { return !std::isfinite(value); });
  if (values.empty()) return NAN;
  std::sort(values.begin(), values.end());
  const size_t n = values.size();
  return 0.5 * (values[(n - 1) / 2] + values[n / 2]);
}

std::string histogram_svg(const Histogram& histogram, double median) {
  const size_t bins = histogram.counts.size();
  const size_t highest =
      std::max<size_t>(1, *std::max_element(histogram.counts.begin(), histogram.counts.end()));
  const double step = kWidth / static_cast<double>(bins);
  const double bottom = kTop + kHeight;
  std::string svg =
      "<svg class=\"histogram\" viewBox=\"0 0 620 206\" role=\"img\" "
      "aria-label=\"Histogram of the mean absolute difference\">\n";
  svg += line(kLeft, kTop, kLeft + kWidth, kTop, "grid");
  svg += text(kLeft - 8, kTop + 4, "end", std::to_string(highest));
  svg += text(kLeft - 8, bottom + 4, "end", "0");
  for (size_t i = 0; i < bins; ++i) {
    const double x = kLeft + step * static_cast<double>(i);
    const double low = histogram.bin_width * static_cast<double>(i);
    const double height =
        kHeight * static_cast<double>(histogram.counts[i]) / static_cast<double>(highest);
    const std::string to =
        i + 1 == bins ? " m and more" : " to " + fixed(low + histogram.bin_width, 2) + " m";
    svg += "<rect class=\"bar\" x=\"" + fixed(x + 1, 1) + "\" y=\"" + fixed(bottom - height, 1) +
           "\" width=\"" + fixed(step - 2, 1) + "\" height=\"" + fixed(height, 1) + "\"><title>" +
           fixed(low, 2) + to + ": " + std::to_string(histogram.counts[i]) + "</title></rect>\n";
    if (i % 4 == 0) svg += text(x, bottom + 16, "middle", fixed(low, 1));
  }
  svg += line(kLeft, bottom, kLeft + kWidth, bottom, "axis");
  svg += text(kLeft + kWidth / 2, bottom + 34, "middle",
              "mean absolute difference (m); the last bar holds all that is larger");
  if (std::isfinite(median)) {
    const double end = histogram.bin_width * static_cast<double>(bins);
    const double x = kLeft + kWidth * std::min(median, end) / end;
    svg += line(x, kTop - 6, x, bottom, "median");
    svg += text(x + 5, kTop - 4, "start", "median " + fixed(median, 2) + " m");
  }
  return svg + "</svg>\n";
}

}  // namespace gable
