#include <gable/grammar/height_field.h>
#include <gable/grammar/synthesis/houses/rectangle.h>
#include <gable/grammar/synthesis/scene.h>

#include <cassert>
#include <cmath>

namespace gable {
namespace {

/// A tree whose crown reaches over the house's outline by 0 to 1 m.
Tree random_tree_beside(const HeightField& field, const House& house, Random* random) {
  const double direction = random->uniform(0.0, 2.0 * M_PI);
  const Eigen::Vector2d outward(std::cos(direction), std::sin(direction));
  double edge = 0.0;  // the last point of the house in that direction
  for (double t = 0.0; t < 40.0; t += 0.1) {
    if (field.block_at_house(field.house_from_local(t * outward)) >= 0) edge = t;
  }
  Tree tree = random_tree(Eigen::Vector2d::Zero(), random);
  tree.center = house.origin.head<2>() + (edge + tree.radius - random->uniform(0.0, 1.0)) * outward;
  return tree;
}

/// Centre of the house with its garages, local frame.
Eigen::Vector2d plan_center(const House& house) {
  const HeightField field(house);
  Rectangle box = rectangle_of(field.blocks()[0]);
  for (const Block<double>& block : field.blocks()) box = bounds(box, rectangle_of(block));
  return field.local_from_house({box.mid_x(), box.mid_y()});
}

Scene make_scene(House house, const SceneOptions& options, Random* random) {
  assert(options.check().empty());
  Grid grid;
  grid.gsd = options.gsd;
  grid.rows = grid.cols = options.size;
  const double extent = options.size * options.gsd;
  grid.north_west = {400000.0 - 0.5 * extent, 200000.0 + 0.5 * extent};
  const Eigen::Vector2d center(400000.0, 200000.0);

  const double steepness = random->uniform(0.0, options.slope);
  const double downhill = random->uniform(0.0, 2.0 * M_PI);
  const Eigen::Vector2d gradient =
      steepness * Eigen::Vector2d(std::cos(downhill), std::sin(downhill));
  const auto terrain = [&](const Eigen::Vector2d& world) {
    return 80.0 + gradient.dot(world - center);
  };
  const double off_east = random->uniform(-options.off_center, options.off_center);
  const double off_north = random->uniform(-options.off_center, options.off_center);
  house.origin.head<2>() = center + Eigen::Vector2d(off_east, off_north) - plan_center(house);
  house.origin.z() = terrain(house.origin.head<2>());

  Scene scene;
  scene.house = house;
  scene.dtm = HeightRaster(grid, 0.0f);
  for (int row = 0; row < grid.rows; ++row) {
    for (int col = 0; col < grid.cols; ++col) {
      scene.dtm.at(row, col) = static_cast<float>(terrain(grid.center_of(row, col)));
    }
  }
  scene.truth = scene.dtm;
  rasterise_house(house, &scene.truth);
  scene.dsm = scene.truth;
  const HeightField field(house);
  for (int i = 0; i < options.trees; ++i) {
    scene.trees.push_back(random_tree_beside(field, house, random));
    add_tree(scene.trees.back(), scene.dtm, random, &scene.dsm);
  }
  add_survey_noise(options.lidar, scene.dtm, random, &scene.dsm);
  return scene;
}

}  // namespace

std::string SceneOptions::check() const {
  if (!(size >= 8)) return "size must be >= 8";
  if (!(gsd > 0.0)) return "gsd must be > 0";
  if (!(trees >= 0)) return "trees must be >= 0";
  if (!(slope >= 0.0)) return "slope must be >= 0";
  if (!(off_center >= 0.0)) return "off_center must be >= 0";
  const std::string in_lidar = lidar.check();
  return in_lidar.empty() ? prior.check() : in_lidar;
}

Scene make_scene(Foundation foundation, const SceneOptions& options) {
  Random random(options.seed);
  const House house = random_house(foundation, &random, options.prior);
  return make_scene(house, options, &random);
}

Scene make_scene(const House& house, const SceneOptions& options) {
  Random random(options.seed);
  return make_scene(house, options, &random);
}

}  // namespace gable
