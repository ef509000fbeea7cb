#include <gable/engine/io/models/build_model.h>
#include <gable/engine/ordered_pool.h>
#include <gable/engine/reconstruct/building/building_fit.h>
#include <gable/engine/reconstruct/building/known_walls.h>
#include <gable/engine/reconstruct/building/model_defect.h>
#include <gable/engine/reconstruct/choice/penalised_cost.h>
#include <gable/engine/reconstruct/neighbours/join_neighbours.h>
#include <gable/engine/reconstruct/neighbours/neighbour_groups.h>
#include <gable/engine/stopwatch.h>
#include <gable/grammar/height_field.h>
#include <glog/logging.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace gable {
namespace {

/// What came of a group: positions of buildings, and what they became.
using GroupResult = std::vector<std::pair<int, JoinedBuilding>>;

/// Whether a point lies within `margin` of a wall, house frame.
bool is_at(const Block<double>& block, int side, const Eigen::Vector2d& p, double margin) {
  using namespace block_value;
  const bool across_x = side == kX0 || side == kX1;
  const int low = across_x ? kY0 : kX0;
  const double across = across_x ? p.x() : p.y(), along = across_x ? p.y() : p.x();
  return std::abs(across - block[side]) < margin && along > block[low] - margin &&
         along < block[low + 1] + margin;
}

/// An image without the pixels at some walls of a house. A pixel there belongs to one of two
/// houses, and its support reaches into the other: what it costs either says nothing about heights.
HeightImage without_walls(const HeightImage& image, const House& house,
                          const std::vector<ComponentWall>& walls, double support) {
  HeightImage out = image;
  const double margin = M_SQRT1_2 * image.gsd + 0.5 * support;
  const HeightField field(house);
  for (int row = 0; row < image.rows; ++row) {
    for (int col = 0; col < image.cols; ++col) {
      const Eigen::Vector2d p = field.house_from_local(image.center_of(row, col));
      for (const ComponentWall& wall : walls) {
        if (!is_at(field.blocks()[wall.component], wall.side, p, margin)) continue;
        out.weight[out.index(row, col)] = 0.0f;
        break;
      }
    }
  }
  return out;
}

/// The robust cost of a house against heights.
double robust_cost(const HeightImage& image, const RefinementStage& stage, const House& house) {
  PenaltyOptions penalty;
  penalty.support = stage.support;
  penalty.loss = stage.loss;
  penalty.loss_scale = stage.loss_scale;
  return squared_residuals(image, house, penalty);
}

class Group {
 public:
  /// `members`: positions in `buildings`. `relations`: with positions in `members`.
  Group(const std::vector<FittedBuilding>& buildings, const std::vector<int>& members,
        std::vector<NeighbourRelation> relations, const JoinOptions& options)
      : members_(members), relations_(std::move(relations)), options_(options) {
    for (int member : members) fitted_.push_back(buildings[member]);
  }

  GroupResult join() {
    for (int round = 0; round < options_.rounds && !relations_.empty(); ++round) {
      if (std::optional<GroupResult> joined = try_once()) return std::move(*joined);
    }
    return {};
  }

 private:
  /// Refines what relations still hold together. Where houses fail, drops their relations.
  std::optional<GroupResult> try_once() {
    const Stopwatch watch;
    std::vector<House> houses;
    for (const FittedBuilding& fitted : fitted_) houses.push_back(*fitted.building->house);
    std::vector<int> slots(houses.size(), -1);
    std::vector<NeighbourHouse> views;
    std::vector<NeighbourRelation> relations = relations_;
    for (NeighbourRelation& relation : relations) {
      for (int* number : {&relation.house_a, &relation.house_b}) {
        int& slot = slots[*number];
        if (slot < 0) {
          slot = static_cast<int>(views.size());
          views.push_back({fitted_[*number].image, &houses[*number]});
        }
        *number = slot;
      }
    }
    const std::vector<double> before = misfits();
    const NeighbourRefinementSummary summary =
        refine_neighbours(views, relations, options_.refinement);
    if (summary.minimizer.termination == Termination::kFailed) {
      relations_.clear();
      return std::nullopt;
    }
    GroupResult joined;
    std::vector<char> failed(houses.size(), 0);
    for (size_t i = 0; i < houses.size(); ++i) {
      if (slots[i] < 0) continue;
      std::optional<JoinedBuilding> made = remade(i, houses[i]);
      failed[i] = !made;
      if (!made) continue;
      made->relations = used_by(static_cast<int>(i), before, summary.misfits);
      joined.emplace_back(members_[i], std::move(*made));
    }
    const double ms = watch.ms();
    for (auto& [member, made] : joined) {
      made.building.quality.time_ms += ms / static_cast<double>(joined.size());
    }
    if (std::find(failed.begin(), failed.end(), 1) == failed.end()) return joined;
    drop_of(failed, before);
    return std::nullopt;
  }

  /// Takes from every house that failed what it shares besides walls or, if that is all, the wall
  /// with the largest misfit.
  void drop_of(const std::vector<char>& failed, const std::vector<double>& before) {
    std::vector<char> dropped(relations_.size(), 0);
    for (size_t house = 0; house < failed.size(); ++house) {
      if (!failed[house]) continue;
      bool walls_only = true;
      std::optional<size_t> worst;
      for (size_t r = 0; r < relations_.size(); ++r) {
        const NeighbourRelation& relation = relations_[r];
        const int number = static_cast<int>(house);
        if (relation.house_a != number && relation.house_b != number) continue;
        if (relation.kind != NeighbourRelationKind::kPartyWall) {
          walls_only = false;
          dropped[r] = 1;
        } else if (!worst || before[r] > before[*worst]) {
          worst = r;
        }
      }
      if (walls_only && worst) dropped[*worst] = 1;
    }
    std::vector<NeighbourRelation> kept;
    for (size_t r = 0; r < relations_.size(); ++r) {
      if (!dropped[r]) kept.push_back(relations_[r]);
    }
    relations_ = std::move(kept);
  }

  std::vector<double> misfits() const {
    std::vector<const House*> houses;
    for (const FittedBuilding& fitted : fitted_) houses.push_back(&*fitted.building->house);
    std::vector<double> out;
    for (const NeighbourRelation& relation : relations_) out.push_back(misfit(houses, relation));
    return out;
  }

  /// A building with another house, or nothing where that will not do.
  std::optional<JoinedBuilding> remade(size_t i, const House& house) const {
    const HeightImage& image = *fitted_[i].image;
    const RefinementStage& stage = options_.refinement.stage;
    const HeightImage clear =
        without_walls(image, house, walls_of(static_cast<int>(i)), stage.support);
    if (robust_cost(clear, stage, house) >
        (1.0 + options_.cost_rise) * robust_cost(clear, stage, *fitted_[i].building->house)) {
      return std::nullopt;
    }
    JoinedBuilding made;
    made.building = *fitted_[i].building;
    made.building.house = house;
    made.building.deviations = deviations_from_heights(image, stage, house);
    // The house has moved under its walls.
    const PlanPolygon walls = made.building.walls.polygon;
    if (!walls.outer.empty()) made.building.walls = known_walls(walls, image, made.building);
    set_fit(fit_of_building(image, made.building), &made.building);
    made.model = build_model(made.building);
    if (!defect_of(made.model).empty()) return std::nullopt;
    return made;
  }

  /// The walls that a house shares.
  std::vector<ComponentWall> walls_of(int number) const {
    std::vector<ComponentWall> walls;
    for (const NeighbourRelation& relation : relations_) {
      if (relation.kind != NeighbourRelationKind::kPartyWall) continue;
      if (relation.house_a == number) walls.push_back(relation.wall_a);
      if (relation.house_b == number) walls.push_back(relation.wall_b);
    }
    return walls;
  }

  std::vector<UsedRelation> used_by(int number, const std::vector<double>& before,
                                    const std::vector<double>& after) const {
    std::vector<UsedRelation> used;
    for (size_t r = 0; r < relations_.size(); ++r) {
      const NeighbourRelation& relation = relations_[r];
      if (relation.house_a != number && relation.house_b != number) continue;
      const int other = relation.house_a == number ? relation.house_b : relation.house_a;
      used.push_back({relation.kind, fitted_[other].building->id, before[r], after[r]});
    }
    return used;
  }

  std::vector<FittedBuilding> fitted_;
  std::vector<int> members_;
  std::vector<NeighbourRelation> relations_;
  const JoinOptions& options_;
};

/// Those of `relations` that lie within each group, with positions in the group.
std::vector<std::vector<NeighbourRelation>> relations_by_group(
    const std::vector<std::vector<int>>& groups, const std::vector<NeighbourRelation>& relations,
    size_t num_houses) {
  std::vector<std::pair<int, int>> place(num_houses, {-1, -1});
  for (size_t g = 0; g < groups.size(); ++g) {
    for (size_t i = 0; i < groups[g].size(); ++i) {
      place[groups[g][i]] = {static_cast<int>(g), static_cast<int>(i)};
    }
  }
  std::vector<std::vector<NeighbourRelation>> out(groups.size());
  for (NeighbourRelation relation : relations) {
    const auto [group_a, a] = place[relation.house_a];
    const auto [group_b, b] = place[relation.house_b];
    if (group_a < 0 || group_a != group_b) continue;
    relation.house_a = a;
    relation.house_b = b;
    out[group_a].push_back(relation);
  }
  return out;
}

}  // namespace

std::string check(const JoinOptions& options) {
  if (const std::string error = check(options.refinement); !error.empty()) return error;
  if (options.most_houses < 2 || options.most_houses > 1000) {
    return "most_houses must lie in [2, 1000]";
  }
  if (!(options.cost_rise >= 0.0 && options.cost_rise <= 1.0)) {
    return "cost_rise must lie in [0, 1]";
  }
  if (options.rounds < 1 || options.rounds > 100) return "rounds must lie in [1, 100]";
  return "";
}

std::vector<std::optional<JoinedBuilding>> join_neighbours(
    const std::vector<FittedBuilding>& buildings, const JoinOptions& options, int threads,
    const std::stop_token& stop) {
  CHECK(check(options).empty()) << check(options);
  std::vector<std::optional<JoinedBuilding>> joined(buildings.size());
  std::vector<const House*> houses;
  std::vector<int> of_house;  // the building of each
  for (size_t i = 0; i < buildings.size(); ++i) {
    const std::optional<House>& house = buildings[i].building->house;
    if (!house) continue;
    houses.push_back(&*house);
    of_house.push_back(static_cast<int>(i));
  }
  const std::vector<NeighbourRelation> relations =
      detect_neighbour_relations(houses, options.refinement.relations);
  std::vector<std::vector<int>> groups =
      neighbour_groups(static_cast<int>(houses.size()), relations, options.most_houses);
  const auto within = relations_by_group(groups, relations, houses.size());
  for (std::vector<int>& group : groups) {
    for (int& member : group) member = of_house[member];
  }
  run_in_order<GroupResult>(
      groups.size(), threads, stop,
      [&](size_t g) { return Group(buildings, groups[g], within[g], options).join(); },
      [&](GroupResult&& result) {
        for (auto& [member, made] : result) joined[member] = std::move(made);
      });
  return joined;
}

}  // namespace gable
