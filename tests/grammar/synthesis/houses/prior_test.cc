#include <gable/grammar/height_field.h>
#include <gable/grammar/synthesis/houses/distinct.h>
#include <gable/grammar/synthesis/houses/prior.h>
#include <gable/grammar/synthesis/houses/rectangle.h>
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace gable {
namespace {

constexpr Foundation kFoundations[] = {Foundation::kI, Foundation::kII, Foundation::kIII,
                                       Foundation::kL, Foundation::kU};

std::vector<House> many_houses(int count_per_type, const PriorOptions& options = {}) {
  Random random(11);
  std::vector<House> houses;
  for (Foundation foundation : kFoundations) {
    for (int i = 0; i < count_per_type; ++i) {
      houses.push_back(random_house(foundation, &random, options));
    }
  }
  return houses;
}

/// Every detail wanted on every house.
PriorOptions detailed() {
  PriorOptions options;
  options.dormer_share = options.chimney_share = options.garage_share = 1.0;
  return options;
}

House without_details(House house) {
  house.dormers.clear();
  house.chimneys.clear();
  return house;
}

House main_only(House house) {
  house = without_details(std::move(house));
  house.garages.clear();
  return house;
}

/// Corners of the outline of all blocks, counted on a fine grid: a node is a corner where one or
/// three of the four cells around it are covered.
int count_outline_corners(const House& house) {
  const HeightField field(house);
  const double step = 0.1;
  const int n = 320;
  std::vector<std::vector<bool>> covered(n, std::vector<bool>(n));
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      const Eigen::Vector2d p((i - n / 2) * step, (j - n / 2) * step);
      covered[i][j] = field.block_at_house(p) >= 0;
    }
  }
  int corners = 0;
  for (int i = 0; i + 1 < n; ++i) {
    for (int j = 0; j + 1 < n; ++j) {
      const int sum = covered[i][j] + covered[i + 1][j] + covered[i][j + 1] + covered[i + 1][j + 1];
      if (sum == 1 || sum == 3) ++corners;
    }
  }
  return corners;
}

TEST(Prior, SameSeedGivesTheSameHouse) {
  for (uint64_t seed = 0; seed < 50; ++seed) {
    Random a(seed), b(seed);
    const House first = random_house(&a), second = random_house(&b);
    ASSERT_EQ(first.foundation, second.foundation);
    const auto rules_a = first.derivation(), rules_b = second.derivation();
    ASSERT_EQ(rules_a.size(), rules_b.size());
    for (size_t i = 0; i < rules_a.size(); ++i) {
      EXPECT_EQ(rules_a[i]->kind, rules_b[i]->kind);
      EXPECT_EQ(rules_a[i]->values, rules_b[i]->values);
    }
  }
}

TEST(Prior, EveryHouseIsWellFormedAndWithinBounds) {
  for (const House& house : many_houses(400, detailed())) {
    ASSERT_TRUE(is_well_formed(house));
    EXPECT_GE(house.azimuth[0], 0.0);
    EXPECT_LT(house.azimuth[0], 2.0 * M_PI);
    for (const Rule* rule : house.derivation()) {
      const auto specs = parameter_specs(rule->kind);
      for (int i = 0; i < rule->size(); ++i) {
        EXPECT_GE((*rule)[i], specs[i].lower) << rule_name(rule->kind) << " " << specs[i].name;
        EXPECT_LE((*rule)[i], specs[i].upper) << rule_name(rule->kind) << " " << specs[i].name;
      }
    }
  }
}

TEST(Prior, EavesAndPitchesAreThoseOfHouses) {
  for (const House& house : many_houses(400)) {
    const auto blocks = expand_blocks(house);
    for (int i = 0; i < house.num_components(); ++i) {
      using namespace block_value;
      EXPECT_GE(blocks[i][kEaves], 2.1);
      EXPECT_LE(blocks[i][kEaves], 6.5);
      if (blocks[i].flat) continue;
      const Rectangle r = rectangle_of(blocks[i]);
      const double span = blocks[i].ridge == Axis::kX ? r.size_y() : r.size_x();
      const double degrees = std::atan(blocks[i][kRise] / (0.5 * span)) * 180.0 / M_PI;
      EXPECT_GE(degrees, 25.0 - 1e-9);
      EXPECT_LE(degrees, 50.0 + 1e-9);
      EXPECT_LE(blocks[i][kEaves] + blocks[i][kRise], 13.0);
    }
  }
}

TEST(Prior, HipsAreNeverFlatterThanTheSidesExceptOnPyramids) {
  for (const House& house : many_houses(400)) {
    for (const Block<double>& block : expand_blocks(main_only(house))) {
      using namespace block_value;
      const Rectangle r = rectangle_of(block);
      const bool along_x = block.ridge == Axis::kX;
      const double length = along_x ? r.size_x() : r.size_y();
      const double half_span = 0.5 * (along_x ? r.size_y() : r.size_x());
      const bool pyramid = block[kHipStart] == 0.5 && block[kHipEnd] == 0.5;
      const double longest = (pyramid ? 1.25 : 1.0) * half_span + 1e-9;
      EXPECT_LE(block[kHipStart] * length, longest);
      EXPECT_LE(block[kHipEnd] * length, longest);
    }
  }
}

TEST(Prior, HousesFitTheirCropAndAreCentred) {
  for (const House& house : many_houses(400, detailed())) {
    const auto sources = block_sources(house);
    const auto blocks = expand_blocks(house);
    Rectangle main = rectangle_of(blocks[0]), all = main;
    for (size_t i = 0; i < blocks.size(); ++i) {
      all = bounds(all, rectangle_of(blocks[i]));
      if (sources[i].role == BlockRole::kComponent) main = bounds(main, rectangle_of(blocks[i]));
    }
    EXPECT_NEAR(main.mid_x(), 0.0, 1e-9);
    EXPECT_NEAR(main.mid_y(), 0.0, 1e-9);
    EXPECT_LE(std::hypot(all.size_x(), all.size_y()), 30.0);
  }
}

TEST(Prior, TypesAreDistinct) {
  for (const House& house : many_houses(400)) EXPECT_TRUE(is_distinct(house));
}

TEST(Prior, TwoBlocksWithoutAHeightStepHaveAnOutlineThatNoOtherTypeHas) {
  int checked = 0;
  Random random(5);
  for (int i = 0; i < 300; ++i) {
    const House house = main_only(random_house(Foundation::kII, &random));
    if (std::abs(house.roofs[0][param::roof::kEaves] - house.roofs[1][param::roof::kEaves]) >=
        kDistinctStep) {
      continue;
    }
    ++checked;
    EXPECT_GE(count_outline_corners(house), 8);
  }
  EXPECT_GT(checked, 50);
}

TEST(Prior, OnePolygonTypesHaveTheirNumberOfCorners) {
  Random random(6);
  for (int i = 0; i < 100; ++i) {
    EXPECT_EQ(count_outline_corners(main_only(random_house(Foundation::kI, &random))), 4);
    EXPECT_EQ(count_outline_corners(main_only(random_house(Foundation::kL, &random))), 6);
    const House u = main_only(random_house(Foundation::kU, &random));
    // Wings of the same length still have a corner each.
    EXPECT_EQ(count_outline_corners(u), 8);
  }
}

TEST(Prior, DormersLieInsideOneSlopeAndStandOutOfIt) {
  int dormers = 0;
  for (const House& house : many_houses(300, detailed())) {
    House bare = without_details(house);
    const HeightField roof(bare);
    House dormers_only = house;
    dormers_only.chimneys.clear();
    const HeightField field(dormers_only);
    for (size_t i = 0; i < field.blocks().size(); ++i) {
      if (field.sources()[i].role != BlockRole::kDormer) continue;
      ++dormers;
      const int component = house.dormers[field.sources()[i].index].component;
      const Block<double>& parent = field.blocks()[component];
      const Rectangle r = rectangle_of(field.blocks()[i]), p = rectangle_of(parent);
      EXPECT_GE(r.x0, p.x0);
      EXPECT_LE(r.x1, p.x1);
      EXPECT_GE(r.y0, p.y0);
      EXPECT_LE(r.y1, p.y1);
      // One plane: the roof is linear over the dormer's base.
      const double z00 = roof_height(parent, r.x0, r.y0), z11 = roof_height(parent, r.x1, r.y1);
      const double z01 = roof_height(parent, r.x0, r.y1), z10 = roof_height(parent, r.x1, r.y0);
      EXPECT_NEAR(roof_height(parent, r.mid_x(), r.mid_y()), 0.25 * (z00 + z11 + z01 + z10), 1e-9);
      EXPECT_NEAR(z00 + z11, z01 + z10, 1e-9);
      // It dies into the slope below the ridge.
      using namespace block_value;
      const Block<double>& block = field.blocks()[i];
      const double highest = std::max({z00, z11, z01, z10});
      EXPECT_LE(block[kEaves] + block[kRise], highest + 1e-9);
      EXPECT_LT(highest, parent[kEaves] + parent[kRise]);
      // Seen from above: at least 1 m2 by more than 0.3 m, and 0.8 m somewhere.
      double area = 0.0, lift = 0.0;
      for (double x = r.x0 + 0.025; x < r.x1; x += 0.05) {
        for (double y = r.y0 + 0.025; y < r.y1; y += 0.05) {
          const double gain = field.at_house({x, y}, 0.0, 0.0) - roof.at_house({x, y}, 0.0, 0.0);
          if (gain > 0.3) area += 0.0025;
          lift = std::max(lift, gain);
        }
      }
      EXPECT_GE(area, 1.0);
      EXPECT_GE(lift, 0.8);
    }
  }
  EXPECT_GT(dormers, 500);
}

TEST(Prior, ChimneysRiseOverEverythingUnderThem) {
  int chimneys = 0;
  for (const House& house : many_houses(300, detailed())) {
    House bare = house;
    bare.chimneys.clear();
    const HeightField roof(bare);
    for (const Rule& chimney : house.chimneys) {
      namespace c = param::chimney;
      ++chimneys;
      EXPECT_GE(chimney[c::kSide], 0.7);
      EXPECT_LE(chimney[c::kSide], 1.3);
      double highest = 0.0;
      const double half = 0.5 * chimney[c::kSide];
      for (int i = 0; i <= 40; ++i) {
        for (int j = 0; j <= 40; ++j) {
          const Eigen::Vector2d p(chimney[c::kCenterX] + half * (i / 20.0 - 1.0) * 0.9999999,
                                  chimney[c::kCenterY] + half * (j / 20.0 - 1.0) * 0.9999999);
          const double z = roof.at_house(p, 0.0, -1.0);
          EXPECT_GT(z, 0.0) << "a chimney beside the house";
          highest = std::max(highest, z);
        }
      }
      EXPECT_GE(chimney[c::kHeight] - highest, 0.8 - 1e-6);
      EXPECT_LE(chimney[c::kHeight] - highest, 2.0 + 0.1);
    }
  }
  EXPECT_GT(chimneys, 1200);
}

TEST(Prior, DetailsKeepClearOfEachOther) {
  for (const House& house : many_houses(300, detailed())) {
    const auto sources = block_sources(house);
    const auto blocks = expand_blocks(house);
    for (size_t i = 0; i < blocks.size(); ++i) {
      for (size_t j = 0; j < i; ++j) {
        if (stands_on_roof(sources[i].role) && stands_on_roof(sources[j].role)) {
          EXPECT_GE(distance(rectangle_of(blocks[i]), rectangle_of(blocks[j])), 0.45);
        }
      }
    }
  }
}

TEST(Prior, GaragesStandOutsideAndAgainstAWall) {
  int garages = 0, l_shaped = 0;
  for (const House& house : many_houses(300, detailed())) {
    const auto sources = block_sources(house);
    const auto blocks = expand_blocks(house);
    std::vector<bool> touches(house.garages.size(), false);
    for (size_t i = 0; i < blocks.size(); ++i) {
      if (sources[i].role != BlockRole::kGarage) continue;
      ++garages;
      if (sources[i].wing == 1) ++l_shaped;
      EXPECT_GE(blocks[i][block_value::kEaves], 2.2);
      EXPECT_LE(blocks[i][block_value::kEaves], 3.2);
      for (size_t j = 0; j < blocks.size(); ++j) {
        const Rectangle a = rectangle_of(blocks[i]), b = rectangle_of(blocks[j]);
        if (sources[j].role == BlockRole::kComponent) {
          EXPECT_LE(shared_area(a, b), 1e-6);
          EXPECT_LE(blocks[i][block_value::kEaves], blocks[j][block_value::kEaves] - 0.4 + 1e-9);
          // Half of the shortest side, at least: 1.3 m of wall.
          const double dx = std::min(a.x1, b.x1) - std::max(a.x0, b.x0);
          const double dy = std::min(a.y1, b.y1) - std::max(a.y0, b.y0);
          if (std::min(dx, dy) > -1e-9 && std::max(dx, dy) > 1.0) {
            touches[sources[i].index] = true;
          }
        } else if (sources[j].role == BlockRole::kGarage && sources[j].index != sources[i].index) {
          EXPECT_LE(shared_area(a, b), 1e-6);
        }
      }
    }
    for (bool t : touches) EXPECT_TRUE(t);
  }
  EXPECT_GT(garages, 1000);
  EXPECT_GT(l_shaped, 50);
}

TEST(Prior, OptionsNameTheBoundThatFails) {
  PriorOptions options;
  EXPECT_EQ(options.check(), "");
  options.dormer_share = 1.5;
  EXPECT_EQ(options.check(), "dormer_share must be in [0, 1]");
  options = {};
  options.foundation_weights = {0.0, 0.0, 0.0, 0.0, 0.0};
  EXPECT_EQ(options.check(), "foundation_weights must not all be 0");
}

TEST(Prior, FoundationsFollowTheirWeights) {
  PriorOptions options;
  options.foundation_weights = {3.0, 0.0, 0.0, 1.0, 0.0};
  Random random(3);
  int i_count = 0;
  for (int i = 0; i < 1000; ++i) {
    const Foundation foundation = random_house(&random, options).foundation;
    ASSERT_TRUE(foundation == Foundation::kI || foundation == Foundation::kL);
    if (foundation == Foundation::kI) ++i_count;
  }
  EXPECT_NEAR(i_count, 750, 60);
}

}  // namespace
}  // namespace gable
