#include <ceres/jet.h>
#include <gable/grammar/block.h>
#include <gable/residuals/house_pair_relations.h>
#include <gable/residuals/linear_cost.h>
#include <glog/logging.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace gable {
namespace {

using namespace block_value;

// Azimuth and footprint rule of both houses.
constexpr int kHouseSize = 1 + kMaxRuleParameters;
using WallJet = ceres::Jet<double, 2 * kHouseSize>;

bool across_x(int side) { return side == kX0 || side == kX1; }
bool at_start(int side) { return side == kX0 || side == kY0; }

/// A house as walls need it, apart from its values.
struct WallFrame {
  RuleKind footprint_kind;
  ComponentWall wall;
};

template <typename T>
Block<T> rectangle_of(const WallFrame& frame, const T* footprint) {
  Block<T> block;
  internal::set_component_rectangle(frame.footprint_kind, footprint, frame.wall.component, &block);
  return block;
}

/// The point of a wall at a share of its length, towards the higher coordinate; house frame.
template <typename T>
std::array<T, 2> point_of(const Block<T>& block, int side, double share) {
  const int low = across_x(side) ? kY0 : kX0;
  const T along = block[low] + (block[low + 1] - block[low]) * T(share);
  return across_x(side) ? std::array<T, 2>{block[side], along}
                        : std::array<T, 2>{along, block[side]};
}

template <typename T>
std::array<T, 2> turned(const std::array<T, 2>& p, const T& angle) {
  using std::cos;
  using std::sin;
  const T c = cos(angle), s = sin(angle);
  return {c * p[0] - s * p[1], s * p[0] + c * p[1]};
}

/// Into the frame of b; `step` is the origin of a less that of b.
template <typename T>
std::array<T, 2> b_from_a(const std::array<T, 2>& p, const T& azimuth_a, const T& azimuth_b,
                          const Eigen::Vector2d& step) {
  std::array<T, 2> q = turned(p, azimuth_a);
  q[0] += T(step.x());
  q[1] += T(step.y());
  return turned(q, -azimuth_b);
}

/// Signed distance from the line of a wall, positive outside its house.
template <typename T>
T distance_from(const Block<T>& block, int side, const std::array<T, 2>& q) {
  const T& coordinate = across_x(side) ? q[0] : q[1];
  return at_start(side) ? block[side] - coordinate : coordinate - block[side];
}

const Rule& footprint_of(const House& house, const ComponentWall& wall) {
  return house.footprints[house.footprint_of_component(wall.component)];
}

WallFrame frame_of(const House& house, const ComponentWall& wall) {
  CHECK(wall.component >= 0 && wall.component < house.num_components());
  CHECK(wall.side >= kX0 && wall.side <= kY1);
  return {footprint_of(house, wall).kind, wall};
}

/// Direction of the outward normal of a wall, local frame, radians.
double normal_direction(const House& house, int side) {
  const double base = across_x(side) ? 0.0 : 0.5 * M_PI;
  return house.azimuth[0] + base + (at_start(side) ? M_PI : 0.0);
}

class PartyWall : public ceres::CostFunction {
 public:
  PartyWall(const House& a, const ComponentWall& wall_a, const House& b,
            const ComponentWall& wall_b, double weight)
      : a_(frame_of(a, wall_a)),
        b_(frame_of(b, wall_b)),
        step_((a.origin - b.origin).head<2>()),
        weight_(weight) {
    const WallContact contact = wall_contact(a, wall_a, b, wall_b);
    CHECK_GT(contact.length, 0.0) << "the walls are not beside each other";
    shares_ = {contact.from, contact.to};
    *mutable_parameter_block_sizes() = {1, footprint_of(a, wall_a).size(), 1,
                                        footprint_of(b, wall_b).size()};
    set_num_residuals(2);
  }

  bool Evaluate(double const* const* parameters, double* residuals,
                double** jacobians) const override {
    std::array<std::array<WallJet, kMaxRuleParameters>, 4> values;
    const std::array<int, 4> first = {0, 1, kHouseSize, kHouseSize + 1};
    const auto& sizes = parameter_block_sizes();
    for (int block = 0; block < 4; ++block) {
      for (int k = 0; k < sizes[block]; ++k) {
        values[block][k] = WallJet(parameters[block][k], first[block] + k);
      }
    }
    const Block<WallJet> rectangle_a = rectangle_of(a_, values[1].data());
    const Block<WallJet> rectangle_b = rectangle_of(b_, values[3].data());
    for (int i = 0; i < 2; ++i) {
      const std::array<WallJet, 2> q = b_from_a(point_of(rectangle_a, a_.wall.side, shares_[i]),
                                                values[0][0], values[2][0], step_);
      const WallJet distance = distance_from(rectangle_b, b_.wall.side, q);
      residuals[i] = weight_ * distance.a;
      for (int block = 0; block < 4 && jacobians != nullptr; ++block) {
        if (jacobians[block] == nullptr) continue;
        for (int k = 0; k < sizes[block]; ++k) {
          jacobians[block][i * sizes[block] + k] = weight_ * distance.v[first[block] + k];
        }
      }
    }
    return true;
  }

 private:
  WallFrame a_, b_;
  Eigen::Vector2d step_;
  double weight_;
  std::array<double, 2> shares_{};
};

/// weight * (elevation of a - elevation of b), the elevation being origin.z and the first
/// parameters of the roof, one or two.
HousePairRelation equal_elevations(const House& a, int component_a, const House& b, int component_b,
                                   bool with_rise, double weight) {
  LinearRow row;
  row.constant = -weight * (a.origin.z() - b.origin.z());
  const Rule* roofs[] = {&a.roofs[component_a], &b.roofs[component_b]};
  for (int i = 0; i < 2; ++i) {
    const double sign = i == 0 ? weight : -weight;
    row.terms.push_back({i, param::roof::kEaves, sign});
    if (with_rise && roofs[i]->kind != RuleKind::kRoofFlat) {
      row.terms.push_back({i, param::roof::kRise, sign});
    }
  }
  return {std::make_unique<LinearCost>(std::vector<int>{roofs[0]->size(), roofs[1]->size()},
                                       std::vector<LinearRow>{row}),
          {a.roof_block(component_a)},
          {b.roof_block(component_b)}};
}

}  // namespace

WallContact wall_contact(const House& a, const ComponentWall& wall_a, const House& b,
                         const ComponentWall& wall_b) {
  const Block<double> rectangle_a =
      rectangle_of(frame_of(a, wall_a), footprint_of(a, wall_a).values.data());
  const Block<double> rectangle_b =
      rectangle_of(frame_of(b, wall_b), footprint_of(b, wall_b).values.data());
  const Eigen::Vector2d step = (a.origin - b.origin).head<2>();
  const auto in_b = [&](double share) {
    return b_from_a(point_of(rectangle_a, wall_a.side, share), a.azimuth[0], b.azimuth[0], step);
  };
  WallContact contact;
  contact.angle = std::abs(std::remainder(
      normal_direction(a, wall_a.side) - normal_direction(b, wall_b.side) - M_PI, 2.0 * M_PI));
  // The ends of wall a along wall b; between them the way is linear in the share.
  const int along = across_x(wall_b.side) ? 1 : 0;
  const int low = along == 1 ? kY0 : kX0;
  const double start = in_b(0.0)[along], end = in_b(1.0)[along];
  if (std::abs(end - start) < 1e-9) return contact;
  double from = (rectangle_b[low] - start) / (end - start);
  double to = (rectangle_b[low + 1] - start) / (end - start);
  if (from > to) std::swap(from, to);
  from = std::max(from, 0.0);
  to = std::min(to, 1.0);
  contact.from = from;
  contact.to = to;
  const int low_a = across_x(wall_a.side) ? kY0 : kX0;
  contact.length = (to - from) * (rectangle_a[low_a + 1] - rectangle_a[low_a]);
  contact.offset_from = distance_from(rectangle_b, wall_b.side, in_b(from));
  contact.offset_to = distance_from(rectangle_b, wall_b.side, in_b(to));
  return contact;
}

double quarter_turns(const House& a, const House& b) {
  return 0.5 * M_PI * std::round((a.azimuth[0] - b.azimuth[0]) / (0.5 * M_PI));
}

HousePairRelation party_wall(const House& a, const ComponentWall& wall_a, const House& b,
                             const ComponentWall& wall_b, double weight) {
  return {std::make_unique<PartyWall>(a, wall_a, b, wall_b, weight),
          {0, a.footprint_block(a.footprint_of_component(wall_a.component))},
          {0, b.footprint_block(b.footprint_of_component(wall_b.component))}};
}

HousePairRelation equal_eaves(const House& a, int component_a, const House& b, int component_b,
                              double weight) {
  return equal_elevations(a, component_a, b, component_b, false, weight);
}

HousePairRelation equal_ridges(const House& a, int component_a, const House& b, int component_b,
                               double weight) {
  return equal_elevations(a, component_a, b, component_b, true, weight);
}

HousePairRelation equal_azimuths(const House& a, const House& b, double weight) {
  LinearRow row;
  row.constant = weight * quarter_turns(a, b);
  row.terms = {{0, 0, weight}, {1, 0, -weight}};
  return {
      std::make_unique<LinearCost>(std::vector<int>{1, 1}, std::vector<LinearRow>{row}), {0}, {0}};
}

}  // namespace gable
