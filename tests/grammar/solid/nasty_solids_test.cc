#include <gable/grammar/solid/house_solids.h>
#include <gable/grammar/solid/validity.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "grammar/solid/built_houses.h"
#include "grammar/solid/nasty_houses.h"

namespace gable {
namespace {

Solid rounded(const Solid& solid, const Eigen::Vector3d& offset) {
  Solid result = solid;
  for (Eigen::Vector3d& p : result.vertices) {
    for (int k = 0; k < 3; ++k) p[k] = std::round((p[k] + offset[k]) * 1e4) * 1e-4;
  }
  return result;
}

TEST(HouseSolids, TwoThousandNastyDerivationsAreValidAtEveryLevel) {
  NastyHouses houses(31);
  Random random(32);
  for (int i = 0; i < 2000; ++i) {
    const House house = houses.next();
    for (const Lod lod : {Lod::k12, Lod::k20, Lod::k22}) {
      const HouseSolids solids = build_house_solids(house, lod, kBase);
      ASSERT_FALSE(solids.parts.empty());
      EXPECT_EQ(solids.parts[0].role, PartRole::kMain);
      for (const std::string& line : solids.dropped) {
        EXPECT_EQ(line.find("valid"), std::string::npos) << "house " << i << ": " << line;
      }
      for (const HousePart& part : solids.parts) {
        EXPECT_EQ(check_solid(part.solid).describe(), "valid") << "house " << i;
        // As a file stores it: 0.1 mm steps from some corner of a map. Rounding may take the tenth
        // of a millimetre off the resolution that the builder keeps.
        const Eigen::Vector3d offset(random.uniform(0, 1), random.uniform(0, 1), 0.0);
        EXPECT_EQ(check_solid(rounded(part.solid, offset), {1e-3, 2.8e-3}).describe(), "valid")
            << "house " << i;
      }
    }
  }
}

TEST(HouseSolids, NastyDerivationsOfFourToEightBlocksAreValidAndNearlyAllHaveTheirRoofs) {
  NastyHouses houses(33);
  int flattened = 0, unbuilt = 0;
  for (int i = 0; i < 300; ++i) {
    const House house = houses.next_of_many();
    ASSERT_TRUE(is_well_formed(house));
    for (const Lod lod : {Lod::k12, Lod::k22}) {
      const HouseSolids solids = build_house_solids(house, lod, kBase);
      unbuilt += solids.parts.empty();
      for (const std::string& line : solids.dropped) {
        flattened += line.find("valid") != std::string::npos;
      }
      for (const HousePart& part : solids.parts) {
        EXPECT_EQ(check_solid(part.solid).describe(), "valid") << "house " << i;
      }
    }
  }
  // So many blocks hide and cut one another in features too fine to build now and then.
  EXPECT_LE(flattened, 12) << "of 600";
  EXPECT_LE(unbuilt, 1) << "of 600";
}

TEST(HouseSolids, SameHouseGivesTheSameSolids) {
  NastyHouses houses(41);
  for (int i = 0; i < 50; ++i) {
    const House house = houses.next();
    const HouseSolids once = build_house_solids(house, Lod::k22, kBase);
    const HouseSolids again = build_house_solids(house, Lod::k22, kBase);
    ASSERT_EQ(once.parts.size(), again.parts.size());
    for (size_t p = 0; p < once.parts.size(); ++p) {
      EXPECT_EQ(once.parts[p].solid.vertices, again.parts[p].solid.vertices);
    }
  }
}

}  // namespace
}  // namespace gable
