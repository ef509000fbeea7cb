#include <gable/grammar/synthesis/houses/bent_row.h>

#include <algorithm>
#include <cassert>
#include <cmath>

namespace gable {
namespace {

constexpr double kDegree = M_PI / 180.0;

struct Course {
  Eigen::Vector2d at = Eigen::Vector2d::Zero();
  double azimuth = 0.0;

  Eigen::Vector2d along() const { return {std::cos(azimuth), std::sin(azimuth)}; }
  Eigen::Vector2d across() const { return {-std::sin(azimuth), std::cos(azimuth)}; }
};

BuiltPart gable_part(const Eigen::Vector2d& center, const Eigen::Vector2d& along, double length,
                     double width, double eaves, double slope) {
  BuiltPart part;
  part.center = center;
  part.along = along;
  part.half_length = 0.5 * length;
  part.half_width = 0.5 * width;
  part.form = PartForm::kGable;
  part.eaves = eaves;
  part.rise = part.half_width * slope;
  return part;
}

/// Something lower or a cross wing at the back of a stretch.
BuiltPart back_part(const Course& from, double length, double width, double eaves, double slope,
                    Random* random) {
  const double along = random->uniform(2.5, std::max(3.0, std::min(7.0, length)));
  const double depth = random->uniform(2.0, 6.0);
  const double where = random->uniform(0.1, 0.9) * length;
  const Eigen::Vector2d wall = from.at + where * from.along() - 0.5 * width * from.across();
  if (random->chance(0.4)) {
    return gable_part(wall - (0.5 * depth - 1.0) * from.across(), from.across(), depth + 2.0, along,
                      std::max(2.3, eaves - random->uniform(0.0, 2.0)), slope);
  }
  BuiltPart part = gable_part(wall - 0.5 * depth * from.across(), from.along(), along, depth,
                              random->uniform(2.2, 3.8), 0.0);
  part.form = PartForm::kFlat;
  return part;
}

BuiltShape draw(Random* random) {
  BuiltShape shape;
  Course course;
  const double width = random->uniform(6.0, 9.0);
  const double slope = std::tan(random->uniform(28.0, 46.0) * kDegree);
  const bool one_height = random->chance(0.5);
  const double side = random->chance(0.5) ? 1.0 : -1.0;
  const int stretches = random->integer(2, 5);
  double eaves = random->uniform(2.8, 6.0);
  for (int i = 0; i < stretches; ++i) {
    const double length = random->uniform(7.0, 22.0);
    if (i > 0) {
      // One bend at least is oblique: right angles and offsets alone would make an L, a U or a II.
      const double kind = i == 1 ? 0.0 : random->uniform(0.0, 1.0);
      const double same = random->chance(0.75) ? side : -side;
      if (kind < 0.45) {
        course.azimuth += same * random->uniform(15.0, 40.0) * kDegree;
      } else if (kind < 0.75) {
        course.azimuth += same * random->uniform(80.0, 100.0) * kDegree;
      } else {
        course.at += same * random->uniform(1.5, 4.0) * course.across();
      }
    }
    if (!one_height) eaves = std::max(2.4, eaves + random->uniform(-1.8, 1.8));
    const Eigen::Vector2d along = course.along();
    // Stretches reach into each other, so that a bend has no gap on its outer side.
    const double into = 0.35 * width;
    shape.parts.push_back(gable_part(course.at + 0.5 * (length - into) * along, along,
                                     length + into, width, eaves, slope));
    if (random->chance(0.5)) {
      shape.parts.push_back(back_part(course, length, width, eaves, slope, random));
    }
    course.at += length * along;
  }
  if (random->chance(0.2)) {
    shape.parts.back().end_run = shape.parts[0].start_run = shape.parts[0].half_width;
  }
  return shape;
}

/// Four to seven houses in a row or a gentle curve, joined by narrower and lower links.
BuiltShape draw_chain(Random* random) {
  BuiltShape shape;
  Course course;
  const double width = random->uniform(6.0, 8.5);
  const double slope = std::tan(random->uniform(28.0, 46.0) * kDegree);
  const double eaves = random->uniform(3.0, 6.0);
  const double bend = random->chance(0.6) ? 0.0 : random->uniform(-7.0, 7.0) * kDegree;
  const bool along_row = random->chance(0.75);
  const bool staggered = random->chance(0.4);
  const bool flat_links = random->chance(0.5);
  const int houses = random->integer(4, 7);
  for (int i = 0; i < houses; ++i) {
    const double length = random->uniform(6.5, 12.0), link = random->uniform(2.2, 5.0);
    const double off = staggered ? random->uniform(-1.2, 1.2) : 0.0;
    const Eigen::Vector2d center =
        course.at + 0.5 * length * course.along() + off * course.across();
    shape.parts.push_back(along_row
                              ? gable_part(center, course.along(), length, width, eaves, slope)
                              : gable_part(center, course.across(), width, length, eaves, slope));
    course.at += length * course.along();
    course.azimuth += bend;
    if (i + 1 == houses) break;
    // A link reaches into both houses, which cover it.
    BuiltPart between =
        gable_part(course.at + 0.5 * link * course.along(), course.along(), link + 2.0,
                   width * random->uniform(0.5, 0.85), random->uniform(2.4, 3.2), slope);
    if (flat_links) {
      between.form = PartForm::kFlat;
      between.rise = 0.0;
    }
    shape.parts.push_back(between);
    course.at += link * course.along();
  }
  return shape;
}

double box_diagonal(const BuiltShape& shape, Eigen::Vector2d* middle) {
  Eigen::Vector2d low = shape.parts[0].center, high = low;
  for (const BuiltPart& part : shape.parts) {
    for (const Eigen::Vector2d& corner : part.ring()) {
      low = low.cwiseMin(corner);
      high = high.cwiseMax(corner);
    }
  }
  *middle = 0.5 * (low + high);
  return (high - low).norm();
}

}  // namespace

BuiltShape random_bent_row(double largest, Random* random) {
  assert(largest >= 30.0);
  BuiltShape shape;
  Eigen::Vector2d middle;
  do {
    shape = largest > 45.0 && random->chance(0.35) ? draw_chain(random) : draw(random);
  } while (box_diagonal(shape, &middle) > largest);
  shape.move({-middle.x(), -middle.y(), 0.0});
  const double angle = random->uniform(0.0, 2.0 * M_PI);
  Eigen::Matrix2d turn;
  turn << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle);
  for (BuiltPart& part : shape.parts) {
    part.center = turn * part.center;
    part.along = turn * part.along;
  }
  return shape;
}

}  // namespace gable
