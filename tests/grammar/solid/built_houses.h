#pragma once

#include <gable/grammar/house.h>
#include <gable/grammar/solid/house_solids.h>
#include <gable/grammar/solid/validity.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>

namespace gable {

/// Where houses are built down to, metres in the local frame.
inline constexpr double kBase = -0.25;

/// A turned house of one block of 10 m by 8 m.
inline House one_block(RuleKind kind, const std::array<double, kMaxRuleParameters>& roof) {
  House house = make_house(Foundation::kI);
  house.footprints[0].values = {1.0, 2.0, 10.0, 8.0};
  house.roofs[0] = make_rule(kind);
  house.roofs[0].values = roof;
  house.azimuth[0] = 0.4;
  return house;
}

/// The solids of a house down to kBase, each of which has to be valid.
inline HouseSolids build(const House& house, Lod lod) {
  HouseSolids solids = build_house_solids(house, lod, kBase);
  for (const HousePart& part : solids.parts) {
    EXPECT_EQ(check_solid(part.solid).describe(), "valid");
  }
  return solids;
}

/// The solid of a house that has one and drops nothing.
inline Solid only_solid(const House& house, Lod lod = Lod::k22) {
  const HouseSolids solids = build(house, lod);
  EXPECT_EQ(solids.parts.size(), 1u);
  EXPECT_TRUE(solids.dropped.empty());
  return solids.parts.empty() ? Solid{} : solids.parts[0].solid;
}

/// Cubic metres.
inline double volume(const Solid& solid) { return check_solid(solid).volume; }

/// Of all parts, cubic metres.
inline double total_volume(const HouseSolids& solids) {
  double total = 0.0;
  for (const HousePart& part : solids.parts) total += volume(part.solid);
  return total;
}

inline int count_faces(const Solid& solid, SurfaceType type) {
  return static_cast<int>(std::count_if(solid.faces.begin(), solid.faces.end(),
                                        [type](const Face& f) { return f.type == type; }));
}

inline void expect_counts(const Solid& solid, int roofs, int walls, int grounds, int vertices) {
  EXPECT_EQ(count_faces(solid, SurfaceType::kRoof), roofs);
  EXPECT_EQ(count_faces(solid, SurfaceType::kWall), walls);
  EXPECT_EQ(count_faces(solid, SurfaceType::kGround), grounds);
  EXPECT_EQ(static_cast<int>(solid.vertices.size()), vertices);
}

}  // namespace gable
