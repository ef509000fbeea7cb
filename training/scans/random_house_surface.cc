#include <gable/grammar/synthesis/houses/prior.h>
#include <gable/training/scans/house_surface.h>
#include <gable/training/scans/random_house_surface.h>

namespace gable {
namespace {

/// Puts the house on higher walls under flatter roofs: heights above the ground become
/// lift + scale * height, those of garages stay. Merging by RMS distance joins the slopes of a roof
/// before it joins a slope to the wall under it only where walls are high and roofs are not steep;
/// elsewhere it never passes LOD1.
void raise(double lift, double scale, House* house) {
  for (Rule& roof : house->roofs) {
    using namespace param::roof;
    roof[kEaves] = lift + scale * roof[kEaves];
    roof[kRise] *= scale;
  }
  for (Rule& dormer : house->dormers) {
    using namespace param::dormer;
    dormer[kEaves] = lift + scale * dormer[kEaves];
    dormer[kRise] *= scale;
  }
  for (Rule& chimney : house->chimneys) {
    using namespace param::chimney;
    chimney[kHeight] = lift + scale * chimney[kHeight];
  }
}

}  // namespace

LabelledSurface random_house_surface(Random* random) {
  PriorOptions options;
  options.dormer_share = 0.5;
  House house = random_house(random, options);
  const bool wings = house.foundation == Foundation::kL || house.foundation == Foundation::kU;
  const double scale = random->uniform(0.35, wings ? 0.55 : 0.85);
  raise(random->uniform(2.5, 4.5) + 4.0 * (scale - 0.35), scale, &house);
  return house_surface(house, random);
}

}  // namespace gable
