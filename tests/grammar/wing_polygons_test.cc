#include <gable/grammar/wing_polygons.h>
#include <gtest/gtest.h>

#include <cmath>

#include "grammar/sample_houses.h"

namespace gable {
namespace {

Rule random_hip(Random* random) {
  return hip_roof(random->uniform(3.0, 5.0), random->uniform(1.0, 4.0), random->uniform(0.0, 0.5),
                  random->uniform(0.0, 0.5), random->chance(0.5) ? Axis::kX : Axis::kY);
}

// Two rectangles of a common box [-8, 9] x [-7, 6] that share its corner.
RoofedRectangle along_x(const Side& corner, double width, Random* random) {
  return {-8.0, 9.0, corner.y() < 0.0 ? -7.0 : 6.0 - width, corner.y() < 0.0 ? -7.0 + width : 6.0,
          random_hip(random)};
}

RoofedRectangle along_y(double end, double width, double y0, double y1, Random* random) {
  return {end < 0.0 ? -8.0 : 9.0 - width, end < 0.0 ? -8.0 + width : 9.0, y0, y1,
          random_hip(random)};
}

TEST(WingPolygons, AnLShowsTheEnvelopeOfItsTwoRectanglesAtEveryCorner) {
  Random random(11);
  for (const double sx : {-1.0, 1.0}) {
    for (const double sy : {-1.0, 1.0}) {
      for (int i = 0; i < 10; ++i) {
        const Side corner(sx, sy);
        const RoofedRectangle x = along_x(corner, random.uniform(3.0, 6.0), &random);
        const RoofedRectangle y = along_y(sx, random.uniform(3.0, 7.0), -7.0, 6.0, &random);
        const double azimuth = random.uniform(-3.0, 3.0);
        const House l = l_house(x, y, corner, azimuth);
        EXPECT_EQ(l.foundation, Foundation::kL);
        EXPECT_TRUE(is_well_formed(l));
        EXPECT_LT(surface_difference(l, blocks_house({x, y}, azimuth), 14.0, 17 + i), 1e-9)
            << "corner " << corner.transpose() << ", house " << i;
      }
    }
  }
}

TEST(WingPolygons, AUShowsTheEnvelopeOfItsThreeRectanglesAtEverySide) {
  Random random(12);
  for (int i = 0; i < 40; ++i) {
    const double azimuth = random.uniform(-3.0, 3.0);
    // Open to +y or -y: the base along x at the other side.
    const double up = i % 2 == 0 ? 1.0 : -1.0;
    RoofedRectangle base = along_x(Side(0.0, -up), random.uniform(3.0, 6.0), &random);
    const double long_a = random.uniform(8.0, 13.0), long_b = random.uniform(8.0, 13.0);
    const auto wing = [&](double end, double length) {
      return along_y(end, random.uniform(3.0, 6.0), up > 0.0 ? -7.0 : 6.0 - length,
                     up > 0.0 ? -7.0 + length : 6.0, &random);
    };
    RoofedRectangle a = wing(-1.0, long_a), b = wing(1.0, long_b);
    Side open(0.0, up);
    if (i % 4 >= 2) {
      // Mirrored at the diagonal: open to +x or -x.
      for (RoofedRectangle* r : {&base, &a, &b}) {
        std::swap(r->x0, r->y0);
        std::swap(r->x1, r->y1);
      }
      open = Side(up, 0.0);
    }
    for (const bool swapped : {false, true}) {
      const House u = u_house(base, swapped ? b : a, swapped ? a : b, open, azimuth);
      EXPECT_EQ(u.foundation, Foundation::kU);
      EXPECT_TRUE(is_well_formed(u));
      EXPECT_LT(surface_difference(u, blocks_house({base, a, b}, azimuth), 14.0, 23 + i), 1e-9)
          << "open to " << open.transpose() << ", house " << i;
    }
  }
}

TEST(WingPolygons, TurnTheAzimuthByWholeQuartersUntilTheCornerIsLow) {
  Random random(13);
  const auto turned = [&](double sx, double sy) {
    const Side corner(sx, sy);
    return l_house(along_x(corner, 4.0, &random), along_y(sx, 5.0, -7.0, 6.0, &random), corner,
                   0.25)
        .azimuth[0];
  };
  EXPECT_NEAR(turned(-1.0, -1.0), 0.25, 1e-12);
  EXPECT_NEAR(turned(1.0, -1.0), 0.25 + 0.5 * M_PI, 1e-12);
  EXPECT_NEAR(turned(1.0, 1.0), 0.25 + M_PI, 1e-12);
  EXPECT_NEAR(turned(-1.0, 1.0), 0.25 + 1.5 * M_PI, 1e-12);
}

TEST(WingPolygons, SwapTheEndsOfARidgeThatIsTurnedRound) {
  const RoofedRectangle x{-8.0, 9.0, 2.0, 6.0, hip_roof(4.0, 2.0, 0.1, 0.3, Axis::kX)};
  const RoofedRectangle y{4.0, 9.0, -7.0, 6.0, hip_roof(4.0, 2.0, 0.2, 0.4, Axis::kY)};
  const House l = l_house(x, y, Side(1.0, 1.0), 0.0);  // half a turn
  EXPECT_EQ(l.roofs[0].ridge, Axis::kX);
  EXPECT_EQ(l.roofs[0][param::roof::kHipStart], 0.3);
  EXPECT_EQ(l.roofs[0][param::roof::kHipEnd], 0.1);
  EXPECT_EQ(l.roofs[1].ridge, Axis::kY);
  EXPECT_EQ(l.roofs[1][param::roof::kHipStart], 0.4);
  EXPECT_EQ(l.roofs[1][param::roof::kHipEnd], 0.2);
}

TEST(WingPolygons, AverageCornersThatNearlyAgree) {
  const RoofedRectangle x{-8.0, 9.0, -7.0, -3.0, flat_roof(4.0)};
  const RoofedRectangle y{-7.6, -2.0, -6.8, 6.0, flat_roof(4.0)};
  const House l = l_house(x, y, Side(-1.0, -1.0), 0.0);
  namespace p = param::l_polygon;
  EXPECT_NEAR(l.footprints[0][p::kCornerX], -7.8, 1e-12);
  EXPECT_NEAR(l.footprints[0][p::kCornerY], -6.9, 1e-12);
  // The free ends stay where they were.
  EXPECT_NEAR(l.footprints[0][p::kWingXLength], 9.0 + 7.8, 1e-12);
  EXPECT_NEAR(l.footprints[0][p::kWingXWidth], -3.0 + 6.9, 1e-12);
  EXPECT_NEAR(l.footprints[0][p::kWingYLength], 6.0 + 6.9, 1e-12);
  EXPECT_NEAR(l.footprints[0][p::kWingYWidth], -2.0 + 7.8, 1e-12);
}

TEST(WingPolygons, BlocksHousesGiveTheirRectanglesBack) {
  Random random(14);
  const std::vector<RoofedRectangle> blocks = {{-3.0, 5.0, -2.0, 4.0, random_hip(&random)},
                                               {5.0, 9.0, -1.0, 3.0, random_hip(&random)},
                                               {-7.0, -3.0, 0.0, 3.5, random_hip(&random)},
                                               {-3.0, 1.0, 4.0, 8.5, random_hip(&random)},
                                               {1.0, 4.0, -8.0, -2.0, random_hip(&random)}};
  const Foundation types[] = {Foundation::kI, Foundation::kII, Foundation::kIII, Foundation::kMany,
                              Foundation::kMany};
  for (size_t n = 1; n <= 5; ++n) {
    const House house = blocks_house({blocks.begin(), blocks.begin() + n}, 0.4);
    EXPECT_EQ(house.foundation, types[n - 1]);
    EXPECT_TRUE(is_well_formed(house));
    const std::vector<RoofedRectangle> out = roofed_rectangles(house);
    ASSERT_EQ(out.size(), n);
    for (size_t i = 0; i < n; ++i) {
      EXPECT_NEAR(out[i].x0, blocks[i].x0, 1e-12);
      EXPECT_NEAR(out[i].x1, blocks[i].x1, 1e-12);
      EXPECT_NEAR(out[i].y0, blocks[i].y0, 1e-12);
      EXPECT_NEAR(out[i].y1, blocks[i].y1, 1e-12);
      EXPECT_EQ(out[i].roof.values, blocks[i].roof.values);
      EXPECT_EQ(out[i].roof.ridge, blocks[i].roof.ridge);
    }
  }
}

}  // namespace
}  // namespace gable
