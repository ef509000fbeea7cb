#include <gable/engine/io/models/add_roof_slabs.h>

#include <algorithm>
#include <map>
#include <utility>

namespace gable {
namespace {

std::vector<PlanPolygon> in_local_frame(std::vector<PlanPolygon> polygons,
                                        const Eigen::Vector3d& origin) {
  for (PlanPolygon& polygon : polygons) {
    for (Eigen::Vector2d& p : polygon.outer) p -= origin.head<2>();
    for (auto& hole : polygon.holes) {
      for (Eigen::Vector2d& p : hole) p -= origin.head<2>();
    }
  }
  return polygons;
}

}  // namespace

void add_roof_slabs(const RoofSlabOptions& options, const std::vector<PlanPolygon>& neighbours,
                    Building* building, BuildingModel* model) {
  if (!options.wanted() || !building->house) return;
  HouseSolids solids = build_roof_slabs(*building->house, building->base, options,
                                        in_local_frame(neighbours, building->house->origin));
  for (const std::string& line : solids.dropped) {
    model->dropped.push_back(line);
    building->reason += (building->reason.empty() ? "" : "; ") + line;
  }
  std::map<std::pair<PartRole, int>, int> pieces;
  for (HousePart& part : solids.parts) {
    const int piece = pieces[{part.role, part.index}]++;
    const auto known =
        std::find_if(model->parts.begin(), model->parts.end(), [&](const PartModel& p) {
          return p.role == part.role && p.index == part.index && p.piece == piece;
        });
    PartModel& target =
        known != model->parts.end()
            ? *known
            : model->parts.emplace_back(PartModel{part.role, part.index, piece, {}});
    target.solids.push_back({Lod::k23, std::move(part.solid)});
  }
}

}  // namespace gable
