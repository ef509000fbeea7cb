#include <gable/grammar/plan_outline.h>
#include <gable/grammar/synthesis/ground/site_ground.h>
#include <gable/grammar/synthesis/ground/surroundings.h>
#include <gable/grammar/synthesis/houses/bent_row.h>
#include <gable/grammar/synthesis/houses/built_shape.h>
#include <gable/grammar/synthesis/houses/complex_shapes.h>
#include <gable/grammar/synthesis/houses/neighbours.h>
#include <gable/grammar/synthesis/houses/plain_house.h>
#include <gable/grammar/synthesis/houses/plan_cut.h>
#include <gable/grammar/synthesis/houses/plan_union.h>
#include <gable/grammar/synthesis/houses/roof_clutter.h>
#include <gable/grammar/synthesis/houses/row_house.h>
#include <gable/grammar/synthesis/houses/training_house.h>
#include <gable/grammar/synthesis/houses/visible_hips.h>
#include <gable/grammar/synthesis/survey/lidar.h>
#include <gable/grammar/synthesis/survey/survey_defects.h>
#include <gable/grammar/synthesis/survey/survey_sampling.h>
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
constexpr double kCoarse = 0.75;      // cells from which on walls are smeared, metres
constexpr double kWholeShare = 0.15;  // cut off at most, or the foundation is none any more
constexpr double kTornShare = 0.22;   // cut off at least where it is none
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
  PlanRing around;          ///< the building's outline, or the box around a grove
  bool in_row = false;      ///< has the neighbours of a row
  bool leans = false;       ///< its roof is not the house's: the truth is the building's
  bool by_outline = false;  ///< cannot be found in the heights
};

void place_house(House house, const Eigen::Vector3d& at, TrainingScene* scene, Site* site) {
  scene->house = std::move(house);
  scene->house.origin = at;
  site->building = shape_of(scene->house);
  scene->outline = world_outline(scene->house);
  scene->footprint = scene->outline;
}

/// Whether the middles of all dormers and chimneys lie inside a ring, world.
bool keeps_details(const House& house, const PlanRing& ring) {
  const Eigen::Vector2d x(std::cos(house.azimuth[0]), std::sin(house.azimuth[0]));
  const Eigen::Vector2d y(-x.y(), x.x());
  const auto all_inside = [&](const std::vector<Rule>& rules) {
    return std::all_of(rules.begin(), rules.end(), [&](const Rule& rule) {
      return inside_ring(ring, house.origin.head<2>() + rule[0] * x + rule[1] * y);
    });
  };
  return all_inside(house.dormers) && all_inside(house.chimneys);
}

double area_of(const PlanPolygon& polygon) { return std::abs(signed_area(polygon.outer)); }

/// Cuts the front or the back of a house's footprint, or both, at least_angle to most_angle
/// degrees, where what is lost lies within the shares and holds no dormer or chimney.
bool cut_footprint(double least_angle, double most_angle, double least_share, double most_share,
                   Random* random, TrainingScene* scene) {
  const double azimuth = scene->house.azimuth[0];
  const Eigen::Vector2d back(-std::sin(azimuth), std::cos(azimuth));
  const double area = area_of(scene->outline);
  for (int attempt = 0; attempt < 6; ++attempt) {
    const double angle = random->uniform(least_angle, most_angle) * M_PI / 180.0;
    const bool left = random->chance(0.5), front = random->chance(0.7), both = random->chance(0.3);
    PlanPolygon cut = scene->outline;
    if (front || both) cut = cut_obliquely(cut, -back, angle, left);
    if (!front || both) cut = cut_obliquely(cut, back, angle, left);
    const double lost = 1.0 - area_of(cut) / area;
    if (cut.outer.size() < 3 || lost < least_share || lost > most_share) continue;
    if (!keeps_details(scene->house, cut.outer)) continue;
    scene->footprint = std::move(cut);
    return true;
  }
  return false;
}

void place_row_house(Foundation foundation, double gsd, double oblique_share,
                     const Eigen::Vector3d& at, Random* random, TrainingScene* scene, Site* site) {
  place_house(random_row_house(foundation, gsd, random), at, scene, site);
  site->others.append(random_row_beside(scene->house, random));
  site->in_row = true;
  if (!random->chance(oblique_share)) return;
  site->by_outline = cut_footprint(10.0, 25.0, 0.0, kWholeShare, random, scene);
}

/// A slice of a row, or a shed, of which too much is cut off to be a rectangle.
bool place_torn_house(double gsd, const Eigen::Vector3d& at, Random* random, TrainingScene* scene,
                      Site* site) {
  // Those of real registers are mostly sheds and flat.
  const bool shed = random->chance(0.45);
  const Foundation of = random->chance(0.6) ? Foundation::kI : Foundation::kII;
  House house = shed ? random_plain_house(PlainKind::kOuthouse, gsd, random)
                     : random_row_house(of, gsd, random);
  place_house(std::move(house), at, scene, site);
  if (!cut_footprint(25.0, 55.0, kTornShare, 0.6, random, scene)) return false;
  if (!shed) site->others.append(random_row_beside(scene->house, random));
  site->in_row = site->by_outline = true;
  return true;
}

void place_plain_house(double gsd, const Eigen::Vector3d& at, Random* random, TrainingScene* scene,
                       Site* site) {
  const double kind = random->uniform(0.0, 1.0);
  const PlainKind plain = kind < 0.45   ? PlainKind::kHouse
                          : kind < 0.70 ? PlainKind::kTerrace
                                        : PlainKind::kOuthouse;
  place_house(random_plain_house(plain, gsd, random), at, scene, site);
  if (plain != PlainKind::kOuthouse) return;
  // What is smaller than most buildings is one by its footprint only.
  site->by_outline = true;
  if (random->chance(0.4)) {
    tilt_flat_roof(random, &site->building);
    site->leans = true;
  }
}

/// A house of the given foundation, not kC.
void place_any_house(Foundation foundation, double gsd, const TrainingSceneOptions& options,
                     const Eigen::Vector3d& at, Random* random, TrainingScene* scene, Site* site) {
  const bool free_blocks = foundation != Foundation::kL && foundation != Foundation::kU;
  const double row_share = gsd < kCoarse ? options.row_share : 0.4 * options.row_share;
  if (free_blocks && random->chance(foundation == Foundation::kIII ? 0.5 * row_share : row_share)) {
    place_row_house(foundation, gsd, options.oblique_share, at, random, scene, site);
    return;
  }
  if (foundation == Foundation::kI && random->chance(options.plain_share)) {
    place_plain_house(gsd, at, random, scene, site);
    return;
  }
  House house = random_training_house(foundation, random, options.prior);
  // Where walls are smeared, hips are labels that hardly show.
  const double gable_share = std::min(1.0, (gsd < kCoarse ? 1.0 : 1.6) * options.gable_share);
  const bool no_hips = free_blocks && random->chance(gable_share);
  drop_short_hips(no_hips ? std::numeric_limits<double>::infinity() : options.least_hip_cells * gsd,
                  &house);
  place_house(std::move(house), at, scene, site);
}

void place_building(Foundation foundation, double gsd, const TrainingSceneOptions& options,
                    const Eigen::Vector3d& at, Random* random, TrainingScene* scene, Site* site) {
  scene->foundation = foundation;
  if (foundation != Foundation::kC) {
    place_any_house(foundation, gsd, options, at, random, scene, site);
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
  } else if (!random->chance(options.torn_share) ||
             !place_torn_house(gsd, at, random, scene, site)) {
    site->building = random->chance(options.bent_share)
                         ? random_bent_row(std::clamp(100.0 * gsd, 30.0, 100.0), random)
                         : random_complex(random);
    site->building.move(at);
    scene->outline = outline_of(site->building);
    scene->footprint = scene->outline;
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
  if (is_building && !site->in_row && random->chance(share)) {
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
  if (!is_share(row_share)) return "row_share must be in [0, 1]";
  if (!is_share(oblique_share)) return "oblique_share must be in [0, 1]";
  if (!is_share(plain_share)) return "plain_share must be in [0, 1]";
  if (!is_share(gable_share)) return "gable_share must be in [0, 1]";
  if (!is_share(bent_share)) return "bent_share must be in [0, 1]";
  if (!is_share(torn_share)) return "torn_share must be in [0, 1]";
  if (!(least_hip_cells >= 0.0 && least_hip_cells <= 4.0)) {
    return "least_hip_cells must be in [0, 4]";
  }
  if (!(footprint_error >= 0.0 && footprint_error <= 1.0)) {
    return "footprint_error must be in [0, 1]";
  }
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
  Random for_footprint = random.fork();

  const double gsd = random_gsd(options, &for_survey);
  const Eigen::Vector2d at =
      kPlace + Eigen::Vector2d(for_survey.uniform(0.0, gsd), for_survey.uniform(0.0, gsd));
  // Coarse cells are mostly means of many points.
  const double coarse = gsd >= kCoarse ? 1.6 : 0.8;
  const bool smooth = for_survey.chance(std::min(1.0, coarse * options.smooth_share));
  const bool off_center = for_survey.chance(options.off_center_share);
  SurveySampling sampling = random_sampling(smooth, gsd, &for_survey);
  if (!smooth && !off_center) sampling = SurveySampling();
  const double blend = smooth && for_survey.chance(0.75) ? for_survey.uniform(0.3, 1.0) : 0.0;

  TrainingScene scene;
  Site site;
  const SiteGround ground(at, &for_ground);
  const double floor = ground.at(at);
  place_building(foundation, gsd, options, {at.x(), at.y(), floor}, &for_building, &scene, &site);
  const bool is_building = !site.building.parts.empty();
  add_neighbours(scene, floor, options.neighbour_share, &for_neighbours, &site);
  if (for_sheds.chance(options.shed_share)) {
    site.others.append(random_sheds(site.around, ground, &for_sheds));
  }
  const double reach = (1.5 + sampling.reach() + 0.5 * blend) * gsd;
  scene.outline_needed = is_building && (site.by_outline || is_joined(site, ground, reach));
  if (is_building && options.footprint_error > 0.0) {
    scene.footprint = register_outline(scene.footprint, options.footprint_error, &for_footprint);
  }
  if (for_cars.chance(options.car_share)) {
    site.others.append(random_cars(site.around, ground, &for_cars));
    scene.outline_needed |= is_building && is_joined(site, ground, reach);
  }
  if (for_garden.chance(std::min(1.0, (gsd < kCoarse ? 1.0 : 1.35) * options.garden_share))) {
    plant_garden(site.around, &for_garden, &site.greenery);
  }
  if (is_building && for_trees.chance(options.tree_share)) {
    plant_trees_over_walls(site.around, &for_trees, &site.greenery);
  }
  if (foundation != Foundation::kC && !site.leans && for_clutter.chance(options.clutter_share)) {
    add_roof_clutter(scene.house, &for_clutter, &site.building);
  }

  Box box;
  for (const Eigen::Vector2d& p : site.around) box.add(p, 0.0);
  const Grid grid = grid_around(box, gsd);
  const HeightRaster bare = ground.on(grid);
  scene.truth = HeightRaster(grid, std::numeric_limits<float>::quiet_NaN());
  if (foundation == Foundation::kC || site.leans) {
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
