#pragma once

#include <gable/engine/io/models/building.h>

namespace gable {

/// A gabled box of 10 x 8 m, eaves at 3 m, ridge at 5 m, with a chimney and a garage beside it.
inline Building plain_house() {
  House house = make_house(Foundation::kI);
  house.origin = {1000.0, 2000.0, 10.0};
  house.footprints[0].values = {0.0, 0.0, 10.0, 8.0};
  house.roofs[0].values = {3.0, 2.0};
  Rule chimney = make_rule(RuleKind::kChimney);
  chimney.values = {0.0, 2.0, 1.0, 6.0};
  house.chimneys.push_back(chimney);
  Rule garage = make_rule(RuleKind::kGarageI);
  garage.values = {8.0, 0.0, 6.0, 3.0, 2.5};
  house.garages.push_back(garage);
  Building building;
  building.id = "1";
  building.house = house;
  building.base = -0.5;
  return building;
}

}  // namespace gable
