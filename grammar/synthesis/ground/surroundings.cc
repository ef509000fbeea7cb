#include <gable/grammar/synthesis/ground/surroundings.h>
#include <gable/grammar/synthesis/houses/plan_union.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace gable {
namespace {

/// A point of a building's wall and the way out.
struct WallPoint {
  Eigen::Vector2d at, outward;
};

/// Anywhere on the outline, which runs anticlockwise, by length.
WallPoint random_wall_point(const PlanRing& outline, Random* random) {
  double length = 0.0;
  const auto edge = [&](size_t k) {
    return Eigen::Vector2d(outline[(k + 1) % outline.size()] - outline[k]);
  };
  for (size_t k = 0; k < outline.size(); ++k) length += edge(k).norm();
  double left = random->uniform(0.0, length);
  size_t k = 0;
  while (k + 1 < outline.size() && left > edge(k).norm()) left -= edge(k++).norm();
  const Eigen::Vector2d along = edge(k).normalized();
  return {outline[k] + left * along, {along.y(), -along.x()}};
}

double distance_from(const PlanRing& outline, const Eigen::Vector2d& p) {
  const PlanRing point = {p, p, p};
  return ring_distance(outline, point);
}

/// A box that stands on the ground.
BuiltPart box_at(const Eigen::Vector2d& center, const Eigen::Vector2d& along, double length,
                 double width, double top) {
  BuiltPart part;
  part.center = center;
  part.along = along;
  part.half_length = 0.5 * length;
  part.half_width = 0.5 * width;
  part.eaves = top;
  return part;
}

/// A direction that is often that of the wall.
Eigen::Vector2d random_direction(const WallPoint& wall, Random* random) {
  const double off = random->chance(0.6) ? random->normal(0.06) : random->uniform(0.0, M_PI);
  const bool across = random->chance(0.5);
  const double angle =
      std::atan2(wall.outward.y(), wall.outward.x()) + off + (across ? 0.5 * M_PI : 0.0);
  return {std::cos(angle), std::sin(angle)};
}

bool keeps_clear(const BuiltPart& part, const PlanRing& outline, double gap) {
  return ring_distance(outline, part.ring()) >= gap;
}

Tree free_tree(const Eigen::Vector2d& center, Random* random) {
  if (random->chance(0.75)) return random_tree(center, random);
  Tree tree;
  tree.center = center;
  tree.radius = random->uniform(2.5, 6.0);
  tree.height = tree.radius * random->uniform(1.6, 3.4);
  return tree;
}

Hedge random_hedge(const Eigen::Vector2d& from, const Eigen::Vector2d& to, Random* random) {
  Hedge hedge;
  hedge.from = from;
  hedge.to = to;
  if (random->chance(0.35)) {  // a wall or a fence
    hedge.width = random->uniform(0.25, 0.45);
    hedge.height = random->uniform(1.2, 2.0);
  } else {
    hedge.width = random->uniform(0.6, 1.8);
    hedge.height = random->uniform(0.7, 1.9);
  }
  return hedge;
}

}  // namespace

BuiltShape random_cars(const PlanRing& outline, const SiteGround& ground, Random* random) {
  BuiltShape cars;
  const int wanted = random->integer(1, 3);
  for (int i = 0; i < wanted; ++i) {
    const WallPoint wall = random_wall_point(outline, random);
    const double away = random->uniform(1.7, 6.0);
    const Eigen::Vector2d center = wall.at + away * wall.outward;
    const Eigen::Vector2d along = random_direction(wall, random);
    const double floor = ground.at(center);
    const bool is_van = random->chance(0.12);
    const double length = is_van ? random->uniform(4.8, 5.6) : random->uniform(3.9, 5.0);
    const double width = is_van ? random->uniform(1.9, 2.05) : random->uniform(1.7, 1.95);
    const double top = floor + (is_van ? random->uniform(1.9, 2.4) : 0.9);
    const BuiltPart body = box_at(center, along, length, width, top);
    if (!keeps_clear(body, outline, 0.7)) continue;
    cars.parts.push_back(body);
    if (is_van) continue;
    cars.parts.push_back(box_at(center - 0.08 * length * along, along, 0.55 * length, 0.9 * width,
                                floor + random->uniform(1.4, 1.65)));
  }
  return cars;
}

BuiltShape random_sheds(const PlanRing& outline, const SiteGround& ground, Random* random) {
  BuiltShape sheds;
  const int wanted = random->integer(1, 3);
  for (int i = 0; i < wanted; ++i) {
    const WallPoint wall = random_wall_point(outline, random);
    const double gap = random->chance(0.33) ? random->uniform(0.5, 1.5) : random->uniform(1.5, 6.0);
    const double length = random->uniform(1.8, 4.0);
    const double width = random->uniform(1.5, 3.0);
    const Eigen::Vector2d along = random_direction(wall, random);
    const double half =
        0.5 * (std::abs(along.dot(wall.outward)) * length +
               std::abs(along.x() * wall.outward.y() - along.y() * wall.outward.x()) * width);
    const Eigen::Vector2d center = wall.at + (gap + half) * wall.outward;
    const double top = random->uniform(2.0, 2.6);
    BuiltPart shed = box_at(center, along, length, width, ground.at(center) + top);
    if (random->chance(0.6)) {
      shed.form = random->chance(0.5) ? PartForm::kGable : PartForm::kMono;
      shed.rise = random->uniform(0.2, 0.6);
      shed.eaves -= shed.rise;
    }
    if (keeps_clear(shed, outline, 0.4)) sheds.parts.push_back(shed);
  }
  return sheds;
}

void plant_trees_over_walls(const PlanRing& outline, Random* random, Greenery* greenery) {
  const int count = random->integer(1, 3);
  for (int i = 0; i < count; ++i) {
    const WallPoint wall = random_wall_point(outline, random);
    Tree tree = free_tree(wall.at, random);
    const double over =
        random->chance(0.85) ? random->uniform(0.0, 1.0) : random->uniform(1.0, 2.2);
    // At a corner that points inwards another wall may be nearer.
    double away = tree.radius - over;
    for (int step = 0; step < 8; ++step) {
      tree.center = wall.at + away * wall.outward;
      const double missing = tree.radius - over - distance_from(outline, tree.center);
      if (missing < 0.05) {
        greenery->trees.push_back(tree);
        break;
      }
      away += missing;
    }
  }
}

void plant_garden(const PlanRing& outline, Random* random, Greenery* greenery) {
  const int trees = random->integer(0, 4);
  for (int i = 0; i < trees; ++i) {
    const WallPoint wall = random_wall_point(outline, random);
    const Tree tree = free_tree(wall.at + random->uniform(3.0, 11.0) * wall.outward, random);
    if (distance_from(outline, tree.center) > 1.15 * tree.radius + 0.7) {
      greenery->trees.push_back(tree);
    }
  }
  const double dense = random->uniform(0.0, 1.0);
  const int shrubs = dense < 0.15   ? random->integer(60, 140)
                     : dense < 0.45 ? random->integer(15, 60)
                                    : random->integer(0, 12);
  for (int i = 0; i < shrubs; ++i) {
    const WallPoint wall = random_wall_point(outline, random);
    Tree shrub;
    shrub.center = wall.at + random->uniform(0.6, 9.0) * wall.outward;
    shrub.radius = random->uniform(0.4, 1.3);
    shrub.height = random->uniform(0.5, 2.3);
    if (distance_from(outline, shrub.center) > shrub.radius + 0.1) {
      greenery->trees.push_back(shrub);
    }
  }
  const int hedges = random->integer(0, 4);
  for (int i = 0; i < hedges; ++i) {
    const WallPoint wall = random_wall_point(outline, random);
    const Eigen::Vector2d along(-wall.outward.y(), wall.outward.x());
    const bool leads_away = random->chance(0.5);
    const bool at_wall = leads_away && random->chance(0.5);
    const double near = at_wall      ? 0.05
                        : leads_away ? random->uniform(0.9, 2.0)
                                     : random->uniform(1.5, 7.0);
    const Eigen::Vector2d from = wall.at + near * wall.outward;
    const double length = random->uniform(4.0, 14.0);
    const Eigen::Vector2d to = leads_away ? Eigen::Vector2d(from + length * wall.outward)
                                          : Eigen::Vector2d(from + length * along);
    const Hedge hedge = random_hedge(from, to, random);
    const PlanRing strip = {from, to, to};
    if (ring_distance(outline, strip) > (at_wall ? 0.0 : 0.5 * hedge.width + 0.3)) {
      greenery->hedges.push_back(hedge);
    }
  }
}

Greenery random_grove(const Eigen::Vector2d& center, Random* random) {
  Greenery grove;
  const double kind = random->uniform(0.0, 1.0);
  const double direction = random->uniform(0.0, 2.0 * M_PI);
  const Eigen::Vector2d along(std::cos(direction), std::sin(direction));
  if (kind < 0.25) {  // one tree
    grove.trees.push_back(free_tree(center, random));
    grove.trees[0].radius = std::max(grove.trees[0].radius, 2.8);
  } else if (kind < 0.65) {  // a grove
    const double spread = random->uniform(2.0, 9.0);
    const int count = random->integer(3, 9);
    for (int i = 0; i < count; ++i) {
      const double away = i == 0 ? 0.0 : spread * std::sqrt(random->uniform(0.0, 1.0));
      const double angle = random->uniform(0.0, 2.0 * M_PI);
      grove.trees.push_back(
          free_tree(center + away * Eigen::Vector2d(std::cos(angle), std::sin(angle)), random));
    }
  } else if (kind < 0.82) {  // a row
    const int count = random->integer(3, 6);
    const double spacing = random->uniform(2.0, 5.0);
    const Tree like = free_tree(center, random);
    for (int i = 0; i < count; ++i) {
      Tree tree = like;
      tree.center = center + (i - count / 2) * spacing * along;
      tree.radius *= random->uniform(0.8, 1.2);
      tree.height *= random->uniform(0.8, 1.2);
      grove.trees.push_back(tree);
    }
  } else {  // tall hedges
    const int count = random->integer(1, 3);
    Eigen::Vector2d from = center - 5.0 * along;
    for (int i = 0; i < count; ++i) {
      const double turn = direction + (i == 0 ? 0.0 : random->uniform(-1.7, 1.7));
      Hedge hedge;
      hedge.from = from;
      hedge.to =
          from + random->uniform(6.0, 12.0) * Eigen::Vector2d(std::cos(turn), std::sin(turn));
      hedge.width = random->uniform(1.6, 3.5);
      hedge.height = random->uniform(2.3, 5.0);
      from = hedge.to;
      grove.hedges.push_back(hedge);
    }
  }
  for (Tree& tree : grove.trees) tree.height = std::max(tree.height, 4.0);
  return grove;
}

void add_greenery(const Greenery& greenery, const HeightRaster& ground, Random* random,
                  HeightRaster* surface) {
  for (const Hedge& hedge : greenery.hedges) add_hedge(hedge, ground, random, surface);
  for (const Tree& tree : greenery.trees) add_tree(tree, ground, random, surface);
}

}  // namespace gable
