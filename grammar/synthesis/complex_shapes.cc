#include <gable/grammar/synthesis/complex_shapes.h>
#include <gable/grammar/synthesis/random_roof.h>
#include <gable/grammar/synthesis/rectangle.h>

#include <cmath>
#include <utility>
#include <vector>

namespace gable {
namespace {

/// A block attached to one side of another, sliding along it.
Rectangle attached(const Rectangle& to, Random* random) {
  const double depth = random->uniform(4.0, 9.0);
  const double along = random->uniform(4.0, 10.0);
  const int side = random->integer(0, 3);
  const bool at_x = side < 2;
  const double low = at_x ? to.y0 : to.x0;
  const double high = at_x ? to.y1 : to.x1;
  const double start = random->uniform(low - 0.4 * along, high - 0.6 * along);
  if (side == 0) return {to.x1 - 0.5, to.x1 + depth, start, start + along};
  if (side == 1) return {to.x0 - depth, to.x0 + 0.5, start, start + along};
  if (side == 2) return {start, start + along, to.y1 - 0.5, to.y1 + depth};
  return {start, start + along, to.y0 - depth, to.y0 + 0.5};
}

bool overlaps_much(const Rectangle& r, const std::vector<Rectangle>& others) {
  for (const Rectangle& other : others) {
    if (shared_area(r, other) > 0.25 * std::min(r.area(), other.area())) return true;
  }
  return false;
}

}  // namespace

House random_composite(Random* random) {
  const size_t count = static_cast<size_t>(random->integer(4, 6));
  const double width = random->uniform(5.0, 10.0);
  std::vector<Rectangle> rectangles = {{0.0, width * random->uniform(1.0, 1.6), 0.0, width}};
  while (rectangles.size() < count) {
    const int to = random->integer(0, static_cast<int>(rectangles.size()) - 1);
    const Rectangle r = attached(rectangles[to], random);
    if (!overlaps_much(r, rectangles)) rectangles.push_back(r);
  }
  Rectangle box = rectangles[0];
  for (const Rectangle& r : rectangles) box = bounds(box, r);

  House house;
  house.foundation = Foundation::kC;
  house.azimuth[0] = random->uniform(0.0, 2.0 * M_PI);
  const double eaves = random_eaves(random) + 0.6;
  for (const Rectangle& r : rectangles) {
    using namespace param::rectangle;
    Rule footprint = make_rule(RuleKind::kFootprintI);
    footprint[kCenterX] = r.mid_x() - box.mid_x();
    footprint[kCenterY] = r.mid_y() - box.mid_y();
    footprint[kLength] = r.size_x();
    footprint[kWidth] = r.size_y();
    house.footprints.push_back(footprint);
    const double height =
        random->chance(0.4) ? eaves : std::max(2.4, eaves + random->uniform(-2.5, 2.5));
    const Axis ridge = r.size_x() > r.size_y() ? Axis::kX : Axis::kY;
    house.roofs.push_back(random->chance(0.2)
                              ? make_flat_roof(height)
                              : random_roof(r, ridge, height, random_pitch(random), random));
  }
  return house;
}

}  // namespace gable
