#include <gable/grammar/plan_outline.h>
#include <gable/grammar/synthesis/built_shape.h>
#include <gable/grammar/synthesis/complex_shapes.h>
#include <gable/grammar/synthesis/lidar.h>
#include <gable/grammar/synthesis/neighbours.h>
#include <gable/grammar/synthesis/plan_union.h>
#include <gable/grammar/synthesis/roof_clutter.h>
#include <gable/grammar/synthesis/site_ground.h>
#include <gable/grammar/synthesis/surroundings.h>
#include <gable/grammar/synthesis/survey_defects.h>
#include <gable/grammar/synthesis/survey_sampling.h>
#include <gable/grammar/synthesis/training_house.h>
#include <gable/grammar/synthesis/training_scene.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <utility>

namespace gable {
namespace {

constexpr double kMargin = 8.0;       // of the raster around the building, metres
constexpr double kGroveShare = 0.25;  // of kC: trees and hedges
constexpr double kHigh = 1.8;         // what is lower is no part of a building, metres
constexpr double kOutliers = 0.002;   // of the cells
const Eigen::Vector2d kPlace(400000.0, 200000.0);

/// Cells of 0.5 and 1 m are what surveys have: seven in ten where these are allowed.
double random_gsd(const TrainingSceneOptions& options, Random* random) {
  const double kind = random->uniform(0.0, 1.0);
  const double any = random->uniform(options.least_gsd, options.most_gsd);
  const double common = kind < 0.35 ? 0.5 : (kind < 0.7 ? 1.0 : any);
  return common >= options.least_gsd && common <= options.most_gsd ? common : any;
}

/// Most surveys are cleaner than the paper's noise.
double random_noise_range(const TrainingSceneOptions& options, Random* random) {
  const double share = std::pow(random->uniform(0.0, 1.0), 1.5);
  if (options.least_noise <= 0.0) return share * options.most_noise;
  return options.least_noise * std::pow(options.most_noise / options.least_noise, share);
}

struct Box {
  Eigen::Vector2d low = Eigen::Vector2d::Constant(std::numeric_limits<double>::infinity());
  Eigen::Vector2d high = -low;

  void add(const Eigen::Vector2d& point, double around) {
    low = low.cwiseMin(point - Eigen::Vector2d::Constant(around));
    high = high.cwiseMax(point + Eigen::Vector2d::Constant(around));
  }
  PlanRing ring() const { return {low, {high.x(), low.y()}, high, {low.x(), high.y()}}; }
};

/// The cells of a survey, which lie on multiples of their size, around a box.
Grid grid_around(const Box& box, double gsd) {
  Grid grid;
  grid.gsd = gsd;
  const Eigen::Vector2d from = box.low - Eigen::Vector2d::Constant(kMargin);
  const Eigen::Vector2d to = box.high + Eigen::Vector2d::Constant(kMargin);
  grid.north_west = {std::floor(from.x() / gsd) * gsd, std::ceil(to.y() / gsd) * gsd};
  grid.cols = static_cast<int>(std::ceil((to.x() - grid.north_west.x()) / gsd));
  grid.rows = static_cast<int>(std::ceil((grid.north_west.y() - from.y()) / gsd));
  return grid;
}

/// The largest piece of a placed house's outline, world.
PlanPolygon world_outline(const House& house) {
  PlanPolygon largest;
  for (PlanPolygon& polygon : plan_outline(house)) {
    if (largest.outer.empty() || signed_area(polygon.outer) > signed_area(largest.outer)) {
      largest = std::move(polygon);
    }
  }
  for (auto& p : largest.outer) p += house.origin.head<2>();
  for (auto& hole : largest.holes) {
    for (auto& p : hole) p += house.origin.head<2>();
  }
  return largest;
}

/// What stands in a scene.
struct Site {
  BuiltShape building;  ///< empty: a grove
  BuiltShape others;    ///< neighbours, sheds, cars
  Greenery greenery;
  PlanRing around;  ///< the building's outline, or the box around a grove
};

void place_building(Foundation foundation, const TrainingSceneOptions& options,
                    const Eigen::Vector3d& at, Random* random, TrainingScene* scene, Site* site) {
  scene->foundation = foundation;
  if (foundation != Foundation::kC) {
    scene->house = random_training_house(foundation, random, options.prior);
    scene->house.origin = at;
    site->building = shape_of(scene->house);
    scene->outline = world_outline(scene->house);
  } else if (random->chance(kGroveShare)) {
    scene->center = at.head<2>();
    site->greenery = random_grove(scene->center, random);
    Box box;
    for (const Tree& tree : site->greenery.trees) box.add(tree.center, tree.radius);
    for (const Hedge& hedge : site->greenery.hedges) {
      box.add(hedge.from, hedge.width);
      box.add(hedge.to, hedge.width);
    }
    site->around = box.ring();
    return;
  } else {
    site->building = random_complex(random);
    site->building.move(at);
    scene->outline = outline_of(site->building);
  }
  site->around = scene->outline.outer;
  scene->center = site->building.parts[0].center;
}

void add_neighbours(const TrainingScene& scene, double ground, double share, Random* random,
                    Site* site) {
  const auto add = [&](NeighbourKind kind) {
    site->others.append(scene.foundation == Foundation::kC
                            ? random_neighbours(kind, site->around, ground, random)
                            : random_neighbours(kind, scene.house, random));
  };
  const bool is_building = !site->building.parts.empty();
  if (is_building && random->chance(share)) {
    add(random->chance(0.65) ? NeighbourKind::kPartyWall : NeighbourKind::kClose);
  }
  if (random->chance(share)) add(NeighbourKind::kApart);
}

/// Whether anything as high as a building is closer to it than `reach`.
bool is_joined(const Site& site, const SiteGround& ground, double reach) {
  return std::any_of(site.others.parts.begin(), site.others.parts.end(),
                     [&](const BuiltPart& part) {
                       return part.eaves + part.rise > ground.at(part.center) + kHigh &&
                              ring_distance(site.around, part.ring()) < reach;
                     });
}

void set_truth(const BuiltShape& building, HeightRaster* truth) {
  const Grid& grid = truth->grid;
  for (int row = 0; row < grid.rows; ++row) {
    for (int col = 0; col < grid.cols; ++col) {
      const double height = building.at(grid.center_of(row, col));
      if (std::isfinite(height)) truth->at(row, col) = static_cast<float>(height);
    }
  }
}

}  // namespace

std::string TrainingSceneOptions::check() const {
  if (!(least_gsd >= 0.1 && least_gsd <= 2.0)) return "least_gsd must be in [0.1, 2]";
  if (!(most_gsd >= least_gsd && most_gsd <= 2.0)) return "most_gsd must be in [least_gsd, 2]";
  const auto is_share = [](double share) { return share >= 0.0 && share <= 1.0; };
  if (!is_share(neighbour_share)) return "neighbour_share must be in [0, 1]";
  if (!is_share(tree_share)) return "tree_share must be in [0, 1]";
  if (!is_share(garden_share)) return "garden_share must be in [0, 1]";
  if (!is_share(shed_share)) return "shed_share must be in [0, 1]";
  if (!is_share(car_share)) return "car_share must be in [0, 1]";
  if (!is_share(clutter_share)) return "clutter_share must be in [0, 1]";
  if (!is_share(hole_share)) return "hole_share must be in [0, 1]";
  if (!is_share(smooth_share)) return "smooth_share must be in [0, 1]";
  if (!is_share(off_center_share)) return "off_center_share must be in [0, 1]";
  if (!is_share(outlier_share)) return "outlier_share must be in [0, 1]";
  if (!(most_noise >= 0.0 && most_noise <= 2.0)) return "most_noise must be in [0, 2]";
  if (!(least_noise >= 0.0 && least_noise <= most_noise)) {
    return "least_noise must be in [0, most_noise]";
  }
  if (!(terrain_error >= 0.0 && terrain_error <= 2.0)) return "terrain_error must be in [0, 2]";
  return prior.check();
}

TrainingScene make_training_scene(Foundation foundation, uint64_t seed,
                                  const TrainingSceneOptions& options) {
  assert(options.check().empty());
  // Scenes of different foundations with one seed are nothing alike.
  Random random(Random(seed).next() + static_cast<uint64_t>(foundation));
  // Each has its own generator, so that one share changes nothing of the rest.
  Random for_survey = random.fork(), for_building = random.fork(), for_ground = random.fork();
  Random for_neighbours = random.fork(), for_sheds = random.fork(), for_cars = random.fork();
  Random for_clutter = random.fork(), for_garden = random.fork(), for_trees = random.fork();
  Random for_samples = random.fork(), for_noise = random.fork(), for_holes = random.fork();
  Random for_terrain = random.fork(), for_leaves = random.fork();

  const double gsd = random_gsd(options, &for_survey);
  const Eigen::Vector2d at =
      kPlace + Eigen::Vector2d(for_survey.uniform(0.0, gsd), for_survey.uniform(0.0, gsd));
  // Coarse cells are mostly means of many points.
  const double coarse = gsd >= 0.75 ? 1.6 : 0.8;
  const bool smooth = for_survey.chance(std::min(1.0, coarse * options.smooth_share));
  const bool off_center = for_survey.chance(options.off_center_share);
  SurveySampling sampling = random_sampling(smooth, gsd, &for_survey);
  if (!smooth && !off_center) sampling = SurveySampling();
  const double blend = smooth && for_survey.chance(0.75) ? for_survey.uniform(0.3, 1.0) : 0.0;

  TrainingScene scene;
  Site site;
  const SiteGround ground(at, &for_ground);
  const double floor = ground.at(at);
  place_building(foundation, options, {at.x(), at.y(), floor}, &for_building, &scene, &site);
  const bool is_building = !site.building.parts.empty();
  add_neighbours(scene, floor, options.neighbour_share, &for_neighbours, &site);
  if (for_sheds.chance(options.shed_share)) {
    site.others.append(random_sheds(site.around, ground, &for_sheds));
  }
  const double reach = (1.5 + sampling.reach() + 0.5 * blend) * gsd;
  scene.outline_needed = is_building && is_joined(site, ground, reach);
  if (for_cars.chance(options.car_share)) {
    site.others.append(random_cars(site.around, ground, &for_cars));
    scene.outline_needed |= is_building && is_joined(site, ground, reach);
  }
  if (for_garden.chance(options.garden_share)) {
    plant_garden(site.around, &for_garden, &site.greenery);
  }
  if (is_building && for_trees.chance(options.tree_share)) {
    plant_trees_over_walls(site.around, &for_trees, &site.greenery);
  }
  if (foundation != Foundation::kC && for_clutter.chance(options.clutter_share)) {
    add_roof_clutter(scene.house, &for_clutter, &site.building);
  }

  Box box;
  for (const Eigen::Vector2d& p : site.around) box.add(p, 0.0);
  const Grid grid = grid_around(box, gsd);
  const HeightRaster bare = ground.on(grid);
  scene.truth = HeightRaster(grid, std::numeric_limits<float>::quiet_NaN());
  if (foundation == Foundation::kC) {
    set_truth(site.building, &scene.truth);
  } else {
    HeightRaster with_house = bare;
    rasterise_house(scene.house, &with_house, &scene.truth);
  }
  scene.dtm = bare;
  add_terrain_error(options.terrain_error * for_terrain.uniform(0.0, 1.0), &for_terrain,
                    &scene.dtm);

  scene.dsm = bare;
  sample_built({&site.building, &site.others}, ground, sampling, &for_samples, &scene.dsm);
  add_greenery(site.greenery, bare, &for_leaves, &scene.dsm);
  LidarOptions lidar;
  lidar.noise_range = random_noise_range(options, &for_noise);
  if (blend > 0.0) {
    // Noise before the blend is alike in neighbouring cells; a little comes after it.
    add_survey_noise(lidar, bare, &for_noise, &scene.dsm);
    blend_cells(blend, &scene.dsm);
    lidar.noise_range *= 0.25;
  }
  // Before the outliers, which would cast shadows.
  if (for_holes.chance(options.hole_share)) random_holes(&for_holes, &scene.dsm);
  if (for_noise.chance(options.outlier_share)) lidar.outlier_share = kOutliers;
  add_survey_noise(lidar, bare, &for_noise, &scene.dsm);
  return scene;
}

}  // namespace gable
