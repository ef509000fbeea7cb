#include <gable/engine/evaluate/evaluation.h>
#include <gable/engine/evaluate/evaluation_report.h>
#include <gable/engine/evaluate/model_surface.h>
#include <gable/engine/evaluate/triangles.h>
#include <gable/grammar/rasterise.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace gable {
namespace {

constexpr double kEast = 400000.0, kNorth = 200000.0, kGround = 100.0;

Grid test_grid(int size = 80) {
  Grid grid;
  grid.north_west = {kEast, kNorth};
  grid.gsd = 0.5;
  grid.rows = grid.cols = size;
  return grid;
}

/// A gabled house of 12 x 8 m, eaves 3 m, ridge 6 m: 4.5 m high on average.
Building gabled(const std::string& id, double x, double y) {
  House house = make_house(Foundation::kI);
  house.origin = {kEast + x, kNorth - y, kGround};
  house.footprints[0].values = {0.0, 0.0, 12.0, 8.0};
  house.roofs[0].values = {3.0, 3.0};
  Building building;
  building.id = id;
  building.house = house;
  return building;
}

struct Case {
  std::vector<Building> buildings, truth;
  HeightRaster dsm = HeightRaster(test_grid(), kGround);
  HeightRaster dtm = HeightRaster(test_grid(), kGround);

  /// The truth as the survey sees it, without noise.
  void survey() {
    const ModelSurface surface = rasterise_buildings(truth, dsm.grid);
    for (size_t i = 0; i < dsm.values.size(); ++i) {
      if (surface.owner.values[i] >= 0) dsm.values[i] = surface.height.values[i];
    }
  }
  Evaluation run() const { return evaluate({&buildings, &dsm, &dtm, &truth, {}}); }
};

TEST(Evaluation, ThePerfectModelHasNoError) {
  Case c;
  c.truth = c.buildings = {gabled("a", 10, 10), gabled("b", 28, 30)};
  c.survey();
  const Evaluation result = c.run();
  EXPECT_EQ(result.over_model.pixels(), 2u * 24 * 16);
  EXPECT_NEAR(result.over_model.mad(), 0.0, 1e-5);
  EXPECT_EQ(result.summary->foundation_accuracy, 1.0);
  EXPECT_EQ(result.summary->mean_iou, 1.0);
  EXPECT_EQ(result.summary->share_good, 1.0);
  EXPECT_EQ(result.summary->invented, 0);
}

TEST(Evaluation, WhatAModelMissesOfAFootprintCountsAsTerrain) {
  Case c;
  c.truth = {gabled("a", 10, 10)};
  c.survey();
  c.buildings = {gabled("a", 16, 10)};  // half of it beside the footprint
  Raster<unsigned char> footprints(c.dsm.grid, 0);
  for_covered_cells(*c.truth[0].house, c.dsm.grid,
                    [&](int row, int col, double) { footprints.at(row, col) = 1; });
  const Evaluation result = evaluate({&c.buildings, &c.dsm, &c.dtm, nullptr, {}, &footprints});
  EXPECT_EQ(result.over_footprints->pixels(), 24u * 16);
  EXPECT_NEAR(result.over_footprints->mad(), 0.5 * 4.5, 1e-5);
  EXPECT_EQ(result.footprint_union->pixels(), 36u * 16);
  EXPECT_NEAR(result.footprint_union->mad(), 2.0 / 3.0 * 4.5, 1e-5);
}

TEST(Evaluation, ALiftedModelIsOffByTheLift) {
  Case c;
  c.truth = c.buildings = {gabled("a", 10, 10)};
  c.buildings[0].house->origin.z() += 0.25;
  c.survey();
  const Evaluation result = c.run();
  EXPECT_NEAR(result.over_model.mad(), 0.25, 1e-5);
  EXPECT_NEAR(result.over_model.rmse(), 0.25, 1e-5);
  EXPECT_NEAR(result.summary->union_error.mad(), 0.25, 1e-5);
  EXPECT_NEAR(result.summary->median_mad, 0.25, 1e-5);
  EXPECT_NEAR(result.buildings[0].over_model.mad(), 0.25, 1e-5);
}

TEST(Evaluation, AMissedHouseCountsItsHeight) {
  Case c;
  c.truth = {gabled("a", 10, 10)};
  c.survey();
  const Evaluation result = c.run();
  EXPECT_EQ(result.over_model.pixels(), 0u);
  EXPECT_NEAR(result.summary->union_error.mad(), 4.5, 1e-5);
  EXPECT_NEAR(result.summary->median_mad, 4.5, 1e-5);
  EXPECT_EQ(result.summary->share_good, 0.0);
  EXPECT_EQ(result.summary->mean_iou, 0.0);
  EXPECT_EQ(result.summary->foundation_accuracy, 0.0);
  EXPECT_EQ(result.summary->confusion[0][TruthSummary::kMissed], 1);
}

TEST(Evaluation, AnInventedHouseCountsItsHeightInTheUnionOnly) {
  Case c;
  c.truth = {gabled("a", 10, 10)};
  c.buildings = {gabled("far", 28, 30), gabled("a", 10, 10)};
  c.survey();
  const Evaluation result = c.run();
  EXPECT_NEAR(result.summary->union_error.mad(), 2.25, 1e-5);
  EXPECT_NEAR(result.summary->median_mad, 0.0, 1e-5);
  EXPECT_EQ(result.summary->invented, 1);
  EXPECT_EQ(result.buildings[0].truth, -1);
  EXPECT_EQ(result.buildings[1].truth, 0);
}

TEST(Evaluation, AShiftedFlatHouseHasTheIouOfShiftedRectangles) {
  Case c;
  c.truth = c.buildings = {gabled("a", 15, 15)};
  for (auto* list : {&c.truth, &c.buildings}) {
    (*list)[0].house->roofs[0] = make_rule(RuleKind::kRoofFlat);
    (*list)[0].house->roofs[0][param::roof::kEaves] = 4.0;
  }
  c.buildings[0].house->origin.x() += 3.0;
  c.survey();
  const Evaluation result = c.run();
  // 12 m long, moved by 3 m: 9 / 15 shared, and 3 m of each side off by 4 m.
  EXPECT_NEAR(result.summary->mean_iou, 9.0 / 15.0, 1e-12);
  EXPECT_NEAR(result.summary->median_mad, 4.0 * 6.0 / 15.0, 1e-5);
}

TEST(Evaluation, HousesOfManyBlocksHaveAColumnOfTheirOwn) {
  Case c;
  c.truth = c.buildings = {gabled("a", 15, 15)};
  House& house = *c.buildings[0].house;
  house.foundation = Foundation::kMany;
  house.footprints.assign(4, house.footprints[0]);
  house.roofs.assign(4, house.roofs[0]);
  c.survey();
  const Evaluation result = c.run();
  EXPECT_EQ(result.summary->confusion[0][static_cast<int>(Foundation::kMany)], 1);
  EXPECT_EQ(result.summary->confusion[0][TruthSummary::kMissed], 0);
  EXPECT_EQ(result.summary->matched, 1);
}

TEST(Evaluation, ExtrusionsCountAsTypeC) {
  Case c;
  c.truth = {gabled("a", 10, 10)};
  Building extrusion;
  extrusion.status = BuildingStatus::kExtrusion;
  extrusion.origin = {kEast + 10, kNorth - 10, kGround};
  extrusion.outline.outer = {{-6, -4}, {6, -4}, {6, 4}, {-6, 4}};
  extrusion.height = 4.5;
  c.buildings = {extrusion};
  c.survey();
  const Evaluation result = c.run();
  EXPECT_EQ(result.summary->mean_iou, 1.0);
  EXPECT_EQ(result.summary->confusion[0][static_cast<int>(Foundation::kC)], 1);
  EXPECT_EQ(result.summary->foundation_accuracy, 0.0);
  // |z - 4.5| with z uniform in [3, 6] has mean 0.75.
  EXPECT_NEAR(result.over_model.mad(), 0.75, 1e-5);
}

TEST(ModelSurface, ClosedPlanesHaveTheHeightsOfTheirRegions) {
  Building planes;
  planes.status = BuildingStatus::kPlanes;
  planes.origin = {kEast + 20.0, kNorth - 20.0, kGround};
  planes.outline.outer = {{-8, -8}, {8, -8}, {8, 8}, {-8, 8}};
  planes.height = 3.0;
  planes.roof = RoofPartition{{{0.25, 0, 4}, {0, 0, 9}},
                              {{0, {{{-8, -8}, {0, -8}, {0, 8}, {-8, 8}}, {}}},
                               {1, {{{0, -8}, {8, -8}, {8, 8}, {0, 8}}, {}}}}};
  const ModelSurface surface = rasterise_buildings({planes}, test_grid());
  int covered = 0;
  for (int row = 0; row < 80; ++row) {
    for (int col = 0; col < 80; ++col) {
      if (surface.owner.at(row, col) < 0) continue;
      ++covered;
      const double x = 0.5 * (col + 0.5) - 20.0;
      EXPECT_NEAR(surface.height.at(row, col), kGround + (x < 0.0 ? 4.0 + 0.25 * x : 9.0), 1e-5);
    }
  }
  EXPECT_EQ(covered, 32 * 32);
}

TEST(Evaluation, CellsWithoutMeasurementDoNotCount) {
  Case c;
  c.truth = c.buildings = {gabled("a", 10, 10)};
  c.buildings[0].house->origin.z() += 1.0;
  c.survey();
  for (int row = 0; row < 20; ++row) {
    for (int col = 0; col < 80; ++col) c.dsm.at(row, col) = std::nanf("");
  }
  const Evaluation result = c.run();
  EXPECT_EQ(result.over_model.pixels(), 24u * 8);
  EXPECT_NEAR(result.over_model.mad(), 1.0, 1e-5);
}

TEST(Evaluation, ReportNamesTheFigures) {
  Case c;
  c.truth = c.buildings = {gabled("a", 10, 10)};
  c.survey();
  const Evaluation result = evaluate({&c.buildings, &c.dsm, &c.dtm, &c.truth, {16}});
  const std::string report = evaluation_report(result, true);
  EXPECT_THAT(report, testing::HasSubstr("footprint IoU, mean               1.000"));
  EXPECT_THAT(report, testing::HasSubstr("foundation type                   100.0 % right"));
  EXPECT_THAT(report, testing::HasSubstr("triangles, mean                   16.0"));
}

TEST(ModelSurface, ExtrusionsCoverTheirOutlineWithoutItsHoles) {
  Building extrusion;
  extrusion.status = BuildingStatus::kExtrusion;
  extrusion.origin = {kEast + 20.0, kNorth - 20.0, kGround};
  extrusion.outline.outer = {{-8, -8}, {8, -8}, {0, 8}};
  extrusion.outline.holes = {{{-2, -4}, {-2, -2}, {2, -2}, {2, -4}}};
  extrusion.height = 3.0;
  const ModelSurface surface = rasterise_buildings({extrusion}, test_grid());
  for (int row = 0; row < 80; ++row) {
    for (int col = 0; col < 80; ++col) {
      const double x = 0.5 * (col + 0.5) - 20.0, y = 20.0 - 0.5 * (row + 0.5);
      const bool in_triangle = y > -8.0 && std::abs(x) < (8.0 - y) / 2.0;
      const bool in_hole = std::abs(x) < 2.0 && y > -4.0 && y < -2.0;
      if (std::abs(std::abs(x) - (8.0 - y) / 2.0) < 1e-9) continue;  // on the edge
      EXPECT_EQ(surface.owner.at(row, col), in_triangle && !in_hole ? 0 : -1) << x << " " << y;
    }
  }
}

TEST(ModelSurface, TheHighestBuildingIsSeen) {
  std::vector<Building> buildings = {gabled("low", 20, 20), gabled("high", 20, 20)};
  buildings[1].house->footprints[0].values = {0.0, 0.0, 4.0, 8.0};
  buildings[1].house->roofs[0].values = {5.0, 3.0};
  const ModelSurface surface = rasterise_buildings(buildings, test_grid());
  EXPECT_EQ(surface.owner.at(39, 39), 1);
  EXPECT_EQ(surface.owner.at(39, 39 + 8), 0);
}

TEST(ModelSurface, HousesOutsideTheGridAreCutOff) {
  const ModelSurface surface =
      rasterise_buildings({gabled("far", -4000, 9000), gabled("edge", 0, 20)}, test_grid());
  int covered = 0;
  for (int owner : surface.owner.values) covered += owner >= 0;
  EXPECT_EQ(covered, 12 * 16);
}

TEST(BuildingMatching, OneToOneBestFirst) {
  Grid grid = test_grid(4);
  Raster<int> truth(grid, -1), model(grid, -1);
  // Truth 0: row 0; truth 1: row 1. Building 0 covers three cells of row 0 and one of row 1,
  // building 1 the last of row 0.
  for (int col = 0; col < 4; ++col) {
    truth.at(0, col) = 0;
    truth.at(1, col) = 1;
    model.at(0, col) = col < 3 ? 0 : 1;
  }
  model.at(1, 0) = 0;
  const auto matches = match_buildings(model, 2, truth, 2);
  EXPECT_EQ(matches[0].building, 0);
  EXPECT_DOUBLE_EQ(matches[0].iou, 3.0 / 5.0);
  EXPECT_EQ(matches[1].building, -1);
  EXPECT_EQ(matches[1].iou, 0.0);
}

TEST(Detections, OneToOneWithinTheRadius) {
  const std::vector<Eigen::Vector2d> truth = {{0, 0}, {10, 0}, {20, 0}};
  // Two near the first truth (one counts), one just outside the radius of the second.
  const std::vector<Eigen::Vector2d> found = {{0.5, 0}, {-1.0, 0}, {10, 1.6}, {20, -1.4}};
  const DetectionScore score = score_detections(found, truth, 1.5);
  EXPECT_EQ(score.correct, 2);
  EXPECT_DOUBLE_EQ(score.precision(), 0.5);
  EXPECT_DOUBLE_EQ(score.recall(), 2.0 / 3.0);
}

TEST(Detections, CentresAreInTheWorld) {
  Building building = gabled("a", 10, 10);
  building.house->azimuth[0] = 0.5 * M_PI;
  Rule chimney = make_rule(RuleKind::kChimney);
  chimney.values = {3.0, 1.0, 0.9, 7.0};
  building.house->chimneys.push_back(chimney);
  const auto centers = chimney_centers({building});
  ASSERT_EQ(centers.size(), 1u);
  EXPECT_NEAR(centers[0].x(), kEast + 10.0 - 1.0, 1e-9);
  EXPECT_NEAR(centers[0].y(), kNorth - 10.0 + 3.0, 1e-9);
}

TEST(Triangles, AGabledBoxHasSixteenAndACourtyardRoofEight) {
  Solid box;
  const auto face = [](std::vector<int> ring) { return Face{{std::move(ring)}, {}}; };
  box.faces = {face({0, 1, 2, 3}), face({0, 1, 2, 3}),    face({0, 1, 2, 3}),   face({0, 1, 2, 3}),
               face({0, 1, 2, 3}), face({0, 1, 2, 3, 4}), face({0, 1, 2, 3, 4})};
  EXPECT_EQ(count_triangles(box), 16);
  Solid courtyard;
  courtyard.faces = {{{{0, 1, 2, 3}, {4, 5, 6, 7}}, SurfaceType::kRoof}};
  EXPECT_EQ(count_triangles(courtyard), 8);
}

}  // namespace
}  // namespace gable
