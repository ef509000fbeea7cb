#include "engine/reconstruct/report/report_sample.h"

#include <gable/engine/reconstruct/report/building_surface.h>
#include <gable/grammar/random.h>

namespace gable {

Building house_with_all_parts(const std::string& id) {
  House house = make_house(Foundation::kL);
  house.origin = {651000.0, 5212000.0, 430.0};
  house.azimuth[0] = 0.35;
  house.footprints[0].values = {-7.0, -5.0, 14.0, 7.0, 13.0, 6.0};
  house.roofs[0] = make_rule(RuleKind::kRoofHip);
  house.roofs[0].values = {5.0, 2.8, 0.0, 0.2};
  house.roofs[1].values = {4.2, 2.2};
  house.roofs[1].ridge = Axis::kY;
  Rule dormer = make_rule(RuleKind::kDormer);
  dormer.values = {2.5, -3.6, 2.2, 2.4, 6.6, 0.7};
  dormer.component = 0;
  house.dormers.push_back(dormer);
  Rule chimney = make_rule(RuleKind::kChimney);
  chimney.values = {-5.5, -1.0, 0.9, 9.0};
  house.chimneys.push_back(chimney);
  Rule garage = make_rule(RuleKind::kGarageI);
  garage.values = {9.0, -2.0, 4.0, 6.0, 2.6};
  house.garages.push_back(garage);

  Building building;
  building.id = id;
  building.house = house;
  building.quality = {0.06, 0.09, 12.3};
  return building;
}

Building courtyard_building(const std::string& id) {
  Building building;
  building.id = id;
  building.status = BuildingStatus::kExtrusion;
  building.reason = "the outline has a courtyard, which no foundation of the grammar has";
  building.origin = {651000.0, 5212000.0, 430.0};
  building.outline.outer = {{-6, -6}, {6, -6}, {6, 6}, {-6, 6}};
  building.outline.holes = {{{-2, -2}, {2, -2}, {2, 2}, {-2, 2}}};
  building.height = 6.0;
  building.quality = {0.41, 0.66, 3.0};
  return building;
}

HeightImage image_of(const Building& building, int cells, double gsd, double sigma, uint64_t seed) {
  HeightImage image;
  image.origin = building.house ? building.house->origin : building.origin;
  image.gsd = gsd;
  image.rows = image.cols = cells;
  image.first_center = 0.5 * gsd * (cells - 1) * Eigen::Vector2d(-1.0, 1.0);
  image.height.resize(image.size());
  image.ground.resize(image.size());
  image.weight.assign(image.size(), 1.0f);
  const BuildingSurface surface(building, image.origin);
  Random random(seed);
  for (int row = 0; row < cells; ++row) {
    for (int col = 0; col < cells; ++col) {
      const size_t i = image.index(row, col);
      const Eigen::Vector2d p = image.center_of(row, col);
      image.ground[i] = static_cast<float>(0.02 * p.x());
      image.height[i] =
          static_cast<float>(surface.height(p, gsd, image.ground[i]) + random.normal(sigma));
    }
  }
  return image;
}

}  // namespace gable
