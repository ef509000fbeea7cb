#include <gable/grammar/synthesis/gardens.h>

#include <algorithm>
#include <cmath>

namespace gable {
namespace {

constexpr double kClearOfHouses = 1.0;
constexpr double kHedgeClear = 0.4;

bool is_clear(const Eigen::Vector2d& point, double gap, const StreetPlan& plan) {
  return std::all_of(plan.plots.begin(), plan.plots.end(), [&](const StreetPlot& plot) {
    return !plot.plot.may_be_closer(point, gap) || plot.plot.distance(point) >= gap;
  });
}

/// Distance from the centre line, near the frontage of a plot.
bool is_on_street(const Eigen::Vector2d& point, const StreetPlot& plot, const StreetPlan& plan) {
  const Street& street = plan.streets[plot.street];
  for (double along = plot.start - 30.0; along < plot.end + 30.0; along += 2.0) {
    if ((street.at(along) - point).norm() < kStreetHalfWidth) return true;
  }
  return false;
}

Tree tree_over_wall(const Plot& plot, Random* random) {
  const double angle = random->uniform(0.0, 2.0 * M_PI);
  const Eigen::Vector2d outward(std::cos(angle), std::sin(angle));
  Tree tree = random_tree(Eigen::Vector2d::Zero(), random);
  const double away = plot.edge_towards(outward) + tree.radius - random->uniform(0.0, 0.8);
  tree.center = plot.house().origin.head<2>() + away * outward;
  return tree;
}

/// Point of a street's side: `along` the street, `across` from its centre line on a plot's side.
Eigen::Vector2d beside_street(const StreetPlot& plot, const StreetPlan& plan, double along,
                              double across) {
  const Street& street = plan.streets[plot.street];
  const double direction = street.direction_at(along);
  const Eigen::Vector2d normal(-std::sin(direction), std::cos(direction));
  return street.at(along) + plot.side * across * normal;
}

/// Adds the hedge where no house is in its way.
void add_clear_hedge(Hedge hedge, const StreetPlan& plan, Random* random, Gardens* gardens) {
  hedge.width = random->uniform(0.6, 1.1);
  hedge.height = random->uniform(1.0, 1.8);
  const int steps = std::max(1, static_cast<int>(std::ceil((hedge.to - hedge.from).norm() / 0.5)));
  for (int i = 0; i <= steps; ++i) {
    const Eigen::Vector2d p = hedge.from + (hedge.to - hedge.from) * i / steps;
    if (!is_clear(p, kHedgeClear + 0.5 * hedge.width, plan)) return;
  }
  gardens->hedges.push_back(hedge);
}

}  // namespace

Gardens plant_gardens(const StreetPlan& plan, const VillageOptions& options, Random* random) {
  Gardens gardens;
  for (const StreetPlot& plot : plan.plots) {
    if (random->chance(options.touching_trees)) {
      gardens.trees.push_back(tree_over_wall(plot.plot, random));
    }
    const int wanted =
        static_cast<int>(std::floor(options.trees_per_house + random->uniform(0.0, 1.0)));
    for (int i = 0; i < wanted; ++i) {
      for (int attempt = 0; attempt < 8; ++attempt) {
        const double along = random->uniform(plot.start - 3.0, plot.end + 3.0);
        const double across = random->uniform(kStreetHalfWidth, 38.0);
        const Tree tree = random_tree(beside_street(plot, plan, along, across), random);
        if (is_on_street(tree.center, plot, plan)) continue;
        if (!is_clear(tree.center, 1.15 * tree.radius + kClearOfHouses, plan)) continue;
        gardens.trees.push_back(tree);
        break;
      }
    }
    if (random->chance(options.hedge_share)) {  // along the front, with a way in
      const double front = kStreetHalfWidth + 0.8;
      const double gate = random->uniform(plot.start + 1.0, plot.end - 4.0);
      add_clear_hedge({beside_street(plot, plan, plot.start - 1.0, front),
                       beside_street(plot, plan, gate, front)},
                      plan, random, &gardens);
      add_clear_hedge({beside_street(plot, plan, gate + 3.0, front),
                       beside_street(plot, plan, plot.end + 1.0, front)},
                      plan, random, &gardens);
    }
    if (random->chance(options.hedge_share)) {  // along the boundary after the house
      const double along = plot.end + 0.5 * options.gap;
      add_clear_hedge({beside_street(plot, plan, along, kStreetHalfWidth + 1.0),
                       beside_street(plot, plan, along, random->uniform(20.0, 34.0))},
                      plan, random, &gardens);
    }
  }
  return gardens;
}

}  // namespace gable
