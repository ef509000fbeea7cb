#include <gable/engine/solver/neighbour_relations.h>
#include <gable/grammar/height_field.h>
#include <glog/logging.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

namespace gable {
namespace {

using Kind = NeighbourRelationKind;

std::string check(const RelationScale& scale, const std::string& name) {
  if (!(scale.tolerance > 0.0 && scale.tolerance <= 10.0)) {
    return name + ".tolerance must lie in (0, 10]";
  }
  if (!(scale.deviation > 0.0 && scale.deviation <= 10.0)) {
    return name + ".deviation must lie in (0, 10]";
  }
  if (!(scale.let_go > 0.0 && scale.let_go <= 10.0)) return name + ".let_go must lie in (0, 10]";
  return "";
}

/// World box around the components of a house.
Eigen::AlignedBox2d box_of(const House& house) {
  using namespace block_value;
  const HeightField field(house);
  Eigen::AlignedBox2d box;
  for (int c = 0; c < house.num_components(); ++c) {
    const Block<double>& block = field.blocks()[c];
    for (double x : {block[kX0], block[kX1]}) {
      for (double y : {block[kY0], block[kY1]}) {
        box.extend(field.local_from_house({x, y}) + house.origin.head<2>());
      }
    }
  }
  return box;
}

double elevation(const House& house, int component, bool ridge) {
  const Rule& roof = house.roofs[component];
  const bool rises = ridge && roof.kind != RuleKind::kRoofFlat;
  return house.origin.z() + roof[param::roof::kEaves] + (rises ? roof[param::roof::kRise] : 0.0);
}

bool is_flat(const House& house, int component) {
  return house.roofs[component].kind == RuleKind::kRoofFlat;
}

/// The party walls between two houses, the longest contacts first; of a pair of walls that both are
/// in a longer contact already nothing new would be said.
std::vector<std::pair<ComponentWall, ComponentWall>> party_walls(
    const House& a, const House& b, const NeighbourRelationOptions& options) {
  struct Found {
    ComponentWall wall_a, wall_b;
    double length;
  };
  std::vector<Found> found;
  for (int i = 0; i < 4 * a.num_components(); ++i) {
    for (int j = 0; j < 4 * b.num_components(); ++j) {
      const ComponentWall wall_a = {i / 4, i % 4}, wall_b = {j / 4, j % 4};
      const WallContact contact = wall_contact(a, wall_a, b, wall_b);
      if (contact.angle > options.wall_angle || contact.length < options.least_contact ||
          std::max(std::abs(contact.offset_from), std::abs(contact.offset_to)) >
              options.wall.tolerance) {
        continue;
      }
      found.push_back({wall_a, wall_b, contact.length});
    }
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const Found& f, const Found& g) { return f.length > g.length; });
  std::vector<std::pair<ComponentWall, ComponentWall>> kept;
  std::set<int> seen_a, seen_b;
  for (const Found& f : found) {
    const bool new_a = seen_a.insert(4 * f.wall_a.component + f.wall_a.side).second;
    const bool new_b = seen_b.insert(4 * f.wall_b.component + f.wall_b.side).second;
    if (new_a || new_b) kept.emplace_back(f.wall_a, f.wall_b);
  }
  return kept;
}

/// Appends the relations of one pair.
void detect_between(const std::vector<const House*>& houses, int a, int b,
                    const NeighbourRelationOptions& options,
                    std::vector<NeighbourRelation>* relations) {
  const House& house_a = *houses[a];
  const House& house_b = *houses[b];
  std::set<std::pair<int, int>> components;
  for (const auto& [wall_a, wall_b] : party_walls(house_a, house_b, options)) {
    relations->push_back({Kind::kPartyWall, a, b, wall_a, wall_b});
    components.emplace(wall_a.component, wall_b.component);
  }
  if (components.empty()) return;
  const auto add_if_meant = [&](const NeighbourRelation& relation) {
    if (misfit(houses, relation) <= scale_of(options, relation.kind).tolerance) {
      relations->push_back(relation);
    }
  };
  for (const auto& [component_a, component_b] : components) {
    const ComponentWall at_a = {component_a, 0}, at_b = {component_b, 0};
    add_if_meant({Kind::kEqualEaves, a, b, at_a, at_b});
    if (is_flat(house_a, component_a) || is_flat(house_b, component_b)) continue;
    add_if_meant({Kind::kEqualRidges, a, b, at_a, at_b});
  }
  add_if_meant({Kind::kEqualAzimuths, a, b, {}, {}});
}

}  // namespace

std::string check(const NeighbourRelationOptions& options) {
  for (const std::string& error : {check(options.wall, "wall"), check(options.height, "height"),
                                   check(options.azimuth, "azimuth")}) {
    if (!error.empty()) return error;
  }
  if (!(options.wall_angle > 0.0 && options.wall_angle <= 0.5)) {
    return "wall_angle must lie in (0, 0.5]";
  }
  if (!(options.least_contact > 0.0 && options.least_contact <= 100.0)) {
    return "least_contact must lie in (0, 100]";
  }
  return "";
}

const RelationScale& scale_of(const NeighbourRelationOptions& options, NeighbourRelationKind kind) {
  if (kind == Kind::kPartyWall) return options.wall;
  return kind == Kind::kEqualAzimuths ? options.azimuth : options.height;
}

double misfit(const std::vector<const House*>& houses, const NeighbourRelation& relation) {
  const House& a = *houses[relation.house_a];
  const House& b = *houses[relation.house_b];
  switch (relation.kind) {
    case Kind::kPartyWall: {
      const WallContact contact = wall_contact(a, relation.wall_a, b, relation.wall_b);
      return std::max(std::abs(contact.offset_from), std::abs(contact.offset_to));
    }
    case Kind::kEqualEaves:
    case Kind::kEqualRidges: {
      const bool ridge = relation.kind == Kind::kEqualRidges;
      return std::abs(elevation(a, relation.wall_a.component, ridge) -
                      elevation(b, relation.wall_b.component, ridge));
    }
    default:
      return std::abs(a.azimuth[0] - b.azimuth[0] - quarter_turns(a, b));
  }
}

std::vector<NeighbourRelation> detect_neighbour_relations(const std::vector<const House*>& houses,
                                                          const NeighbourRelationOptions& options) {
  CHECK(check(options).empty()) << check(options);
  std::vector<Eigen::AlignedBox2d> boxes;
  for (const House* house : houses) boxes.push_back(box_of(*house));
  std::vector<NeighbourRelation> relations;
  for (size_t a = 0; a < houses.size(); ++a) {
    for (size_t b = a + 1; b < houses.size(); ++b) {
      if (boxes[a].squaredExteriorDistance(boxes[b]) >
          options.wall.tolerance * options.wall.tolerance) {
        continue;
      }
      detect_between(houses, static_cast<int>(a), static_cast<int>(b), options, &relations);
    }
  }
  return relations;
}

HousePairRelation residual_of(const std::vector<const House*>& houses,
                              const NeighbourRelation& relation, double weight) {
  const House& a = *houses[relation.house_a];
  const House& b = *houses[relation.house_b];
  const int component_a = relation.wall_a.component, component_b = relation.wall_b.component;
  switch (relation.kind) {
    case Kind::kPartyWall:
      return party_wall(a, relation.wall_a, b, relation.wall_b, weight);
    case Kind::kEqualEaves:
      return equal_eaves(a, component_a, b, component_b, weight);
    case Kind::kEqualRidges:
      return equal_ridges(a, component_a, b, component_b, weight);
    default:
      return equal_azimuths(a, b, weight);
  }
}

}  // namespace gable
