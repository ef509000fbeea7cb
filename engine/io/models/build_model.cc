#include <gable/engine/io/models/build_model.h>

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

namespace gable {

namespace {

/// The part of a role, index and piece; added where it is new.
PartModel& part_of(PartRole role, int index, int piece, BuildingModel* model) {
  for (PartModel& part : model->parts) {
    if (part.role == role && part.index == index && part.piece == piece) return part;
  }
  return model->parts.emplace_back(PartModel{role, index, piece, {}});
}

void add_roof(const RoofPartition& roof, double base, BuildingModel* model) {
  const std::optional<std::vector<Solid>> solids = solids_of_partition(roof, base);
  if (!solids || solids->empty()) {
    model->dropped.push_back("the planes of the roof enclose no valid solid");
    return;
  }
  for (size_t i = 0; i < solids->size(); ++i) {
    PartModel& part = part_of(PartRole::kMain, 0, static_cast<int>(i), model);
    for (const Lod lod : {Lod::k20, Lod::k22}) part.solids.push_back({lod, (*solids)[i]});
  }
}

}  // namespace

BuildingModel build_model(const Building& building, std::span<const Lod> lods) {
  BuildingModel model;
  if (!building.house) {
    model.origin = building.origin;
    Solid solid = extrude(building.outline, building.base, building.height);
    if (solid.faces.empty()) {
      model.dropped.push_back("the outline encloses no volume");
    } else {
      part_of(PartRole::kMain, 0, 0, &model).solids.push_back({Lod::k12, std::move(solid)});
    }
    if (building.roof) add_roof(*building.roof, building.base, &model);
    return model;
  }
  model.origin = building.house->origin;
  for (const Lod lod : lods) {
    HouseSolids solids = build_house_solids(*building.house, lod, building.base, building.walls);
    std::map<std::pair<PartRole, int>, int> pieces;
    for (HousePart& part : solids.parts) {
      const int piece = pieces[{part.role, part.index}]++;
      part_of(part.role, part.index, piece, &model).solids.push_back({lod, std::move(part.solid)});
    }
    if (lod == Lod::k22) model.dropped = std::move(solids.dropped);
  }
  std::stable_sort(
      model.parts.begin(), model.parts.end(), [](const PartModel& a, const PartModel& b) {
        return std::tuple(a.role, a.index, a.piece) < std::tuple(b.role, b.index, b.piece);
      });
  return model;
}

}  // namespace gable
