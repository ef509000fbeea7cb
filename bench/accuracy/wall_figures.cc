#include "wall_figures.h"

#include <gable/grammar/height_field.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdio>

namespace gable {
namespace {

constexpr double kStep = 0.05;

bool covers(const HeightField& field, const Eigen::Vector2d& p) {
  using namespace block_value;
  for (size_t i = 0; i < field.blocks().size(); ++i) {
    const Block<double>& b = field.blocks()[i];
    if (stands_on_roof(field.sources()[i].role)) continue;
    if (p.x() > b[kX0] && p.x() < b[kX1] && p.y() > b[kY0] && p.y() < b[kY1]) return true;
  }
  return false;
}

Eigen::AlignedBox2d box_of(const House& house, const HeightField& field) {
  using namespace block_value;
  Eigen::AlignedBox2d box;
  for (const Block<double>& b : field.blocks()) {
    for (double x : {b[kX0], b[kX1]}) {
      for (double y : {b[kY0], b[kY1]}) {
        box.extend(field.local_from_house({x, y}) + house.origin.head<2>());
      }
    }
  }
  return box;
}

double shared_area(const House& a, const House& b) {
  const HeightField field_a(a), field_b(b);
  const Eigen::AlignedBox2d box = box_of(a, field_a).intersection(box_of(b, field_b));
  if (box.isEmpty()) return 0.0;
  size_t both = 0;
  for (double x = box.min().x(); x < box.max().x(); x += kStep) {
    for (double y = box.min().y(); y < box.max().y(); y += kStep) {
      const Eigen::Vector2d p(x, y);
      both += covers(field_a, field_a.house_from_local(p - a.origin.head<2>())) &&
              covers(field_b, field_b.house_from_local(p - b.origin.head<2>()));
    }
  }
  return static_cast<double>(both) * kStep * kStep;
}

}  // namespace

WallFigures wall_figures(const std::vector<const House*>& houses) {
  WallFigures figures;
  for (const NeighbourRelation& relation : detect_neighbour_relations(houses, {})) {
    if (relation.kind != NeighbourRelationKind::kPartyWall) continue;
    const WallContact contact = wall_contact(*houses[relation.house_a], relation.wall_a,
                                             *houses[relation.house_b], relation.wall_b);
    ++figures.walls;
    figures.closed += misfit(houses, relation) < 0.02;
    figures.gap += 0.5 * contact.length *
                   (std::max(0.0, contact.offset_from) + std::max(0.0, contact.offset_to));
  }
  for (size_t a = 0; a < houses.size(); ++a) {
    for (size_t b = a + 1; b < houses.size(); ++b) {
      if ((houses[a]->origin - houses[b]->origin).head<2>().norm() > 200.0) continue;
      figures.overlap += shared_area(*houses[a], *houses[b]);
    }
  }
  return figures;
}

std::string text_of(const WallFigures& figures) {
  char text[160];
  std::snprintf(text, sizeof(text), "%d walls, %.1f %% closed, gaps %.2f m2, overlaps %.2f m2",
                figures.walls, 100.0 * figures.closed / std::max(1, figures.walls), figures.gap,
                figures.overlap);
  return text;
}

}  // namespace gable
