// A house as a derivation of rules, and its height at a point.
#include <gable/grammar/height_field.h>

#include <cstdio>

int main() {
  using namespace gable;
  House house = make_house(Foundation::kL);    // every rule at its table's initial values
  house.origin = {417250.0, 202340.0, 118.5};  // easting, northing, height of the terrain; m
  house.azimuth[0] = 0.35;                     // rad, anticlockwise from east
  house.roofs[0] = make_rule(RuleKind::kRoofHip);
  house.roofs[0][param::roof::kEaves] = 5.1;  // m above the origin
  house.roofs[0][param::roof::kRise] = 2.4;   // m from the eaves to the ridge

  const HeightField field(house);
  const Eigen::Vector2d point(4.0, 5.0);     // m east and north of the origin
  const double support = 0.5, ground = 0.0;  // averaged over half a metre; level terrain
  std::printf("%.2f m\n", field.at_local(point, support, ground));
}
