#include <gable/grammar/random.h>
#include <gable/training/scans/furniture.h>
#include <gable/training/scans/indoor_surface.h>
#include <gable/training/scans/surface_builder.h>
#include <gable/training/scans/surface_shapes.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace gable {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kContact = 0.015;  // metres

/// A wall seen from inside, from `from` to `to` with the room on the left.
struct Wall {
  Vector2d from, to;
  double used = 0.35;  // of its length from `from` that is taken by furniture, metres
  bool radiator = false;
  double length() const { return (to - from).norm(); }
};

class Room {
 public:
  explicit Room(Random* random) : random_(random) {
    size_ = {random->uniform(3.0, 6.0), random->uniform(3.0, 5.5), random->uniform(2.4, 2.9)};
    const double x = size_.x(), y = size_.y();
    plan_ = {{0, 0}, {x, 0}, {x, y}, {0, y}};
    if (x > 4.2 && y > 4.2 && random->chance(0.5)) {  // an L
      const double u = random->uniform(0.4, 0.55) * x, v = random->uniform(0.4, 0.55) * y;
      plan_ = {{0, 0}, {x, 0}, {x, v}, {u, v}, {u, y}, {0, y}};
    }
    for (size_t k = 0; k < plan_.size(); ++k) {
      walls_.push_back({plan_[k], plan_[(k + 1) % plan_.size()]});
    }
  }

  LabelledSurface build() {
    add_shell();
    furnish_walls();
    add_dining_group();
    add_radiators();
    return builder_.build(kContact);
  }

 private:
  void add_shell() {
    const double z = size_.z();
    SurfaceBuilder::Ring floor, ceiling;
    for (const Vector2d& p : plan_) {
      floor.push_back({p.x(), p.y(), 0.0});
      ceiling.insert(ceiling.begin(), {p.x(), p.y(), z});
    }
    builder_.add_face(room_plane(), floor);
    if (random_->chance(0.7)) {
      builder_.add_face(room_plane(), ceiling);
      const int lamps = random_->integer(0, 2);
      for (int i = 0; i < lamps; ++i) {
        const double x = (0.25 + 0.25 * i) * size_.x(), y = 0.3 * size_.y();
        const double side = random_->uniform(0.25, 0.5);
        add_box(&builder_, {x, y, z - 0.08}, {x + side, y + side, z}, kTouching, {kTop});
      }
    }
    const int last = static_cast<int>(walls_.size()) - 1;
    const int open = random_->chance(0.3) ? random_->integer(0, last) : -1;  // not scanned
    const int door = random_->integer(0, last);
    for (int k = 0; k <= last; ++k) {
      if (k == open) {
        walls_[k].used = 1e9;
        continue;
      }
      add_wall(&walls_[k], k == door, k != door && random_->chance(0.7));
    }
  }

  int room_plane() { return builder_.add_structure(builder_.add_hull()); }

  void add_wall(Wall* wall, bool door, bool window) {
    const double length = wall->length(), z = size_.z();
    const Vector2d along = (wall->to - wall->from) / length;
    // Seen from inside a wall runs from right to left along its direction.
    const Vector3d u(-along.x(), -along.y(), 0.0);
    const Vector3d origin(wall->to.x(), wall->to.y(), 0.0);
    std::vector<Recess> recesses;
    if (door) {
      recesses.push_back({length - 1.25, length - 0.35, 0.01, 2.05, random_->uniform(0.03, 0.1)});
      wall->used = 1.6;
    }
    if (window && length < 2.4) window = false;
    if (window) {
      const double wide = std::min(random_->uniform(1.0, 1.8), length - 1.2);
      const double middle = 0.5 * length;
      const double depth = random_->uniform(0.08, 0.18);
      const int panes = wide > 1.3 ? 2 : 1;
      for (int i = 0; i < panes; ++i) {
        const double a = middle - 0.5 * wide + wide * i / panes + 0.03;
        recesses.push_back({a, a + wide / panes - 0.06, 0.95, 2.1, depth});
      }
    }
    const int structure = room_plane();
    add_panel(&builder_, structure, origin, u, Vector3d::UnitZ(),
              {{0.0, 0.0}, {length, 0.0}, {length, z}, {0.0, z}}, recesses);
    if (window && random_->chance(0.5)) {  // a radiator, where furniture leaves room
      wall->radiator = true;
    }
    if (!door && !window && random_->chance(0.6)) {  // a picture
      const double middle = 0.35 + random_->uniform(0.3, 0.6);
      place(*wall, length);
      add_box(&builder_, {middle - 0.25, -0.03, 1.4}, {middle + 0.25, 0.0, 1.9}, structure,
              {kBack});
      builder_.set_pose(Eigen::Affine3d::Identity());
    }
  }

  /// A frame at a wall, `along` metres from its start: x runs along the wall, the wall is y = 0.
  void place(const Wall& wall, double along, double depth = 0.0) {
    const Vector2d u = (wall.to - wall.from).normalized();
    // The room is on the left, so furniture looks that way: its front (-y) away from the wall.
    Eigen::Affine3d pose = Eigen::Affine3d::Identity();
    pose.linear().col(0) = Vector3d(-u.x(), -u.y(), 0.0);
    pose.linear().col(1) = Vector3d(u.y(), -u.x(), 0.0);
    const Vector2d n(-u.y(), u.x());
    const Vector2d at = wall.from + along * u + depth * n;
    pose.translation() = Vector3d(at.x(), at.y(), 0.0);
    builder_.set_pose(pose);
  }

  /// Puts a piece of the given size at the next free place of a wall, if there is one.
  bool put(Wall* wall, const Vector3d& size, const std::function<void()>& add) {
    if (wall->used + size.x() > wall->length() - 0.75) return false;
    place(*wall, wall->used + size.x(), size.y() + 0.004);
    // Clear of other furniture, with some room in front.
    if (!claim(builder_.pose(), {0.0, -0.3}, size.head<2>())) {
      builder_.set_pose(Eigen::Affine3d::Identity());
      wall->used += 0.4;
      return false;
    }
    add();
    builder_.set_pose(Eigen::Affine3d::Identity());
    wall->used += size.x() + random_->uniform(0.15, 0.5);
    return true;
  }

  /// Takes a rectangle of the floor, where it is free and inside the room.
  bool claim(const Eigen::Affine3d& pose, const Vector2d& low, const Vector2d& high) {
    Eigen::AlignedBox2d box;
    for (const Vector2d& p : {low, high}) {
      box.extend((pose * Vector3d(p.x(), p.y(), 0.0)).head<2>());
    }
    const Eigen::AlignedBox2d inner(box.min() + Vector2d(0.01, 0.01),
                                    box.max() - Vector2d(0.01, 0.01));
    if (inner.min().minCoeff() < 0.0) return false;
    if (inner.max().x() > size_.x() || inner.max().y() > size_.y()) return false;
    if (plan_.size() == 6 && inner.max().x() > plan_[3].x() && inner.max().y() > plan_[3].y()) {
      return false;
    }
    for (const Eigen::AlignedBox2d& other : taken_) {
      if (other.intersects(inner)) return false;
    }
    taken_.push_back(inner);
    return true;
  }

  void add_radiators() {
    for (const Wall& wall : walls_) {
      if (!wall.radiator) continue;
      place(wall, 0.5 * wall.length() + 0.4, 0.1);
      if (claim(builder_.pose(), {0.0, 0.0}, {0.8, 0.1})) {
        add_box(&builder_, {0.0, 0.0, 0.12}, {0.8, 0.1, 0.7}, kTouching, {kBack});
      }
      builder_.set_pose(Eigen::Affine3d::Identity());
    }
  }

  void furnish_walls() {
    bool bed = false, couch = false;
    for (Wall& wall : walls_) {
      for (int tries = 0; tries < 3; ++tries) {
        switch (random_->integer(0, 5)) {
          case 0: {
            const Vector3d size(random_->uniform(0.9, 1.8), random_->uniform(0.45, 0.62),
                                random_->uniform(1.7, 2.1));
            put(&wall, size, [&] { add_cupboard(&builder_, size, true, random_); });
            break;
          }
          case 1: {
            const Vector3d size(random_->uniform(0.7, 1.4), random_->uniform(0.4, 0.5),
                                random_->uniform(0.7, 0.95));
            put(&wall, size, [&] { add_cupboard(&builder_, size, false, random_); });
            break;
          }
          case 2: {
            const Vector3d size(random_->uniform(0.8, 1.6), random_->uniform(0.25, 0.32),
                                random_->uniform(1.5, 2.1));
            put(&wall, size, [&] { add_bookshelf(&builder_, size, false, random_); });
            break;
          }
          case 3: {
            const Vector3d size(random_->uniform(0.95, 1.8), 2.05, random_->uniform(0.42, 0.55));
            if (!bed) bed = put(&wall, size, [&] { add_bed(&builder_, size, true, random_); });
            break;
          }
          case 4: {
            const Vector3d size(random_->uniform(1.1, 1.7), random_->uniform(0.65, 0.8),
                                random_->uniform(0.71, 0.76));
            put(&wall, size, [&] { add_desk(&builder_, size, true, random_); });
            break;
          }
          default: {
            const Vector3d size(random_->uniform(1.5, 2.2), random_->uniform(0.8, 0.95),
                                random_->uniform(0.75, 0.9));
            if (!couch)
              couch = put(&wall, size, [&] { add_couch(&builder_, size, true, random_); });
          }
        }
      }
    }
  }

  void add_dining_group() {
    const Vector3d table(random_->uniform(1.0, 1.5), random_->uniform(0.7, 0.9),
                         random_->uniform(0.72, 0.76));
    if (size_.x() < 3.6 || size_.y() < 3.4) return;
    const Vector3d corner(0.5 * (size_.x() - table.x()), 0.5 * (size_.y() - table.y()), 0.0);
    Eigen::Affine3d pose = Eigen::Affine3d::Identity();
    pose.translation() = corner;
    if (!claim(pose, {-0.1, -0.5}, {table.x() + 0.1, table.y() + 0.5})) return;
    builder_.set_pose(pose);
    add_table(&builder_, table, true, random_);
    const Vector3d chair(0.42, 0.42, random_->uniform(0.8, 0.95));
    for (double x : {0.06, table.x() - 0.06 - chair.x()}) {
      if (random_->chance(0.7)) {
        pose.translation() = corner + Vector3d(x, table.y() + 0.05, 0.0);
        builder_.set_pose(pose);
        add_chair(&builder_, chair, random_);
      }
      if (random_->chance(0.5)) {  // across the table, turned around
        Eigen::Affine3d turned = pose;
        turned.linear() = Eigen::Vector3d(-1.0, -1.0, 1.0).asDiagonal();
        turned.translation() = corner + Vector3d(x + chair.x(), -0.05, 0.0);
        builder_.set_pose(turned);
        add_chair(&builder_, chair, random_);
      }
    }
    builder_.set_pose(Eigen::Affine3d::Identity());
  }

  Random* random_;
  Vector3d size_;
  std::vector<Vector2d> plan_;  // anticlockwise
  std::vector<Wall> walls_;
  std::vector<Eigen::AlignedBox2d> taken_;
  SurfaceBuilder builder_;
};

}  // namespace

LabelledSurface random_indoor_scene(uint64_t seed) {
  Random random(seed);
  return Room(&random).build();
}

}  // namespace gable
