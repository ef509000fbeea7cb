#include <gable/grammar/height_field.h>
#include <gable/grammar/outline_margins.h>
#include <gable/grammar/outlined_house.h>
#include <gable/grammar/random.h>
#include <gable/grammar/ring.h>
#include <gable/grammar/solid/house_solids.h>
#include <gable/grammar/solid/validity.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "grammar/solid/nasty_houses.h"

namespace gable {
namespace {

House gable_house() {
  House house = make_house(Foundation::kI);
  house.azimuth[0] = 0.4;
  house.footprints[0].values = {0.0, 0.0, 10.0, 6.0};
  house.roofs[0] = make_rule(RuleKind::kRoofGable);
  house.roofs[0].ridge = Axis::kX;
  house.roofs[0][param::roof::kEaves] = 3.0;
  house.roofs[0][param::roof::kRise] = 3.0;
  return house;
}

PlanPolygon turned(std::vector<Eigen::Vector2d> ring, double azimuth) {
  for (Eigen::Vector2d& p : ring) p = Eigen::Rotation2Dd(azimuth) * p;
  return {ring, {}};
}

double volume(const HouseSolids& solids) {
  double sum = 0.0;
  for (const HousePart& part : solids.parts) sum += check_solid(part.solid).volume;
  return sum;
}

TEST(OutlinedSolids, HaveTheVolumeUnderTheRoofInsideTheOutline) {
  // An oblique front: x from -5 to between 2 (south) and 4 (north); the roof goes on 0.5 m at y
  // = 3.
  const PlanPolygon outline = turned({{-5.0, -3.0}, {2.0, -3.0}, {4.0, 3.5}, {-5.0, 3.5}}, 0.4);
  const HouseSolids solids = build_house_solids(gable_house(), Lod::k22, 0.0, {outline, 0.5});
  ASSERT_EQ(solids.parts.size(), 1u);
  EXPECT_EQ(check_solid(solids.parts[0].solid).describe(), "valid");
  // Integral of the height 6 - |y| over a width of 7 + 2 (y + 3) / 6.5, y from -3 to 3.5.
  double expected = 0.0;
  constexpr int kSteps = 650000;
  for (int i = 0; i < kSteps; ++i) {
    const double y = -3.0 + 6.5 * (i + 0.5) / kSteps;
    expected += (6.0 - std::abs(y)) * (7.0 + 2.0 * (y + 3.0) / 6.5) * 6.5 / kSteps;
  }
  EXPECT_NEAR(volume(solids), expected, 1e-6 * expected);
}

TEST(OutlinedSolids, CoarserLevelsEndAtTheOutlineAsWell) {
  const PlanPolygon outline = turned({{-5.0, -3.0}, {2.0, -3.0}, {4.0, 3.0}, {-5.0, 3.0}}, 0.4);
  EXPECT_NEAR(volume(build_house_solids(gable_house(), Lod::k12, 0.0, {outline, 0.0})), 48.0 * 5.0,
              1e-6);
  EXPECT_NEAR(volume(build_house_solids(gable_house(), Lod::k20, 0.0, {outline, 0.0})),
              volume(build_house_solids(gable_house(), Lod::k22, 0.0, {outline, 0.0})), 1e-9);
}

TEST(OutlinedSolids, EdgesThatAllButCoincideWithWallsLeaveNoStrips) {
  const HouseSolids exact = build_house_solids(
      gable_house(), Lod::k22, 0.0, {turned({{-5, -3}, {2, -3}, {4, 3}, {-5, 3}}, 0.4), 0.0});
  ASSERT_EQ(exact.parts.size(), 1u);
  Random random(3);
  for (int i = 0; i < 100; ++i) {
    Ring ring = {{-5, -3}, {2, -3}, {4, 3}, {-5, 3}};
    for (Eigen::Vector2d& p : ring) {
      p += Eigen::Vector2d(random.uniform(-0.019, 0.019), random.uniform(-0.019, 0.019));
    }
    const HouseSolids near =
        build_house_solids(gable_house(), Lod::k22, 0.0, {turned(ring, 0.4), 0.0});
    ASSERT_EQ(near.parts.size(), 1u);
    EXPECT_EQ(near.parts[0].solid.vertices.size(), exact.parts[0].solid.vertices.size());
    EXPECT_EQ(check_solid(near.parts[0].solid).describe(), "valid");
  }
}

// Outlines with corners on the walls of blocks, as snapped_outline.h makes them.
TEST(OutlinedSolids, ThatShareWallsWithNastyHousesAreValid) {
  NastyHouses houses(21);
  Random random(22);
  int built = 0;
  constexpr int kHouses = 100;
  for (int i = 0; i < kHouses; ++i) {
    const House house = houses.next();
    const HeightField field(house);
    std::vector<double> x, y;
    for (size_t b = 0; b < field.blocks().size(); ++b) {
      using namespace block_value;
      if (stands_on_roof(field.sources()[b].role)) continue;
      const Block<double>& block = field.blocks()[b];
      x.insert(x.end(), {block[kX0], block[kX1]});
      y.insert(y.end(), {block[kY0], block[kY1]});
    }
    const auto one_of = [&](const std::vector<double>& values) {
      return values[random.integer(0, static_cast<int>(values.size()) - 1)] +
             (random.chance(0.3) ? random.uniform(-1.0, 1.0) : 0.0);
    };
    const double x0 = one_of(x), x1 = one_of(x), y0 = one_of(y), y1 = one_of(y);
    Ring ring = {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
    ring[random.integer(0, 3)].x() = one_of(x);  // an oblique wall
    for (Eigen::Vector2d& p : ring) p = field.local_from_house(p);
    const KnownOutline walls{{ring, {}}, kOutlineMargins[random.integer(0, 2)]};
    const HouseSolids solids = build_house_solids(house, Lod::k22, -0.3, walls);
    for (const HousePart& part : solids.parts) {
      ASSERT_EQ(check_solid(part.solid).describe(), "valid") << i;
    }
    built += std::none_of(solids.dropped.begin(), solids.dropped.end(), [](const auto& line) {
      return line.find("no valid solid") != std::string::npos;
    });
  }
  EXPECT_GE(built, kHouses * 19 / 20);
}

TEST(OutlinedSolids, OfNastyHousesAreValidAndFillWhatIsSeenFromAbove) {
  NastyHouses houses(11);
  Random random(12);
  int built = 0;
  constexpr int kHouses = 60;
  for (int i = 0; i < kHouses; ++i) {
    const House house = houses.next();
    std::vector<Eigen::Vector2d> ring;
    const int corners = random.integer(3, 9);
    for (int k = 0; k < corners; ++k) {
      const double angle = 2.0 * M_PI * (k + random.uniform(0.0, 0.8)) / corners;
      const double radius = random.uniform(2.0, 11.0);
      ring.push_back({radius * std::cos(angle), radius * std::sin(angle)});
    }
    const KnownOutline walls{{ring, {}}, kOutlineMargins[random.integer(0, 2)]};
    const HouseSolids solids = build_house_solids(house, Lod::k22, -0.3, walls);
    for (const HousePart& part : solids.parts) {
      ASSERT_EQ(check_solid(part.solid).describe(), "valid") << i;
    }
    bool whole = true;
    for (const std::string& line : solids.dropped) {
      whole = whole && line.find("no valid solid") == std::string::npos;
    }
    if (!whole) continue;
    ++built;
    const OutlinedHouse seen(house, walls);
    double expected = 0.0;
    constexpr double kStep = 0.04;
    for (double x = -12.0; x < 12.0; x += kStep) {
      for (double y = -12.0; y < 12.0; y += kStep) {
        if (const auto top = seen.at_local({x, y})) {
          expected += std::max(0.0, top->height + 0.3) * kStep * kStep;
        }
      }
    }
    EXPECT_NEAR(volume(solids), expected, 0.02 * expected + 1.0) << i;
  }
  EXPECT_GE(built, kHouses * 19 / 20);
}

}  // namespace
}  // namespace gable
