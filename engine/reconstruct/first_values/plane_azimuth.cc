#include <gable/engine/reconstruct/first_values/plane_azimuth.h>

#include <algorithm>
#include <cmath>
#include <complex>

namespace gable {
namespace {

// Flatter planes have no direction, steeper ones are edges that cells smear.
constexpr double kLeastSlope = 0.105;
constexpr double kMostSlope = 2.0;

// Beyond this slope a direction is as certain as it needs to be.
constexpr double kSteepEnough = 0.6;

// Farther off, a plane is of something else, radians.
constexpr double kFarOff = 15.0 * M_PI / 180.0;

// Directions that are less concentrated do not agree.
constexpr double kLeastStrength = 0.6;

double quarter_turn_distance(double a, double b) {
  return std::abs(std::remainder(a - b, 0.5 * M_PI));
}

}  // namespace

std::optional<PlaneAzimuth> plane_azimuth(const HouseScale& scale) {
  PlaneAzimuth mean;
  for (int round = 0; round < 2; ++round) {
    std::complex<double> sum;
    double weight = 0.0;
    int planes = 0;
    for (const HousePlane& p : scale.planes) {
      const double slope = std::hypot(p.plane.a, p.plane.b);
      if (slope < kLeastSlope || slope > kMostSlope) continue;
      const double direction = std::atan2(p.plane.b, p.plane.a);
      if (round > 0 && quarter_turn_distance(direction, mean.azimuth) > kFarOff) continue;
      const double certain = std::min(slope, kSteepEnough);
      const double w = static_cast<double>(p.pixels.size()) * certain * certain;
      sum += w * std::polar(1.0, 4.0 * direction);
      weight += w;
      ++planes;
    }
    if (planes == 0) return std::nullopt;
    const double strength = std::abs(sum) / weight;
    if (round == 0 && strength < kLeastStrength) return std::nullopt;
    double azimuth = std::arg(sum) / 4.0;
    if (azimuth < 0.0) azimuth += 0.5 * M_PI;
    if (azimuth >= 0.5 * M_PI) azimuth = 0.0;  // a sum that rounding has brought to the full turn
    mean = {azimuth, strength, planes};
  }
  return mean;
}

}  // namespace gable
