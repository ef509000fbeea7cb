#include <gable/grammar/height_field.h>
#include <gable/grammar/solid/house_solids.h>
#include <gable/grammar/synthesis/houses/rectangle.h>
#include <gable/training/scans/house_surface.h>
#include <gable/training/scans/surface_builder.h>
#include <gable/training/scans/surface_shapes.h>
#include <gable/training/scans/wall_openings.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace gable {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

/// Roofs of components whose middle heights differ by less than this are one top in LOD1, metres.
constexpr double kOneTop = 1.5;
/// Smaller walls, and those of garages, are no walls of LOD1 by themselves, square metres.
constexpr double kLargeWall = 16.0;
/// Smaller blocks have no top of their own in LOD1, square metres.
constexpr double kLargeBlock = 25.0;
/// A contact of details, metres.
constexpr double kContact = 0.02;

class HouseBuilder {
 public:
  HouseBuilder(const House& house, Random* random)
      : field_(house), random_(random), style_(random_window_style(2.65, random)) {
    overhang_ = random->chance(0.8) ? random->uniform(0.25, 0.5) : 0.0;
    fascia_ = random->uniform(0.1, 0.2);
    door_wall_ = random->integer(0, 3);
    group_tops();
  }

  void add_part(const HousePart& part) {
    for (const Face& face : part.solid.faces) {
      if (face.type == SurfaceType::kGround) continue;
      SurfaceBuilder::Ring ring;
      for (int corner : face.rings[0]) ring.push_back(part.solid.vertices[corner]);
      std::vector<SurfaceBuilder::Ring> holes;
      for (size_t r = 1; r < face.rings.size(); ++r) {
        holes.emplace_back();
        for (int corner : face.rings[r]) holes.back().push_back(part.solid.vertices[corner]);
      }
      if (face.type == SurfaceType::kRoof) {
        add_roof(part.role, ring, holes);
      } else {
        add_wall(part.role, ring, holes);
      }
    }
  }

  LabelledSurface build() const { return builder_.build(kContact); }

 private:
  struct RoofEdge {
    Vector3d from, to;  // as the roof runs
  };

  /// Height over the ground at a local point, metres.
  double height(const Vector3d& at) const { return field_.at_local(at.head<2>(), 0.0, 0.0); }

  static Vector3d normal_of(const SurfaceBuilder::Ring& ring) {
    Vector3d sum = Vector3d::Zero();
    for (size_t i = 1; i + 1 < ring.size(); ++i) {
      sum += (ring[i] - ring[0]).cross(ring[i + 1] - ring[0]);
    }
    return sum.normalized();
  }

  static double area_of(const SurfaceBuilder::Ring& ring) {
    Vector3d sum = Vector3d::Zero();
    for (size_t i = 1; i + 1 < ring.size(); ++i) {
      sum += (ring[i] - ring[0]).cross(ring[i + 1] - ring[0]);
    }
    return 0.5 * sum.norm();
  }

  static Vector3d mean_of(const SurfaceBuilder::Ring& ring) {
    Vector3d sum = Vector3d::Zero();
    for (const Vector3d& p : ring) sum += p;
    return sum / static_cast<double>(ring.size());
  }

  /// Components with like tops share a plane of the hull.
  void group_tops() {
    std::vector<std::pair<double, int>> tops;
    for (size_t b = 0; b < field_.blocks().size(); ++b) {
      using namespace block_value;
      const Block<double>& block = field_.blocks()[b];
      const double top = block[kEaves] + (block.flat ? 0.0 : 0.5 * block[kRise]);
      tops.push_back({top, static_cast<int>(b)});
    }
    std::sort(tops.begin(), tops.end());
    double last = -1e9;
    int hull = -1;
    for (const auto& [top, block] : tops) {
      if (field_.sources()[block].role != BlockRole::kComponent) continue;
      const Rectangle plan = rectangle_of(field_.blocks()[block]);
      if (plan.area() < kLargeBlock) {
        top_of_block_[block] = kTouching;
        continue;
      }
      if (top - last > kOneTop) hull = builder_.add_hull();
      last = top;
      top_of_block_[block] = hull;
    }
  }

  void add_roof(PartRole role, const SurfaceBuilder::Ring& ring,
                const std::vector<SurfaceBuilder::Ring>& holes) {
    int structure = kTouching;
    if (role == PartRole::kDormer) structure = builder_.add_structure();
    if (role == PartRole::kGarage) structure = builder_.add_structure();
    if (role == PartRole::kMain) structure = builder_.add_structure(top_under(ring));
    const int detail = builder_.add_face(structure, ring, holes);
    if (role == PartRole::kChimney || role == PartRole::kDormer || overhang_ == 0.0) return;
    for (size_t i = 0; i < ring.size(); ++i) {
      add_overhang(structure, detail, normal_of(ring), ring[i], ring[(i + 1) % ring.size()]);
    }
  }

  /// The top of the ground-bound block that a roof covers: that of the highest at its middle.
  int top_under(const SurfaceBuilder::Ring& ring) const {
    int best = kTouching;
    double least = 1e9;
    for (size_t i = 0; i < ring.size(); ++i) {
      // A little inside a corner, on the roof: its block has that height there.
      const Vector3d& a = ring[(i + ring.size() - 1) % ring.size()];
      const Vector3d& c = ring[(i + 1) % ring.size()];
      const Vector3d at =
          ring[i] + 0.02 * ((a - ring[i]).normalized() + (c - ring[i]).normalized());
      const Vector2d point = field_.house_from_local(at.head<2>());
      for (const auto& [block, hull] : top_of_block_) {
        using namespace block_value;
        const Block<double>& b = field_.blocks()[block];
        if (point.x() < b[kX0] || point.x() > b[kX1]) continue;
        if (point.y() < b[kY0] || point.y() > b[kY1]) continue;
        const double off = std::abs(roof_height(b, point.x(), point.y()) - at.z());
        if (off < least) {
          least = off;
          best = hull;
        }
      }
    }
    return best;
  }

  /// Continues a roof over an edge under which there is a free wall.
  void add_overhang(int structure, int roof, const Vector3d& roof_normal, const Vector3d& from,
                    const Vector3d& to) {
    const Vector3d along = to - from;
    Vector3d outward(along.y(), -along.x(), 0.0);
    if (outward.norm() < 0.5) return;
    outward.normalize();
    for (double share : {0.02, 0.25, 0.5, 0.75, 0.98}) {
      const Vector3d at = from + share * along;
      for (double off : {0.05, overhang_ + 0.1}) {
        if (height(at + off * outward) > at.z() - 0.6) return;
      }
      if (height(at - 0.05 * outward) < at.z() - 0.3) return;
    }
    const double fall = -outward.dot(roof_normal) / roof_normal.z();
    const Vector3d out = overhang_ * (outward + fall * Vector3d::UnitZ());
    const Vector3d drop(0.0, 0.0, -fascia_);
    builder_.add_polygon(roof, {from, from + out, to + out, to});
    builder_.add_face(structure, {from + out, from + out + drop, to + out + drop, to + out});
    builder_.add_face(structure, {from + drop, to + drop, to + out + drop, from + out + drop});
    builder_.add_face(structure, {from, from + drop, from + out + drop, from + out});
    builder_.add_face(structure, {to, to + out, to + out + drop, to + drop});
  }

  void add_wall(PartRole role, const SurfaceBuilder::Ring& ring,
                const std::vector<SurfaceBuilder::Ring>& holes) {
    const Vector3d normal = normal_of(ring);
    const Vector3d along = Vector3d::UnitZ().cross(normal).normalized();
    double low = 1e9, left = 1e9, right = -1e9;
    for (const Vector3d& p : ring) {
      low = std::min(low, p.z());
      left = std::min(left, p.dot(along));
      right = std::max(right, p.dot(along));
    }
    if (role == PartRole::kGarage && is_hidden(ring, normal)) return;
    if (role == PartRole::kChimney) {
      builder_.add_face(kTouching, ring, holes);
      return;
    }
    if (role == PartRole::kDormer) {
      add_dormer_wall(ring, holes, normal, along, left, right, low);
      return;
    }
    const bool of_hull = role == PartRole::kMain && low < 0.5 && area_of(ring) > kLargeWall;
    const int structure = builder_.add_structure(of_hull ? builder_.add_hull() : kTouching);
    if (low > 0.5 || !holes.empty() || right - left < 1.5) {
      builder_.add_face(structure, ring, holes);
      return;
    }
    const Vector3d origin(normal.x() * ring[0].dot(normal), normal.y() * ring[0].dot(normal), 0.0);
    std::vector<Vector2d> outline;
    for (const Vector3d& p : ring) outline.push_back({p.dot(along), p.z()});
    const auto is_free = [&](const Recess& r) {
      for (double share : {0.0, 0.5, 1.0}) {
        const Vector3d at = origin + (r.u0 + share * (r.u1 - r.u0)) * along;
        for (double off : {0.1, 0.5, 1.0}) {
          if (height(at + off * normal) > std::max(0.1, r.v0 - 0.2)) return false;
        }
      }
      return true;
    };
    const bool with_door = role == PartRole::kMain && wall_++ == door_wall_;
    const std::vector<Recess> openings =
        wall_openings(outline, style_, with_door, random_, is_free);
    add_panel(&builder_, structure, origin, along, Vector3d::UnitZ(), outline, openings);
    for (const Recess& r : openings) {
      if (r.v0 < 0.1) add_step(structure, origin, along, normal, r);
    }
  }

  void add_dormer_wall(const SurfaceBuilder::Ring& ring,
                       const std::vector<SurfaceBuilder::Ring>& holes, const Vector3d& normal,
                       const Vector3d& along, double left, double right, double low) {
    double high = -1e9;
    for (const Vector3d& p : ring) high = std::max(high, p.z());
    // A dormer's front is the wall that a roof falls away from.
    const Vector3d middle = mean_of(ring);
    const bool is_front =
        height(middle + 0.1 * normal) < low + 0.15 && right - left > 0.8 &&
        height(middle + 0.1 * normal - 0.4 * (right - left) * along) < low + 0.15 &&
        height(middle + 0.1 * normal + 0.4 * (right - left) * along) < low + 0.15;
    if (!is_front || !holes.empty()) {
      builder_.add_face(kTouching, ring, holes);
      return;
    }
    std::vector<Vector2d> outline;
    for (const Vector3d& p : ring) outline.push_back({p.dot(along), p.z()});
    const Vector3d origin(normal.x() * ring[0].dot(normal), normal.y() * ring[0].dot(normal), 0.0);
    const Recess window = {left + 0.25, right - 0.25, low + 0.2, low + 0.2 + 0.5 * (high - low),
                           0.08};
    std::vector<Recess> openings;
    if (window.u1 - window.u0 > 0.3 && window.v1 - window.v0 > 0.3) openings.push_back(window);
    add_panel(&builder_, builder_.add_structure(), origin, along, Vector3d::UnitZ(), outline,
              openings);
  }

  void add_step(int structure, const Vector3d& origin, const Vector3d& along,
                const Vector3d& normal, const Recess& door) {
    const Eigen::Affine3d before = builder_.pose();
    Eigen::Affine3d pose;
    pose.linear() << along, -normal, Vector3d::UnitZ();
    pose.translation() = origin;
    builder_.set_pose(pose);
    const double depth = random_->uniform(0.3, 0.5), rise = random_->uniform(0.12, 0.2);
    add_box(&builder_, {door.u0 - 0.2, -depth, 0.0}, {door.u1 + 0.2, 0.0, rise}, structure,
            {kBack, kBottom});
    builder_.set_pose(before);
  }

  /// Whether a wall stands against another part that is at least as high.
  bool is_hidden(const SurfaceBuilder::Ring& ring, const Vector3d& normal) const {
    double top = -1e9;
    for (const Vector3d& p : ring) top = std::max(top, p.z());
    int hidden = 0;
    for (double share : {0.25, 0.5, 0.75}) {
      const Vector3d at = mean_of(ring) + (share - 0.5) * (ring[1] - ring[0]);
      if (height(at + 0.15 * normal) > top - 0.1) ++hidden;
    }
    return hidden >= 2;
  }

  HeightField field_;
  Random* random_;
  WindowStyle style_;
  double overhang_ = 0.0;
  double fascia_ = 0.15;
  int door_wall_ = 0;
  int wall_ = 0;
  std::map<int, int> top_of_block_;
  SurfaceBuilder builder_;
};

}  // namespace

LabelledSurface house_surface(const House& house, Random* random) {
  HouseBuilder builder(house, random);
  for (const HousePart& part : build_house_solids(house, Lod::k22, 0.0).parts) {
    builder.add_part(part);
  }
  return builder.build();
}

}  // namespace gable
