#include <gable/grammar/height_field.h>
#include <gable/grammar/plan_outline.h>
#include <gable/grammar/synthesis/complex_shapes.h>
#include <gable/grammar/synthesis/lidar.h>
#include <gable/grammar/synthesis/plot.h>
#include <gable/grammar/synthesis/training_scene.h>
#include <gable/grammar/synthesis/vegetation.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace gable {
namespace {

constexpr double kMargin = 8.0;  // of the raster around the building, metres
const Eigen::Vector2d kPlace(400000.0, 200000.0);

/// Half of the surveys have cells of 0.5 or of 1 m where these are allowed.
double random_gsd(const TrainingSceneOptions& options, Random* random) {
  const double kind = random->uniform(0.0, 1.0);
  const double any = random->uniform(options.least_gsd, options.most_gsd);
  const double common = kind < 0.35 ? 0.5 : (kind < 0.7 ? 1.0 : any);
  return common >= options.least_gsd && common <= options.most_gsd ? common : any;
}

double ring_area(const std::vector<Eigen::Vector2d>& ring) {
  double twice = 0.0;
  for (size_t k = 0; k < ring.size(); ++k) {
    const Eigen::Vector2d& a = ring[k];
    const Eigen::Vector2d& b = ring[(k + 1) % ring.size()];
    twice += a.x() * b.y() - a.y() * b.x();
  }
  return 0.5 * twice;
}

/// The largest piece of a house's outline, world.
PlanPolygon world_outline(const House& house) {
  PlanPolygon largest;
  for (PlanPolygon& polygon : plan_outline(house)) {
    if (largest.outer.empty() || ring_area(polygon.outer) > ring_area(largest.outer)) {
      largest = std::move(polygon);
    }
  }
  for (auto& p : largest.outer) p += house.origin.head<2>();
  for (auto& hole : largest.holes) {
    for (auto& p : hole) p += house.origin.head<2>();
  }
  return largest;
}

struct Box {
  Eigen::Vector2d low, high;
};

Box box_of(const PlanPolygon& polygon) {
  Box box{polygon.outer.front(), polygon.outer.front()};
  for (const auto& p : polygon.outer) {
    box.low = box.low.cwiseMin(p);
    box.high = box.high.cwiseMax(p);
  }
  return box;
}

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

/// Gentle ground: a plane and a slight bend.
class Ground {
 public:
  Ground(const Eigen::Vector2d& center, Random* random) : center_(center) {
    height_ = random->uniform(5.0, 150.0);
    const double downhill = random->uniform(0.0, 2.0 * M_PI);
    const double steepness = random->uniform(0.0, 1.0) * random->uniform(0.0, 0.1);
    gradient_ = steepness * Eigen::Vector2d(std::cos(downhill), std::sin(downhill));
    const double bend = random->uniform(0.0, 2.0 * M_PI);
    bend_ = Eigen::Vector2d(std::cos(bend), std::sin(bend));
    curvature_ = random->uniform(-0.0005, 0.0005);
  }
  double at(const Eigen::Vector2d& world) const {
    const Eigen::Vector2d p = world - center_;
    const double along = bend_.dot(p);
    return height_ + gradient_.dot(p) + curvature_ * along * along;
  }

 private:
  Eigen::Vector2d center_, gradient_, bend_;
  double height_ = 0.0, curvature_ = 0.0;
};

void lay_ground(const Ground& ground, HeightRaster* raster) {
  for (int row = 0; row < raster->grid.rows; ++row) {
    for (int col = 0; col < raster->grid.cols; ++col) {
      raster->at(row, col) = static_cast<float>(ground.at(raster->grid.center_of(row, col)));
    }
  }
}

/// Trees whose crowns reach over the outline's walls by up to a metre.
void plant_trees(const House& house, Random* random, TrainingScene* scene) {
  const Plot plot(house);
  const int count = random->integer(1, 3);
  for (int i = 0; i < count; ++i) {
    const double direction = random->uniform(0.0, 2.0 * M_PI);
    const Eigen::Vector2d outward(std::cos(direction), std::sin(direction));
    Tree tree = random_tree(Eigen::Vector2d::Zero(), random);
    const double away = plot.edge_towards(outward) + tree.radius + random->uniform(-1.0, 1.5);
    tree.center = house.origin.head<2>() + away * outward;
    add_tree(tree, scene->dtm, random, &scene->dsm);
  }
}

/// A grove: what is high and no building.
void plant_grove(Random* random, const Box& box, TrainingScene* scene) {
  const int count = random->integer(1, 7);
  for (int i = 0; i < count; ++i) {
    const Eigen::Vector2d at(random->uniform(box.low.x(), box.high.x()),
                             random->uniform(box.low.y(), box.high.y()));
    Tree tree = random_tree(i == 0 ? scene->center : at, random);
    if (i == 0) tree.radius = std::max(tree.radius, 3.0);
    tree.height = std::max(tree.height, 5.0);
    add_tree(tree, scene->dtm, random, &scene->dsm);
  }
}

}  // namespace

std::string TrainingSceneOptions::check() const {
  if (!(least_gsd >= 0.1 && least_gsd <= 2.0)) return "least_gsd must be in [0.1, 2]";
  if (!(most_gsd >= least_gsd && most_gsd <= 2.0)) return "most_gsd must be in [least_gsd, 2]";
  const auto is_share = [](double share) { return share >= 0.0 && share <= 1.0; };
  if (!is_share(neighbour_share)) return "neighbour_share must be in [0, 1]";
  if (!is_share(tree_share)) return "tree_share must be in [0, 1]";
  if (!is_share(car_share)) return "car_share must be in [0, 1]";
  if (!is_share(hole_share)) return "hole_share must be in [0, 1]";
  if (!is_share(smooth_share)) return "smooth_share must be in [0, 1]";
  if (!(terrain_error >= 0.0 && terrain_error <= 2.0)) return "terrain_error must be in [0, 2]";
  return prior.check();
}

TrainingScene make_training_scene(Foundation foundation, uint64_t seed,
                                  const TrainingSceneOptions& options) {
  assert(options.check().empty());
  Random random(seed);
  Random for_survey = random.fork(), for_building = random.fork(), for_ground = random.fork();
  Random for_trees = random.fork();
  const double gsd = random_gsd(options, &for_survey);

  TrainingScene scene;
  scene.foundation = foundation;
  const Eigen::Vector2d at =
      kPlace + Eigen::Vector2d(for_survey.uniform(0.0, gsd), for_survey.uniform(0.0, gsd));
  const Ground ground(at, &for_ground);
  const bool is_grove = foundation == Foundation::kC && for_building.chance(0.35);
  Box box{at - Eigen::Vector2d::Constant(6.0), at + Eigen::Vector2d::Constant(6.0)};
  scene.center = at;
  if (!is_grove) {
    scene.house = foundation == Foundation::kC
                      ? random_composite(&for_building)
                      : random_house(foundation, &for_building, options.prior);
    scene.house.origin = {at.x(), at.y(), ground.at(at)};
    scene.outline = world_outline(scene.house);
    box = box_of(scene.outline);
    const HeightField field(scene.house);
    const Block<double>& first = field.blocks()[0];
    using namespace block_value;
    scene.center = at + field.local_from_house(
                            {0.5 * (first[kX0] + first[kX1]), 0.5 * (first[kY0] + first[kY1])});
  }
  const Grid grid = grid_around(box, gsd);
  scene.dtm = HeightRaster(grid, 0.0f);
  lay_ground(ground, &scene.dtm);
  scene.dsm = scene.dtm;
  scene.truth = HeightRaster(grid, std::numeric_limits<float>::quiet_NaN());
  if (is_grove) {
    plant_grove(&for_trees, box, &scene);
  } else {
    rasterise_house(scene.house, &scene.dsm, &scene.truth);
    if (for_trees.chance(options.tree_share)) plant_trees(scene.house, &for_trees, &scene);
  }
  LidarOptions lidar;
  lidar.noise_range = 0.02 * std::pow(15.0, for_survey.uniform(0.0, 1.0));
  add_survey_noise(lidar, scene.dtm, &for_survey, &scene.dsm);
  return scene;
}

}  // namespace gable
