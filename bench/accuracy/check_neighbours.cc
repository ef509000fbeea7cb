// Houses that touch, before and after they are refined together. Rows of made-up houses, surveyed
// and reconstructed with known footprints: errors of party walls, eaves, ridges and azimuths
// against the truth, and how well the models fit each other.
//   gable_check_neighbours [rows] [first seed] [houses a row] [threads]
// Or how well the houses of model files fit each other:
//   gable_check_neighbours MODELS...

#include <gable/engine/io/models/building_file.h>
#include <gable/engine/ordered_pool.h>
#include <gable/engine/reconstruct/building/reconstruct_building.h>
#include <gable/engine/reconstruct/neighbours/join_neighbours.h>
#include <gable/engine/stopwatch.h>
#include <gable/grammar/height_field.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <string>
#include <vector>

#include "../terrace_images.h"
#include "wall_figures.h"

namespace gable {
namespace {

struct Errors {
  std::vector<double> walls, eaves, ridges, azimuths, mads;

  void append(const Errors& other) {
    for (auto member :
         {&Errors::walls, &Errors::eaves, &Errors::ridges, &Errors::azimuths, &Errors::mads}) {
      (this->*member).insert((this->*member).end(), (other.*member).begin(), (other.*member).end());
    }
  }
};

struct RowResult {
  Errors before, after;
  WallFigures figures_before, figures_after;
  int houses = 0, grammar = 0, joined = 0;
  double join_ms = 0.0;
};

// Signed distances of a true party wall, seen as that of the house beyond it, from the nearest wall
// of the model that faces it; 1 m and more is another wall.
void add_wall_errors(const House& beyond, const ComponentWall& wall, const House& model,
                     std::vector<double>* errors) {
  double best = 1.0;
  std::optional<WallContact> nearest;
  for (int i = 0; i < 4 * model.num_components(); ++i) {
    const WallContact contact = wall_contact(beyond, wall, model, {i / 4, i % 4});
    if (contact.angle > 0.175 || contact.length < 1.5) continue;
    const double middle = 0.5 * std::abs(contact.offset_from + contact.offset_to);
    if (middle >= best) continue;
    best = middle;
    nearest = contact;
  }
  if (!nearest) return;
  errors->push_back(std::abs(nearest->offset_from));
  errors->push_back(std::abs(nearest->offset_to));
}

// The component of the model over the middle of the first component of the truth, or -1.
int main_component(const House& truth, const House& model) {
  const HeightField a(truth), b(model);
  const Rule& footprint = truth.footprints[0];
  const Eigen::Vector2d world =
      a.local_from_house({footprint[0], footprint[1]}) + truth.origin.head<2>();
  const Eigen::Vector2d p = b.house_from_local(world - model.origin.head<2>());
  for (int c = 0; c < model.num_components(); ++c) {
    using namespace block_value;
    const Block<double>& block = b.blocks()[c];
    if (p.x() > block[kX0] && p.x() < block[kX1] && p.y() > block[kY0] && p.y() < block[kY1]) {
      return c;
    }
  }
  return -1;
}

void add_height_errors(const House& truth, const House& model, Errors* errors) {
  const int c = main_component(truth, model);
  if (c < 0) return;
  const Rule& roof = model.roofs[c];
  const Rule& true_roof = truth.roofs[0];
  const bool flat = true_roof.kind == RuleKind::kRoofFlat;
  if (flat != (roof.kind == RuleKind::kRoofFlat)) return;
  const double eaves = model.origin.z() + roof[0] - truth.origin.z() - true_roof[0];
  if (std::abs(eaves) < 1.0) errors->eaves.push_back(std::abs(eaves));
  if (flat) return;
  const double ridge = eaves + roof[1] - true_roof[1];
  if (std::abs(ridge) < 1.0) errors->ridges.push_back(std::abs(ridge));
}

Errors errors_of(const Terrace& terrace, const std::vector<Building>& buildings) {
  Errors errors;
  std::vector<const House*> truth;
  for (const House& house : terrace.houses) truth.push_back(&house);
  for (const NeighbourRelation& relation : detect_neighbour_relations(truth, {})) {
    if (relation.kind != NeighbourRelationKind::kPartyWall) continue;
    const auto& a = buildings[relation.house_a].house;
    const auto& b = buildings[relation.house_b].house;
    if (!a || !b) continue;
    add_wall_errors(*truth[relation.house_b], relation.wall_b, *a, &errors.walls);
    add_wall_errors(*truth[relation.house_a], relation.wall_a, *b, &errors.walls);
  }
  for (size_t i = 0; i < buildings.size(); ++i) {
    errors.mads.push_back(buildings[i].quality.mad);
    if (!buildings[i].house) continue;
    const House& model = *buildings[i].house;
    add_height_errors(*truth[i], model, &errors);
    const double turn = model.azimuth[0] - truth[i]->azimuth[0] - quarter_turns(model, *truth[i]);
    errors.azimuths.push_back(std::abs(turn) * 180.0 / M_PI);
  }
  return errors;
}

WallFigures figures_of(const std::vector<Building>& buildings) {
  std::vector<const House*> houses;
  for (const Building& building : buildings) {
    if (building.house) houses.push_back(&*building.house);
  }
  return wall_figures(houses);
}

RowResult run_row(uint64_t seed, int count) {
  TerraceOptions options;
  options.count = count;
  options.seed = seed;
  const Terrace terrace = make_terrace(options);
  const std::vector<HeightImage> images = terrace_images(terrace);
  std::vector<Building> buildings;
  std::vector<FittedBuilding> fitted;
  for (size_t i = 0; i < images.size(); ++i) {
    PlanPolygon outline = terrace.footprints[i];
    for (Eigen::Vector2d& p : outline.outer) p -= images[i].origin.head<2>();
    for (auto& hole : outline.holes) {
      for (Eigen::Vector2d& p : hole) p -= images[i].origin.head<2>();
    }
    buildings.push_back(
        reconstruct_building(std::to_string(i), images[i], &outline, {}, {}).building);
  }
  for (size_t i = 0; i < images.size(); ++i) fitted.push_back({&buildings[i], &images[i]});
  JoinOptions join;
  join.refinement.stage = last_stage(true);
  RowResult result;
  const Stopwatch watch;
  auto joined = join_neighbours(fitted, join, 1, {});
  result.join_ms = watch.ms();
  result.before = errors_of(terrace, buildings);
  result.figures_before = figures_of(buildings);
  for (size_t i = 0; i < joined.size(); ++i) {
    ++result.houses;
    result.grammar += buildings[i].house.has_value();
    if (!joined[i]) continue;
    ++result.joined;
    buildings[i] = std::move(joined[i]->building);
  }
  result.after = errors_of(terrace, buildings);
  result.figures_after = figures_of(buildings);
  return result;
}

void print(const char* name, std::vector<double> before, std::vector<double> after,
           const char* unit) {
  const auto figures = [&](std::vector<double>* values) {
    std::sort(values->begin(), values->end());
    double sum = 0.0;
    for (double v : *values) sum += v;
    const size_t n = std::max<size_t>(values->size(), 1);
    values->resize(n);
    std::printf("  median %.3f, mean %.3f, 95 %% %.3f (%zu)", (*values)[n / 2],
                sum / static_cast<double>(n), (*values)[n * 95 / 100], n);
  };
  std::printf("%s, %s\n    before", name, unit);
  figures(&before);
  std::printf("\n    after ");
  figures(&after);
  std::printf("\n");
}

void add(const WallFigures& from, WallFigures* to) {
  to->walls += from.walls;
  to->closed += from.closed;
  to->gap += from.gap;
  to->overlap += from.overlap;
}

int run_rows(int rows, uint64_t first_seed, int count, int threads) {
  RowResult all;
  run_in_order<RowResult>(
      static_cast<size_t>(rows), threads, {},
      [&](size_t i) { return run_row(first_seed + i, count); },
      [&](RowResult&& row) {
        all.before.append(row.before);
        all.after.append(row.after);
        add(row.figures_before, &all.figures_before);
        add(row.figures_after, &all.figures_after);
        all.houses += row.houses;
        all.grammar += row.grammar;
        all.joined += row.joined;
        all.join_ms += row.join_ms;
      });
  std::printf("%d rows of %d houses: %d of the grammar, %d refined together, %.1f ms a house\n",
              rows, count, all.grammar, all.joined, all.join_ms / std::max(1, all.houses));
  print("party walls", all.before.walls, all.after.walls, "m");
  print("eaves", all.before.eaves, all.after.eaves, "m");
  print("ridges", all.before.ridges, all.after.ridges, "m");
  print("azimuth", all.before.azimuths, all.after.azimuths, "degrees");
  print("MAD", all.before.mads, all.after.mads, "m");
  std::printf("models  before  %s\n        after   %s\n", text_of(all.figures_before).c_str(),
              text_of(all.figures_after).c_str());
  return 0;
}

}  // namespace
}  // namespace gable

int main(int argc, char** argv) {
  if (argc > 1 && std::atoi(argv[1]) == 0) {
    for (int i = 1; i < argc; ++i) {
      const gable::BuildingFile file = gable::read_buildings(argv[i]);
      std::printf("%s: %s\n", argv[i], gable::text_of(gable::figures_of(file.buildings)).c_str());
    }
    return 0;
  }
  const auto number = [&](int i, int otherwise) {
    return argc > i ? std::atoi(argv[i]) : otherwise;
  };
  return gable::run_rows(number(1, 100), static_cast<uint64_t>(number(2, 1)), number(3, 6),
                         number(4, 2));
}
