#include <gable/grammar/synthesis/streets.h>

#include <algorithm>
#include <cmath>

namespace gable {
namespace {

constexpr double kSpacing = 74.0;   // between streets: two house depths and their back gardens
constexpr double kFrontage = 22.0;  // typical, along the street

/// Bounding box of a house with its garages in the local frame.
Rectangle local_box(const House& house) {
  const HeightField field(house);
  Rectangle box = {1e9, -1e9, 1e9, -1e9};
  for (const Block<double>& block : field.blocks()) {
    const Rectangle r = rectangle_of(block);
    for (double x : {r.x0, r.x1}) {
      for (double y : {r.y0, r.y1}) {
        const Eigen::Vector2d p = field.local_from_house({x, y});
        box = bounds(box, Rectangle{p.x(), p.x(), p.y(), p.y()});
      }
    }
  }
  return box;
}

/// How a house turns to the street: the long side along it in two of three houses, and a few
/// degrees off its direction now and then.
double draw_turn(const House& house, Random* random) {
  const Rectangle box = [&] {
    House straight = house;
    straight.azimuth[0] = 0.0;
    return local_box(straight);
  }();
  const bool long_along_street = random->chance(0.7);
  const bool long_in_x = box.size_x() >= box.size_y();
  double turn = (long_along_street == long_in_x ? 0.0 : 0.5 * M_PI);
  if (random->chance(0.5)) turn += M_PI;
  return turn + (random->chance(0.5) ? random->normal(0.05) : 0.0);
}

/// The house turned and moved so that its frontage starts `start` metres along the street.
StreetPlot place(House house, const Street& street, int street_index, int side, double start,
                 double turn, double front_garden) {
  house.azimuth[0] = turn;
  const Rectangle box = local_box(house);  // in the street's frame: x along, y across
  const double along = start - box.x0;
  const double direction = street.direction_at(along);
  const double across = side > 0 ? kStreetHalfWidth + front_garden - box.y0
                                 : -(kStreetHalfWidth + front_garden) - box.y1;
  const Eigen::Vector2d normal(-std::sin(direction), std::cos(direction));
  const double azimuth = std::remainder(turn + direction, 2.0 * M_PI);
  house.azimuth[0] = azimuth < 0.0 ? azimuth + 2.0 * M_PI : azimuth;
  house.origin.head<2>() = street.at(along) + across * normal;
  return {Plot(house), street_index, side, start, start + box.size_x()};
}

bool keeps_apart(const Plot& plot, const std::vector<StreetPlot>& others, double gap) {
  return std::all_of(others.begin(), others.end(), [&](const StreetPlot& other) {
    return !plot.may_be_closer(other.plot, gap) || plot.distance(other.plot) >= gap;
  });
}

}  // namespace

Eigen::Vector2d Street::at(double along) const {
  const double across = offset + swing * std::sin(2.0 * M_PI * along / wavelength + phase);
  const double c = std::cos(heading), s = std::sin(heading);
  return origin + Eigen::Vector2d(c * along - s * across, s * along + c * across);
}

double Street::direction_at(double along) const {
  const double k = 2.0 * M_PI / wavelength;
  return heading + std::atan(swing * k * std::cos(k * along + phase));
}

StreetPlan lay_out_streets(const std::vector<House>& houses, double gap,
                           const Eigen::Vector2d& center, Random* random) {
  StreetPlan plan;
  const int count = static_cast<int>(houses.size());
  const double total = count * kFrontage / 2.0;
  const int num_streets = std::max(1, static_cast<int>(std::lround(std::sqrt(total / kSpacing))));
  Street common;
  common.origin = center;
  common.heading = random->uniform(0.0, 2.0 * M_PI);
  common.swing = random->uniform(8.0, 16.0);
  common.wavelength = random->uniform(260.0, 420.0);
  const double first_phase = random->uniform(0.0, 2.0 * M_PI);
  for (int i = 0; i < num_streets; ++i) {
    Street street = common;
    street.offset = (i - 0.5 * (num_streets - 1)) * kSpacing;
    street.phase = first_phase + 0.25 * i;
    plan.streets.push_back(street);
  }

  const int rows = 2 * num_streets;
  for (int row = 0; row < rows; ++row) {
    const int first = count * row / rows;
    const int last = count * (row + 1) / rows;
    const Street& street = plan.streets[row / 2];
    const int side = row % 2 == 0 ? 1 : -1;
    double cursor = -0.5 * total / num_streets + random->uniform(0.0, 10.0);
    for (int i = first; i < last; ++i) {
      const double turn = draw_turn(houses[i], random);
      const double front_garden = random->uniform(3.0, 8.0);
      cursor += gap + random->uniform(0.0, 4.0);
      if (random->chance(0.06)) cursor += random->uniform(8.0, 25.0);  // a side road or a gap
      StreetPlot plot = place(houses[i], street, row / 2, side, cursor, turn, front_garden);
      while (!keeps_apart(plot.plot, plan.plots, gap)) {
        cursor += 0.5;
        plot = place(houses[i], street, row / 2, side, cursor, turn, front_garden);
      }
      cursor = plot.end;
      plan.plots.push_back(plot);
    }
  }
  return plan;
}

}  // namespace gable
