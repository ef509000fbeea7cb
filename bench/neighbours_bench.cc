#include <benchmark/benchmark.h>
#include <gable/engine/reconstruct/choice/house_choice.h>
#include <gable/engine/solver/neighbour_refinement.h>

#include <vector>

#include "terrace_images.h"

namespace gable {
namespace {

// A row as its houses were fitted one by one, each in the frame of its truth.
struct FittedRow {
  std::vector<House> houses;
  std::vector<HeightImage> images;
  std::vector<NeighbourRelation> relations;
};

FittedRow fitted_row(int count) {
  TerraceOptions terrace_options;
  terrace_options.count = count;
  terrace_options.seed = 2;
  Terrace terrace = make_terrace(terrace_options);
  FittedRow row;
  row.houses = terrace.houses;
  row.images = terrace_images(terrace);
  RefinementOptions options;
  options.stages = {last_stage(true)};
  options.deviations = false;
  std::vector<const House*> views;
  for (size_t i = 0; i < row.houses.size(); ++i) {
    move_origin(row.houses[i].origin, &row.images[i]);
    refine_house(row.images[i], options, &row.houses[i]);
    views.push_back(&row.houses[i]);
  }
  row.relations = detect_neighbour_relations(views, {});
  return row;
}

// The same number of steps whatever the elimination, so that times compare.
void run(benchmark::State& state, bool sparse) {
  const FittedRow start = fitted_row(static_cast<int>(state.range(0)));
  NeighbourRefinementOptions options;
  options.stage = last_stage(true);
  options.stage.max_iterations = 10;
  options.function_tolerance = 0.0;
  options.sparse = sparse;
  NeighbourRefinementSummary summary;
  for (auto _ : state) {
    std::vector<House> houses = start.houses;
    std::vector<NeighbourHouse> neighbours;
    for (size_t i = 0; i < houses.size(); ++i) neighbours.push_back({&start.images[i], &houses[i]});
    summary = refine_neighbours(neighbours, start.relations, options);
  }
  state.counters["parameters"] = summary.num_parameters;
  state.counters["relations"] = static_cast<double>(start.relations.size());
  state.counters["iterations"] = summary.minimizer.iterations;
  state.counters["cost"] = summary.minimizer.final_cost;
}

void BM_RefineNeighboursSparse(benchmark::State& state) { run(state, true); }
BENCHMARK(BM_RefineNeighboursSparse)
    ->Arg(5)
    ->Arg(10)
    ->Arg(20)
    ->Arg(40)
    ->Unit(benchmark::kMillisecond);

void BM_RefineNeighboursDense(benchmark::State& state) { run(state, false); }
BENCHMARK(BM_RefineNeighboursDense)
    ->Arg(5)
    ->Arg(10)
    ->Arg(20)
    ->Arg(40)
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace gable
