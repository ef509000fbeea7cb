#include <gable/grammar/synthesis/houses/random_roof.h>

#include <algorithm>
#include <cmath>

namespace gable {
namespace {

constexpr double kDegree = M_PI / 180.0;

double hip_ratio(RoofEnd end, double half_span, double length, Random* random) {
  if (end == RoofEnd::kGable) return 0.0;
  const double run = half_span * (random->chance(0.5) ? 1.0 : random->uniform(0.75, 1.0));
  return std::min(0.5, run / length);
}

}  // namespace

double random_eaves(Random* random) {
  const double kind = random->uniform(0.0, 1.0);
  if (kind < 0.22) return random->uniform(2.4, 3.2);
  if (kind < 0.40) return random->uniform(3.2, 4.6);
  return random->uniform(4.6, 6.5);
}

double random_pitch(Random* random) {
  return std::clamp(38.0 + random->normal(6.0), 25.0, 50.0) * kDegree;
}

Rule make_roof(const Rectangle& rectangle, Axis ridge, double eaves, double pitch, RoofEnd start,
               RoofEnd end, Random* random) {
  namespace r = param::roof;
  const bool along_x = ridge == Axis::kX;
  const double length = along_x ? rectangle.size_x() : rectangle.size_y();
  const double half_span = 0.5 * (along_x ? rectangle.size_y() : rectangle.size_x());
  const bool gables = start == RoofEnd::kGable && end == RoofEnd::kGable;
  Rule roof = make_rule(gables ? RuleKind::kRoofGable : RuleKind::kRoofHip);
  roof.ridge = ridge;
  roof[r::kEaves] = eaves;
  roof[r::kRise] = half_span * std::tan(pitch);
  if (!gables) {
    roof[r::kHipStart] = hip_ratio(start, half_span, length, random);
    roof[r::kHipEnd] = hip_ratio(end, half_span, length, random);
  }
  return roof;
}

Rule random_roof(const Rectangle& rectangle, Axis ridge, double eaves, double pitch,
                 Random* random) {
  const bool along_x = ridge == Axis::kX;
  const double length = along_x ? rectangle.size_x() : rectangle.size_y();
  const double span = along_x ? rectangle.size_y() : rectangle.size_x();
  if (length < 1.25 * span && random->chance(0.2)) {
    Rule pyramid = make_roof(rectangle, ridge, eaves, pitch, RoofEnd::kHip, RoofEnd::kHip, random);
    pyramid[param::roof::kHipStart] = 0.5;
    pyramid[param::roof::kHipEnd] = 0.5;
    return pyramid;
  }
  const double kind = random->uniform(0.0, 1.0);
  RoofEnd start = RoofEnd::kGable;
  RoofEnd end = RoofEnd::kGable;
  if (kind > 0.50) start = RoofEnd::kHip;
  if (kind > 0.58) end = RoofEnd::kHip;
  if (kind > 0.92) start = RoofEnd::kGable;
  return make_roof(rectangle, ridge, eaves, pitch, start, end, random);
}

Rule make_flat_roof(double height) {
  Rule roof = make_rule(RuleKind::kRoofFlat);
  roof[param::roof::kEaves] = height;
  return roof;
}

}  // namespace gable
