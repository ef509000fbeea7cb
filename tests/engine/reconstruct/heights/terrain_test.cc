#include <gable/engine/error.h>
#include <gable/engine/io/raster/raster_file.h>
#include <gable/engine/reconstruct/heights/terrain.h>
#include <gable/grammar/random.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <limits>

namespace gable {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

/// A hillside with a rounded top, known in closed form.
double terrain_at(const Eigen::Vector2d& p) {
  return 50.0 + 0.12 * p.x() + 0.05 * p.y() - 4e-4 * p.squaredNorm() + 0.4 * std::sin(p.x() / 25.0);
}

/// 120 x 120 m of that hillside with houses of many sizes, trees, noise and nodata.
HeightRaster village(double gsd, uint64_t seed) {
  const int n = static_cast<int>(120.0 / gsd);
  HeightRaster dsm({{-60.0, 60.0}, gsd, n, n}, 0.0f);
  Random random(seed);
  for (int r = 0; r < n; ++r) {
    for (int c = 0; c < n; ++c) {
      dsm.at(r, c) = static_cast<float>(terrain_at(dsm.grid.center_of(r, c)) + random.normal(0.03));
    }
  }
  const auto raise = [&](const Eigen::Vector2d& middle, double half_x, double half_y, double height,
                         double rough) {
    for (int r = 0; r < n; ++r) {
      for (int c = 0; c < n; ++c) {
        const Eigen::Vector2d d = dsm.grid.center_of(r, c) - middle;
        if (std::abs(d.x()) > half_x || std::abs(d.y()) > half_y) continue;
        const double top = terrain_at(middle) + height + random.uniform(-rough, rough);
        dsm.at(r, c) = std::max(dsm.at(r, c), static_cast<float>(top));
      }
    }
  };
  for (int i = 0; i < 5; ++i) {
    for (int j = 0; j < 4; ++j) {
      raise({-48.0 + 24.0 * i, -45.0 + 30.0 * j}, random.uniform(3, 7), random.uniform(4, 9),
            random.uniform(4, 10), 0.0);
      raise({-36.0 + 24.0 * i, -38.0 + 30.0 * j}, 3.0, 3.0, 6.0, 4.0);
    }
  }
  raise({0.0, -30.0}, 20.0, 12.0, 9.0, 0.0);
  for (float& z : dsm.values) {
    if (random.chance(0.05)) z = kNan;
  }
  for (int r = n / 3; r < n / 3 + 10; ++r) {
    for (int c = n / 2; c < n / 2 + 14; ++c) dsm.at(r, c) = kNan;
  }
  dsm.at(n / 5, n / 5) = 20.0f;  // a false echo below the ground
  return dsm;
}

struct TerrainError {
  double rmse = 0.0;
  double largest = 0.0;
};

TerrainError error_against_truth(const HeightRaster& derived) {
  TerrainError error;
  for (int r = 0; r < derived.grid.rows; ++r) {
    for (int c = 0; c < derived.grid.cols; ++c) {
      const double e = derived.at(r, c) - terrain_at(derived.grid.center_of(r, c));
      error.rmse += e * e;
      error.largest = std::max(error.largest, std::abs(e));
    }
  }
  error.rmse = std::sqrt(error.rmse / static_cast<double>(derived.grid.size()));
  return error;
}

class TerrainAtResolution : public testing::TestWithParam<double> {};

TEST_P(TerrainAtResolution, HousesAndTreesAreTakenOffAHillside) {
  const HeightRaster dsm = village(GetParam(), 5);
  const HeightRaster derived = derive_terrain(dsm);
  HeightRaster clean = derived;
  const int pit = dsm.grid.rows / 5;
  clean.at(pit, pit) = static_cast<float>(terrain_at(dsm.grid.center_of(pit, pit)));
  const TerrainError error = error_against_truth(clean);
  RecordProperty("rmse", std::to_string(error.rmse));
  EXPECT_LT(error.rmse, 0.05);
  EXPECT_LT(error.largest, 0.8);
}

TEST_P(TerrainAtResolution, IsFilledEverywhereAndNeverAboveTheSurface) {
  const HeightRaster dsm = village(GetParam(), 6);
  const HeightRaster derived = derive_terrain(dsm);
  for (size_t i = 0; i < dsm.values.size(); ++i) {
    EXPECT_TRUE(std::isfinite(derived.values[i]));
    if (!std::isnan(dsm.values[i])) {
      EXPECT_LE(derived.values[i], dsm.values[i]);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Gsd, TerrainAtResolution, testing::Values(0.25, 0.5, 1.0));

TEST(Terrain, SteepBareSlopeIsLeftAloneUpToTheBorder) {
  HeightRaster dsm({{0, 0}, 0.5, 150, 150}, 0.0f);
  for (int r = 0; r < 150; ++r) {
    for (int c = 0; c < 150; ++c) {
      const Eigen::Vector2d p = dsm.grid.center_of(r, c);
      dsm.at(r, c) = static_cast<float>(0.5 * p.x() - 0.3 * p.y());
    }
  }
  const HeightRaster derived = derive_terrain(dsm);
  for (size_t i = 0; i < dsm.values.size(); ++i) {
    EXPECT_NEAR(derived.values[i], dsm.values[i], 0.02);
  }
}

TEST(Terrain, NothingStaysNothing) {
  const HeightRaster derived = derive_terrain(HeightRaster({{0, 0}, 0.5, 20, 30}, kNan));
  EXPECT_TRUE(std::all_of(derived.values.begin(), derived.values.end(),
                          [](float z) { return std::isnan(z); }));
}

TEST(Terrain, OptionsOutsideTheirBoundsAreNamed) {
  TerrainOptions options;
  options.slope = -1.0;
  try {
    derive_terrain(HeightRaster({{0, 0}, 0.5, 20, 30}, 0.0f), options);
    ADD_FAILURE() << "accepted";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ExitCode::kUsage);
    EXPECT_THAT(error.what(), testing::HasSubstr("slope"));
  }
}

TEST(Terrain, AgreesWithTheSurveyedTerrainOfADutchTown) {
  const char* data = std::getenv("GABLE_DATA");
  const std::string folder =
      std::string(data ? data : GABLE_SOURCE_DIR "/../shared/data") + "/delft-ahn3/";
  if (!std::filesystem::exists(folder + "delft_ahn3_dsm.tif")) {
    GTEST_SKIP() << "no real data at " << folder << "; set GABLE_DATA";
  }
  const HeightRaster dsm = RasterFile(folder + "delft_ahn3_dsm.tif").read();
  const HeightRaster dtm = RasterFile(folder + "delft_ahn3_dtm.tif").read();
  const HeightRaster derived = derive_terrain(dsm);
  std::vector<float> errors;
  for (size_t i = 0; i < dtm.values.size(); ++i) {
    if (!std::isnan(dtm.values[i])) errors.push_back(std::abs(derived.values[i] - dtm.values[i]));
  }
  std::sort(errors.begin(), errors.end());
  RecordProperty("median", std::to_string(errors[errors.size() / 2]));
  RecordProperty("p95", std::to_string(errors[errors.size() * 95 / 100]));
  EXPECT_LT(errors[errors.size() / 2], 0.06f);
  EXPECT_LT(errors[errors.size() * 95 / 100], 0.40f);
}

}  // namespace
}  // namespace gable
