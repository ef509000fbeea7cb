#include <gable/engine/io/building.h>
#include <gable/grammar/height_field.h>

#include <cstdio>

// Prints the ridge height of a house: 3 m of wall and 2 m of roof.
int main() {
  gable::House house = gable::make_house(gable::Foundation::kI);
  house.footprints[0].values = {0.0, 0.0, 10.0, 8.0};
  house.roofs[0].values = {3.0, 2.0};
  const gable::HeightField field(house);
  std::printf("%s %.3f\n", gable::building_status_name(gable::BuildingStatus::kGrammar),
              field.at_local({0.0, 0.0}, 0.0, 0.0));
}
