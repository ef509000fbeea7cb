#include <gable/engine/io/build_model.h>

#include <algorithm>
#include <utility>

namespace gable {

BuildingModel build_model(const Building& building) {
  BuildingModel model;
  if (!building.house) {
    model.origin = building.origin;
    PartModel part;
    part.solids.push_back({Lod::k12, extrude(building.outline, building.base, building.height)});
    model.parts.push_back(std::move(part));
    return model;
  }
  model.origin = building.house->origin;
  for (const Lod lod : {Lod::k12, Lod::k20, Lod::k22}) {
    HouseSolids solids = build_house_solids(*building.house, lod, building.base);
    for (HousePart& part : solids.parts) {
      auto known = std::find_if(
          model.parts.begin(), model.parts.end(),
          [&part](const PartModel& m) { return m.role == part.role && m.index == part.index; });
      if (known == model.parts.end()) {
        known = model.parts.insert(known, PartModel{part.role, part.index, {}});
      }
      known->solids.push_back({lod, std::move(part.solid)});
    }
    if (lod == Lod::k22) model.dropped = std::move(solids.dropped);
  }
  std::stable_sort(model.parts.begin(), model.parts.end(),
                   [](const PartModel& a, const PartModel& b) {
                     return std::pair(a.role, a.index) < std::pair(b.role, b.index);
                   });
  return model;
}

}  // namespace gable
