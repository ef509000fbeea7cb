#include <gable/engine/dataset/shard.h>
#include <gable/engine/dataset/synthetic_samples.h>
#include <gable/engine/dataset/training_sample.h>
#include <gable/grammar/height_field.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

namespace gable {
namespace {

/// A clean image of a house alone on flat ground; everything that stands is inside.
HeightImage clean_image(const House& house, double gsd = 0.25) {
  HeightImage image;
  image.gsd = gsd;
  image.rows = image.cols = static_cast<int>(44.0 / gsd);
  image.origin = house.origin;
  image.first_center = {-22.0 + 0.5 * gsd, 22.0 - 0.5 * gsd};
  const HeightField field(house);
  for (int row = 0; row < image.rows; ++row) {
    for (int col = 0; col < image.cols; ++col) {
      const Eigen::Vector2d p = image.center_of(row, col);
      const double height = field.at_local(p, 0.0, 0.0);
      image.height.push_back(static_cast<float>(height));
      image.ground.push_back(0.0f);
      image.weight.push_back(1.0f);
      image.inside.push_back(height > 0.5);
    }
  }
  return image;
}

House bare_house(Foundation foundation, uint64_t seed) {
  Random random(seed);
  PriorOptions prior;
  prior.dormer_share = prior.chimney_share = prior.garage_share = 0.0;
  return random_house(foundation, &random, prior);
}

/// Whether a crop pixel's mask is set; points beyond are open.
bool masked(const HouseCrop& crop, double x, double y) {
  const int col = static_cast<int>(std::floor(x)), row = static_cast<int>(std::floor(y));
  if (col < 0 || row < 0 || col >= kCropSize || row >= kCropSize) return false;
  return crop.mask[static_cast<size_t>(row) * kCropSize + col] != 0;
}

TEST(TrainingSample, CornersOfPolygonsLieWhereTheMaskTurns) {
  for (uint64_t seed = 1; seed <= 20; ++seed) {
    for (const Foundation foundation : {Foundation::kI, Foundation::kL, Foundation::kU}) {
      const House house = bare_house(foundation, seed);
      const TrainingSample sample =
          label_building(clean_image(house), foundation, &house, house.azimuth[0]);
      const size_t expected = foundation == Foundation::kI   ? 4
                              : foundation == Foundation::kL ? 6
                                                             : 8;
      ASSERT_EQ(sample.corners.size(), expected);
      for (const CropCorner& corner : sample.corners) {
        // Of the four quadrants around a convex corner one is covered, of a concave one three.
        int covered = 0;
        for (double dx : {-1.5, 1.5}) {
          for (double dy : {-1.5, 1.5}) {
            covered += masked(sample.crop, corner.crop.x() + dx, corner.crop.y() + dy);
          }
        }
        const bool concave = foundation != Foundation::kI && corner.type == crop_map::kConcave;
        EXPECT_EQ(covered, concave ? 3 : 1) << "seed " << seed << " type " << corner.type;
      }
    }
  }
}

TEST(TrainingSample, RectangleCornersAreNamedByTheirPlaceInTheCrop) {
  for (int quarter = 0; quarter < 4; ++quarter) {
    const House house = bare_house(Foundation::kII, 3);
    const double azimuth = house.azimuth[0] + quarter * 0.5 * M_PI + 0.05;
    const TrainingSample sample =
        label_building(clean_image(house), Foundation::kII, &house, azimuth);
    ASSERT_EQ(sample.components.size(), 2u);
    for (const auto& c : sample.components) {
      using namespace crop_map;
      EXPECT_LT(c[kTopLeft].x(), c[kTopRight].x());
      EXPECT_LT(c[kBottomLeft].x(), c[kBottomRight].x());
      EXPECT_LT(c[kTopLeft].y(), c[kBottomLeft].y());
      EXPECT_LT(c[kTopRight].y(), c[kBottomRight].y());
    }
  }
}

TEST(TrainingSample, GaragePixelsAreThoseThatTheGarageCovers) {
  House house = make_house(Foundation::kI);
  Rule garage = make_rule(RuleKind::kGarageI);
  const double edge = house.footprints[0][0] + 0.5 * house.footprints[0][2];
  garage[0] = edge + 1.5;
  garage[1] = 0.0;
  garage[2] = 3.0;
  garage[3] = 4.0;
  garage[4] = 2.4;
  house.garages.push_back(garage);
  const TrainingSample sample = label_building(clean_image(house), Foundation::kI, &house, 0.0);
  double area = 0.0;
  for (const uint8_t pixel : sample.garages) area += pixel * sample.crop.pixel * sample.crop.pixel;
  EXPECT_NEAR(area, 12.0, 1.5);
}

TEST(TrainingSample, RoofTypesAreThoseOfTheWingsEnds) {
  House house = make_house(Foundation::kL);
  EXPECT_EQ(roof_types(house), std::vector<RoofType>{RoofType::kGable});
  house.roofs[0] = make_rule(RuleKind::kRoofHip);
  house.roofs[0][param::roof::kHipStart] = 0.3;  // at the corner, not at an end
  house.roofs[0][param::roof::kHipEnd] = 0.0;
  EXPECT_EQ(roof_types(house), std::vector<RoofType>{RoofType::kGable});
  house.roofs[0][param::roof::kHipEnd] = 0.3;
  EXPECT_EQ(roof_types(house), std::vector<RoofType>{RoofType::kHip});
}

TEST(SyntheticSamples, DependOnSeedAndIndexAlone) {
  DatasetOptions options;
  options.seed = 4;
  const TrainingSample once = synthetic_sample(10, options);
  synthetic_sample(3, options);
  const TrainingSample again = synthetic_sample(10, options);
  EXPECT_EQ(once.crop.channels, again.crop.channels);
  EXPECT_EQ(once.garages, again.garages);
  options.seed = 5;
  EXPECT_NE(synthetic_sample(10, options).crop.channels, once.crop.channels);
}

TEST(SyntheticSamples, ShowEveryFoundationInTurnWithItsTargets) {
  const DatasetOptions options;
  for (size_t i = 0; i < 60; ++i) {
    const TrainingSample sample = synthetic_sample(i, options);
    EXPECT_EQ(static_cast<size_t>(sample.foundation), i % 6);
    const bool c = sample.foundation == Foundation::kC;
    EXPECT_EQ(std::isnan(sample.azimuth), c);
    EXPECT_EQ(sample.corners.empty(), c);
    EXPECT_EQ(sample.roofs.empty(), c);
    int building = 0;
    for (const uint8_t pixel : sample.crop.mask) building += pixel;
    EXPECT_GT(building, 40);
  }
}

TEST(SyntheticSamples, ComponentsCoverTheMask) {
  const DatasetOptions options;
  double sum = 0.0;
  int count = 0;
  for (size_t i = 0; i < 120; ++i) {
    const TrainingSample sample = synthetic_sample(i, options);
    if (sample.foundation == Foundation::kC) continue;
    int both = 0, mask = 0;
    for (int row = 0; row < kCropSize; ++row) {
      for (int col = 0; col < kCropSize; ++col) {
        const size_t pixel = static_cast<size_t>(row) * kCropSize + col;
        if (!sample.crop.mask[pixel] || sample.garages[pixel]) continue;
        ++mask;
        bool inside = false;
        for (const auto& c : sample.components) {
          const Eigen::Vector2d right = c[1] - c[0], down = c[2] - c[0];
          const Eigen::Vector2d p = Eigen::Vector2d(col + 0.5, row + 0.5) - c[0];
          const double u = p.dot(right) / right.squaredNorm(), v = p.dot(down) / down.squaredNorm();
          inside |= u >= 0.0 && u <= 1.0 && v >= 0.0 && v <= 1.0;
        }
        both += inside;
      }
    }
    sum += static_cast<double>(both) / mask;
    ++count;
  }
  EXPECT_GT(sum / count, 0.85);
}

TEST(Shard, HoldsEveryArrayOfTheFormatForItsSamples) {
  DatasetOptions options;
  std::vector<TrainingSample> samples;
  for (size_t i = 0; i < 6; ++i) samples.push_back(synthetic_sample(i, options));
  const std::vector<ShardFile> files = shard_files(7, samples);
  EXPECT_EQ(files.size(), 12u);
  for (const ShardFile& file : files) {
    EXPECT_NE(file.name.find("_0007.npy"), std::string::npos);
    if (file.name == "crops_0007.npy") {
      const size_t values = 6 * kCropChannels * kCropPixels;
      ASSERT_GT(file.bytes.size(), values);
      const char* data = file.bytes.data() + file.bytes.size() - values;
      EXPECT_EQ(std::memcmp(data, samples[0].crop.channels.data(), kCropChannels * kCropPixels), 0);
    }
    if (file.name == "masks_0007.npy") {
      const char* data = file.bytes.data() + file.bytes.size() - 6 * kCropPixels / 8;
      for (size_t i = 0; i < kCropPixels; ++i) {
        const int bit = static_cast<unsigned char>(data[i / 8]) >> (7 - i % 8) & 1;
        EXPECT_EQ(bit, samples[0].crop.mask[i]);
      }
    }
  }
}

TEST(DatasetOptions, ChecksNameTheBound) {
  DatasetOptions options;
  EXPECT_EQ(options.check(), "");
  options.count = 0;
  EXPECT_NE(options.check().find("count"), std::string::npos);
  options.count = 1;
  options.dormer_share = 1.5;
  EXPECT_NE(options.check().find("dormer_share"), std::string::npos);
}

}  // namespace
}  // namespace gable
