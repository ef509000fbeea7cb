#include <gable/engine/io/models/add_roof_slabs.h>
#include <gable/engine/io/models/build_model.h>
#include <gable/engine/io/models/building_figures.h>
#include <gable/engine/io/models/model_writer.h>
#include <gable/grammar/solid/validity.h>

#include <nlohmann/json.hpp>

#include "engine/io/plain_house.h"
#include "engine/io/sample_building.h"
#include "engine/io/scratch.h"

namespace gable {
namespace {

using nlohmann::json;

TEST(AddRoofSlabs, PartsGetAFinerLevelAndSlabsBecomeParts) {
  Building building = plain_house();
  const BuildingModel before = build_model(building);
  BuildingModel model = before;
  add_roof_slabs({0.35, 0.15}, {}, &building, &model);
  EXPECT_EQ(building.reason, "");
  ASSERT_GE(model.parts.size(), before.parts.size() + 2);
  for (size_t i = 0; i < before.parts.size(); ++i) {
    const PartModel& part = model.parts[i];
    EXPECT_EQ(part.solids.size(), before.parts[i].solids.size() + 1);
    EXPECT_EQ(part.solids.back().lod, Lod::k23);
    EXPECT_EQ(finest_solid_without_slabs(part)->vertices, finest_solid(before.parts[i]).vertices);
  }
  for (size_t i = before.parts.size(); i < model.parts.size(); ++i) {
    EXPECT_EQ(model.parts[i].role, PartRole::kRoofSlab);
    EXPECT_EQ(finest_solid_without_slabs(model.parts[i]), nullptr);
  }
  // What is measured stays what was fitted.
  EXPECT_EQ(table_attributes(building, model), table_attributes(building, before));
}

TEST(AddRoofSlabs, WithoutThicknessAndWithoutHouseNothingChanges) {
  Building house = plain_house(), extrusion = sample_extrusion("2");
  BuildingModel model = build_model(house);
  add_roof_slabs({}, {}, &house, &model);
  EXPECT_EQ(model.parts.size(), build_model(house).parts.size());
  BuildingModel block = build_model(extrusion);
  add_roof_slabs({0.35, 0.15}, {}, &extrusion, &block);
  EXPECT_EQ(block.parts.size(), 1u);
  EXPECT_EQ(block.parts[0].solids.size(), 1u);
}

TEST(AddRoofSlabs, NeighboursAreGivenInTheWorldFrame) {
  Building building = plain_house();
  building.house->garages.clear();
  BuildingModel model = build_model(building);
  add_roof_slabs({0.35, 0.15}, {{{{1005, 1900}, {1050, 1900}, {1050, 2100}, {1005, 2100}}, {}}},
                 &building, &model);
  double east = -1e9;
  for (const PartModel& part : model.parts) {
    if (part.role != PartRole::kRoofSlab) continue;
    for (const Eigen::Vector3d& p : finest_solid(part).vertices) east = std::max(east, p.x());
  }
  EXPECT_NEAR(east, 5.0, 1e-6);
}

TEST(AddRoofSlabs, CityJsonHasThemAsInstallationsWithUndersides) {
  const ScratchFolder scratch;
  Building building = plain_house();
  BuildingModel model = build_model(building);
  add_roof_slabs({0.35, 0.15}, {}, &building, &model);
  const auto writer = open_model_writer(scratch.path("a.city.json"), {});
  writer->append(building, model);
  writer->close();
  const json file = json::parse(file_bytes(scratch.path("a.city.json")));
  const json& slab = file["CityObjects"]["1-roof-1"];
  EXPECT_EQ(slab["type"], "BuildingInstallation");
  ASSERT_EQ(slab["geometry"].size(), 1u);
  EXPECT_EQ(slab["geometry"][0]["lod"], "2.3");
  EXPECT_EQ(slab["geometry"][0]["semantics"]["surfaces"][0]["type"], "OuterCeilingSurface");
  const json& main = file["CityObjects"]["1-main-1"];
  ASSERT_EQ(main["geometry"].size(), 4u);
  EXPECT_EQ(main["geometry"][2]["lod"], "2.2");
  EXPECT_EQ(main["geometry"][3]["lod"], "2.3");
}

}  // namespace
}  // namespace gable
