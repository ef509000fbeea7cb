#pragma once

#include <gable/engine/io/models/building.h>
#include <gable/engine/io/models/building_model.h>

#include <algorithm>
#include <string>

namespace gable {

/// An L-shaped house with a dormer, a chimney and both kinds of garage, awkward numbers
/// throughout, and deviations.
inline Building sample_house(const std::string& id) {
  House house = make_house(Foundation::kL);
  house.origin = {84893.1234567891, 447512.7654321, 1.0 / 3.0};
  house.azimuth[0] = 2.0 / 7.0;
  house.footprints[0].values = {-5.1, -4.2, 12.0 / 7.0 + 8.0, 6.1, 11.3, 5.7};
  house.roofs[0] = make_rule(RuleKind::kRoofMansard);
  house.roofs[0].values = {2.9, 2.1, 2.0 / 3.0, 0.3};
  house.roofs[1] = make_rule(RuleKind::kRoofHip);
  house.roofs[1].ridge = Axis::kY;
  house.roofs[1].values = {3.1, 1.0 / 3.0, 0.1, 0.25};
  Rule dormer = make_rule(RuleKind::kDormer);
  dormer.component = 1;
  dormer[param::dormer::kCenterX] = 0.1 + 0.2;
  house.dormers.push_back(dormer);
  house.chimneys.push_back(make_rule(RuleKind::kChimney));
  house.garages.push_back(make_rule(RuleKind::kGarageL));
  house.garages.push_back(make_rule(RuleKind::kGarageI));
  Building building;
  building.id = id;
  building.reason = "the second chimney is inside the attic";
  building.quality = {0.123456789, 0.2, 17.25};
  building.base = -0.4;
  for (const Rule* rule : house.derivation()) {
    building.deviations.emplace_back(rule->size(), 0.01 + building.deviations.size() / 3.0);
  }
  building.house = house;
  return building;
}

/// A courtyard outside the grammar.
inline Building sample_extrusion(const std::string& id) {
  Building building;
  building.id = id;
  building.status = BuildingStatus::kExtrusion;
  building.reason = "its outline has a courtyard";
  building.quality = {0.5, 0.75, -1.0};
  building.origin = {84900.5, 447500.25, -1.5};
  building.outline.outer = {{0, 0}, {10, 0}, {10, 10}, {0, 10}};
  building.outline.holes = {{{3, 3}, {3, 6.1}, {6, 6}, {6, 3}}};
  building.height = 8.0 / 3.0;
  building.base = -0.25;
  return building;
}

/// A gable roof of 10 x 6 beside a flat one, outside the grammar: closed planes.
inline Building sample_planes(const std::string& id) {
  Building building;
  building.id = id;
  building.status = BuildingStatus::kPlanes;
  building.reason = "no house of the grammar explains the heights";
  building.quality = {0.1, 0.2, 12.0};
  building.origin = {84900.5, 447500.25, -1.5};
  building.outline.outer = {{0, 0}, {14, 0}, {14, 6}, {0, 6}};
  building.height = 11.0 / 3.0;
  building.base = -0.25;
  RoofPartition roof;
  roof.planes = {{0, 2.0 / 3.0, 3}, {0, -2.0 / 3.0, 7}, {0, 0, 2.5}};
  roof.regions = {{0, {{{0, 0}, {10, 0}, {10, 3}, {0, 3}}, {}}},
                  {1, {{{0, 3}, {10, 3}, {10, 6}, {0, 6}}, {}}},
                  {2, {{{10, 0}, {14, 0}, {14, 6}, {10, 6}, {10, 3}}, {}}}};
  building.roof = roof;
  return building;
}

/// The box [x0, x1] x [y0, y1] x [z0, z1] as a closed, outward solid.
inline Solid box(const Eigen::Vector3d& low, const Eigen::Vector3d& high) {
  Solid solid;
  for (int i = 0; i < 8; ++i) {
    solid.vertices.emplace_back(i & 1 ? high.x() : low.x(), i & 2 ? high.y() : low.y(),
                                i & 4 ? high.z() : low.z());
  }
  solid.faces = {{{{0, 2, 3, 1}}, SurfaceType::kGround}, {{{4, 5, 7, 6}}, SurfaceType::kRoof},
                 {{{0, 1, 5, 4}}, SurfaceType::kWall},   {{{1, 3, 7, 5}}, SurfaceType::kWall},
                 {{{3, 2, 6, 7}}, SurfaceType::kWall},   {{{2, 0, 4, 6}}, SurfaceType::kWall}};
  return solid;
}

/// The box [0, 10]^2 x [0, 3] with the shaft [3, 6]^2 through it.
inline Solid box_with_shaft() {
  Solid solid = box({0, 0, 0}, {10, 10, 3});
  const Solid shaft = box({3, 3, 0}, {6, 6, 3});
  solid.vertices.insert(solid.vertices.end(), shaft.vertices.begin(), shaft.vertices.end());
  for (size_t f = 0; f < shaft.faces.size(); ++f) {
    std::vector<int> ring = shaft.faces[f].rings[0];
    std::reverse(ring.begin(), ring.end());
    for (int& v : ring) v += 8;
    if (f < 2) {
      solid.faces[f].rings.push_back(ring);
    } else {
      solid.faces.push_back({{ring}, SurfaceType::kWall});
    }
  }
  return solid;
}

/// A model of boxes: a main body at all levels of detail, a chimney at 2.2 only.
inline BuildingModel sample_model(const Eigen::Vector3d& origin) {
  BuildingModel model;
  model.origin = origin;
  const Solid body = box_with_shaft();
  model.parts.push_back(
      {PartRole::kMain, 0, 0, {{Lod::k12, body}, {Lod::k20, body}, {Lod::k22, body}}});
  model.parts.push_back({PartRole::kChimney, 0, 0, {{Lod::k22, box({1, 1, 3}, {2, 2, 5})}}});
  return model;
}

}  // namespace gable
