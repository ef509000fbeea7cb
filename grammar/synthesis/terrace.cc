#include <gable/grammar/block.h>
#include <gable/grammar/plan_outline.h>
#include <gable/grammar/random.h>
#include <gable/grammar/ring.h>
#include <gable/grammar/synthesis/houses/rectangle.h>
#include <gable/grammar/synthesis/houses/row_house.h>
#include <gable/grammar/synthesis/terrace.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cassert>
#include <cmath>

namespace gable {
namespace {

// Levels of houses against the first, metres: none sinks into the ground.
constexpr double kLowest = -1.0, kHighest = 2.5;

// The rasters' outer corner is anywhere within a cell of this.
const Eigen::Vector2d kPlace(400000.0, 200000.0);

double random_sign(Random* random) { return random->chance(0.5) ? 1.0 : -1.0; }

double random_step(Random* random) {
  const double kind = random->uniform(0.0, 1.0);
  if (kind < 0.5) return 0.0;
  const double step = kind < 0.85 ? random->uniform(0.1, 0.6) : random->uniform(0.6, 2.5);
  return random_sign(random) * step;
}

std::vector<House> draw_houses(const TerraceOptions& options, Random* random) {
  const Foundation foundation = random->chance(1.0 / 3.0) ? Foundation::kII : Foundation::kI;
  const House pattern = random_row_house(foundation, options.gsd, random);
  const double width = rectangle_of(expand_blocks(pattern)[0]).size_x();
  const Eigen::Vector2d x(std::cos(pattern.azimuth[0]), std::sin(pattern.azimuth[0]));
  const Eigen::Vector2d y(-x.y(), x.x());
  std::vector<House> houses;
  Eigen::Vector3d at(kPlace.x(), kPlace.y(), 0.0);
  for (int i = 0; i < options.count; ++i) {
    House house = pattern;
    if (random->chance(0.5)) house.dormers.clear();
    if (random->chance(0.6)) house.garages.clear();
    if (random->chance(0.5)) house.chimneys.clear();
    house.origin = at;
    houses.push_back(house);
    const double aside =
        random->chance(0.6) ? 0.0 : random->uniform(0.3, 1.5) * random_sign(random);
    at.head<2>() += width * x + aside * y;
    at.z() = std::clamp(at.z() + random_step(random), kLowest, kHighest);
  }
  return houses;
}

/// The largest piece of a house's outline, world.
PlanPolygon footprint_of(const House& house) {
  std::vector<PlanPolygon> pieces = plan_outline(house);
  PlanPolygon& largest = *std::max_element(
      pieces.begin(), pieces.end(),
      [](const auto& a, const auto& b) { return signed_area(a.outer) < signed_area(b.outer); });
  for (Eigen::Vector2d& p : largest.outer) p += house.origin.head<2>();
  for (auto& hole : largest.holes) {
    for (Eigen::Vector2d& p : hole) p += house.origin.head<2>();
  }
  return largest;
}

}  // namespace

std::string TerraceOptions::check() const {
  if (count < 1) return "count must be >= 1";
  if (!(gsd >= 0.1 && gsd <= 2.0)) return "gsd must be in [0.1, 2]";
  if (!(margin >= 0.0)) return "margin must be >= 0";
  return lidar.check();
}

Terrace make_terrace(const TerraceOptions& options) {
  assert(options.check().empty());
  Random random(options.seed);
  Terrace terrace;
  terrace.houses = draw_houses(options, &random);
  Eigen::AlignedBox2d box;
  for (const House& house : terrace.houses) {
    terrace.footprints.push_back(footprint_of(house));
    for (const Eigen::Vector2d& p : terrace.footprints.back().outer) box.extend(p);
  }
  Grid grid;
  grid.gsd = options.gsd;
  grid.north_west =
      Eigen::Vector2d(box.min().x() - options.margin, box.max().y() + options.margin) +
      options.gsd * Eigen::Vector2d(-random.uniform(0.0, 1.0), random.uniform(0.0, 1.0));
  const Eigen::Vector2d size = box.sizes() + Eigen::Vector2d::Constant(2.0 * options.margin);
  grid.cols = static_cast<int>(std::ceil(size.x() / options.gsd)) + 1;
  grid.rows = static_cast<int>(std::ceil(size.y() / options.gsd)) + 1;
  terrace.dtm = HeightRaster(grid, 0.0f);
  terrace.dsm = terrace.dtm;
  for (const House& house : terrace.houses) rasterise_house(house, &terrace.dsm);
  add_survey_noise(options.lidar, terrace.dtm, &random, &terrace.dsm);
  return terrace;
}

}  // namespace gable
