#include <gable/engine/detectors/house_from_crop.h>
#include <gable/engine/detectors/polygon_candidates.h>
#include <gable/engine/detectors/rectangle_candidates.h>
#include <gtest/gtest.h>

#include <cmath>

#include "engine/detectors/drawn_maps.h"

namespace gable {
namespace {

constexpr Foundation kTypes[] = {Foundation::kI, Foundation::kII, Foundation::kIII, Foundation::kL,
                                 Foundation::kU};

RoofType type_of(const Rule& roof) {
  return roof.kind == RuleKind::kRoofFlat    ? RoofType::kFlat
         : roof.kind == RuleKind::kRoofGable ? RoofType::kGable
                                             : RoofType::kHip;
}

// The true foundation and roofs of a drawn house as ideal detectors say them.
struct Said {
  CropFoundation foundation;
  CropDetails details;

  explicit Said(const DrawnHouse& drawn) {
    const CornerPeaks peaks = drawn_peaks(drawn, drawn.corners);
    if (drawn.house.foundation == Foundation::kL) {
      foundation = l_candidates(peaks, mask_bits(drawn.crop))[0];
    } else if (drawn.house.foundation == Foundation::kU) {
      foundation = u_candidates(peaks, mask_bits(drawn.crop))[0];
    } else {
      foundation.foundation = drawn.house.foundation;
      foundation.rectangles = drawn.rectangles();
    }
    const bool one = drawn.house.footprints.size() == 1;
    for (const Rule& roof : drawn.house.roofs) {
      details.roofs.push_back(type_of(roof));
      if (one) break;
    }
  }

  House house(const DrawnHouse& drawn) const {
    return house_from_crop(drawn.crop, foundation, details, drawn.image);
  }
};

Eigen::Vector2d local_from_crop(const HouseCrop& crop, const Eigen::Vector2d& point) {
  const Eigen::Vector2d p = crop.house_from_crop(point);
  const double c = std::cos(crop.azimuth), s = std::sin(crop.azimuth);
  return {c * p.x() - s * p.y(), s * p.x() + c * p.y()};
}

void expect_within_bounds(const House& house) {
  EXPECT_TRUE(is_well_formed(house));
  for (const Rule* rule : house.derivation()) {
    const auto specs = parameter_specs(rule->kind);
    for (int i = 0; i < rule->size(); ++i) {
      EXPECT_GE((*rule)[i], specs[i].lower) << rule_name(rule->kind) << " " << specs[i].name;
      EXPECT_LE((*rule)[i], specs[i].upper) << rule_name(rule->kind) << " " << specs[i].name;
    }
  }
}

TEST(HouseFromCrop, CoversWhatTheTruthCoversAtAboutItsHeights) {
  for (const Foundation type : kTypes) {
    double mean_error = 0.0;
    for (uint64_t seed = 0; seed < 25; ++seed) {
      const DrawnHouse drawn(type, seed, DrawnHouse::bare());
      const House house = Said(drawn).house(drawn);
      expect_within_bounds(house);
      EXPECT_EQ(house.foundation, type);
      EXPECT_EQ(house.origin, drawn.image.origin);
      // Both frames have the image's origin.
      const HeightField truth(drawn.house), found(house);
      Random random(seed);
      int both = 0, either = 0;
      double error = 0.0;
      for (int i = 0; i < 4000; ++i) {
        const Eigen::Vector2d local(random.uniform(-16.0, 16.0), random.uniform(-16.0, 16.0));
        const double a = truth.at_local(local, 0.0, 0.0), b = found.at_local(local, 0.0, 0.0);
        either += a > 0.0 || b > 0.0;
        if (a > 0.0 && b > 0.0) {
          ++both;
          error += std::abs(a - b);
        }
      }
      EXPECT_GE(both, 0.97 * either) << foundation_name(type) << " " << seed;
      EXPECT_LT(error / both, 1.0) << foundation_name(type) << " " << seed;
      mean_error += error / both / 25;
    }
    EXPECT_LT(mean_error, 0.45) << foundation_name(type);
  }
}

TEST(HouseFromCrop, ARidgeRunsAcrossTheSlopesEvenAlongTheShorterSide) {
  for (const double azimuth : {0.0, 0.5, 2.0}) {
    for (const Axis ridge : {Axis::kX, Axis::kY}) {
      const HeightImage image = image_of(box_house(9.0, 8.0, gable_roof(4.0, 2.5, ridge), azimuth));
      const HouseCrop crop = make_house_crop(image, azimuth);
      EXPECT_EQ(ridge_axis(crop, bounds_of(mask_bits(crop))), ridge);
    }
    const HeightImage flat = image_of(box_house(7.0, 10.0, flat_roof(4.0), azimuth));
    const HouseCrop crop = make_house_crop(flat, azimuth);
    EXPECT_EQ(ridge_axis(crop, bounds_of(mask_bits(crop))), Axis::kY);
  }
}

TEST(HouseFromCrop, RoofsStartAtTheHeightsOfThePaper) {
  const HeightImage image = image_of(box_house(12.0, 8.0, gable_roof(4.0, 2.4, Axis::kX), 0.4));
  const HouseCrop crop = make_house_crop(image, 0.4);
  CropFoundation foundation;
  foundation.rectangles = {bounds_of(mask_bits(crop))};
  const auto roof_of = [&](RoofType type) {
    CropDetails details;
    details.roofs = {type};
    return house_from_crop(crop, foundation, details, image).roofs[0];
  };
  namespace r = param::roof;
  const Rule gable = roof_of(RoofType::kGable);
  EXPECT_EQ(gable.kind, RuleKind::kRoofGable);
  EXPECT_EQ(gable.ridge, Axis::kX);
  EXPECT_NEAR(gable[r::kEaves], 4.12, 0.2);
  EXPECT_NEAR(gable[r::kEaves] + gable[r::kRise], 6.34, 0.2);
  const Rule hip = roof_of(RoofType::kHip);
  EXPECT_EQ(hip.kind, RuleKind::kRoofHip);
  EXPECT_EQ(hip[r::kHipStart], 0.1);
  EXPECT_EQ(hip[r::kHipEnd], 0.1);
  const Rule flat = roof_of(RoofType::kFlat);
  EXPECT_EQ(flat.kind, RuleKind::kRoofFlat);
  EXPECT_NEAR(flat[r::kEaves], 5.2, 0.2);
}

TEST(HouseFromCrop, DormersAndChimneysStandWhereTheyWereSeen) {
  for (const Foundation type : kTypes) {
    for (uint64_t seed = 0; seed < 10; ++seed) {
      const DrawnHouse drawn(type, seed, DrawnHouse::bare());
      Said said(drawn);
      for (const CropRectangle& r : said.foundation.rectangles) {
        Peak peak;
        peak.crop = {0.4 * r.x0 + 0.6 * r.x1, 0.3 * r.y0 + 0.7 * r.y1};
        said.details.dormers.push_back(peak);
        said.details.chimneys.push_back(peak);
      }
      Peak away;
      away.crop = {1.0, 1.0};
      said.details.dormers.push_back(away);
      said.details.chimneys.push_back(away);
      const House house = said.house(drawn);
      expect_within_bounds(house);
      const size_t count = said.foundation.rectangles.size();
      ASSERT_EQ(house.dormers.size(), count);
      ASSERT_EQ(house.chimneys.size(), count);
      const HeightField field(house);
      House components = house;
      components.dormers.clear();
      components.chimneys.clear();
      const HeightField roofs(components);
      for (size_t i = 0; i < count; ++i) {
        const Eigen::Vector2d expected = local_from_crop(drawn.crop, said.details.dormers[i].crop);
        const Rule& dormer = house.dormers[i];
        const Rule& chimney = house.chimneys[i];
        const Eigen::Vector2d dormer_at = field.local_from_house({dormer[0], dormer[1]});
        const Eigen::Vector2d chimney_at = field.local_from_house({chimney[0], chimney[1]});
        EXPECT_LT((dormer_at - expected).norm(), 1e-9);
        EXPECT_LT((chimney_at - expected).norm(), 1e-9);
        const double roof = roofs.at_local(expected, 0.0, 0.0);
        EXPECT_NEAR(chimney[param::chimney::kHeight], roof + 2.5, 1e-9);
        EXPECT_EQ(chimney[param::chimney::kSide], 0.7);
        // The seen block is the one whose roof carries the dormer.
        const int block = roofs.block_at_house(roofs.house_from_local(expected));
        EXPECT_EQ(roofs.sources()[block].index, dormer.component);
        EXPECT_EQ(dormer[param::dormer::kWidth], 2.0);
        EXPECT_NEAR(dormer[param::dormer::kRise], std::tan(M_PI / 6.0), 1e-3);
        const double ridge = dormer[param::dormer::kEaves] + dormer[param::dormer::kRise];
        EXPECT_GT(ridge, roof);
        EXPECT_LT(ridge, roof + 2.5);
      }
    }
  }
}

TEST(HouseFromCrop, GaragesCoverTheirPixelsWhicheverWayTheyTurn) {
  for (const Foundation type : {Foundation::kI, Foundation::kL, Foundation::kU}) {
    for (uint64_t seed = 0; seed < 4; ++seed) {
      const DrawnHouse drawn(type, seed, DrawnHouse::bare());
      for (int variant = 0; variant < 5; ++variant) {
        Said said(drawn);
        CropGarage garage;
        const double x0 = 1.0, x1 = 17.0, y0 = 1.0, y1 = 16.0;  // at a corner of the crop
        if (variant == 4) {
          garage.rectangles = {{x0, x1, y0, y1}};
        } else {
          const bool right = variant % 2 == 1, top = variant / 2 == 1;
          garage.side = {right ? 1.0 : -1.0, top ? 1.0 : -1.0};
          garage.rectangles = {{x0, x1, top ? y0 : 8.0, top ? 8.0 : y1},
                               {right ? 9.0 : x0, right ? x1 : 9.0, y0, y1}};
        }
        said.details.garages = {garage};
        const House house = said.house(drawn);
        expect_within_bounds(house);
        const HeightField field(house);
        int wrong = 0;
        Random random(seed);
        for (int i = 0; i < 2000; ++i) {
          const Eigen::Vector2d point(random.uniform(0.0, 18.0), random.uniform(0.0, 17.0));
          if (drawn.covers(point)) continue;
          const auto inside = [&](const CropRectangle& r) {
            return point.x() > r.x0 && point.x() < r.x1 && point.y() > r.y0 && point.y() < r.y1;
          };
          const bool expected =
              std::any_of(garage.rectangles.begin(), garage.rectangles.end(), inside);
          const int block =
              field.block_at_house(field.house_from_local(local_from_crop(drawn.crop, point)));
          const bool found = block >= 0 && field.sources()[block].role == BlockRole::kGarage;
          // Where the found house covers a little more than the true one, its roof is seen.
          wrong += expected ? block < 0 : found;
        }
        EXPECT_EQ(wrong, 0) << foundation_name(type) << " " << seed << " " << variant;
        EXPECT_LE(house.garages.size(), variant == 4 ? 1u : 2u);
      }
    }
  }
}

TEST(HouseFromCrop, AGarageIsAsHighAsItsMedian) {
  PriorOptions prior = DrawnHouse::bare();
  prior.garage_share = 1.0;
  int garages = 0;
  for (uint64_t seed = 0; seed < 20; ++seed) {
    const DrawnHouse drawn(Foundation::kI, seed, prior);
    if (drawn.house.garages.empty()) continue;
    const Rule& truth = drawn.house.garages[0];
    if (truth.kind != RuleKind::kGarageI) continue;
    Said said(drawn);
    const Eigen::Vector2d p =
        crop_from_own_frame(drawn.house, {truth[0] - 0.5 * truth[2], truth[1] - 0.5 * truth[3]},
                            drawn.crop, drawn.image.origin);
    const Eigen::Vector2d q =
        crop_from_own_frame(drawn.house, {truth[0] + 0.5 * truth[2], truth[1] + 0.5 * truth[3]},
                            drawn.crop, drawn.image.origin);
    said.details.garages.push_back({{{std::min(p.x(), q.x()), std::max(p.x(), q.x()),
                                      std::min(p.y(), q.y()), std::max(p.y(), q.y())}},
                                    Eigen::Vector2d::Zero(),
                                    1.0});
    const House house = said.house(drawn);
    ASSERT_EQ(house.garages.size(), 1u);
    EXPECT_NEAR(house.garages[0][param::garage::kHeightI], truth[param::garage::kHeightI], 1e-4);
    EXPECT_NEAR(std::abs(house.garages[0][2] * house.garages[0][3]), truth[2] * truth[3], 1e-6);
    ++garages;
  }
  EXPECT_GT(garages, 5);
}

TEST(HouseFromCrop, AnImageWithoutMeasurementsGivesTheTablesHeights) {
  DrawnHouse drawn(Foundation::kL, 2, DrawnHouse::bare());
  const Said said(drawn);
  drawn.image.weight.assign(drawn.image.size(), 0.0f);
  const House house = said.house(drawn);
  expect_within_bounds(house);
  EXPECT_EQ(house.roofs[0][param::roof::kEaves], 5.0);
}

}  // namespace
}  // namespace gable
