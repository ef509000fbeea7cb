#include "scan_scene.h"

#include <gable/grammar/random.h>
#include <gable/training/scans/sample_surface.h>

#include <cmath>

namespace gable {
namespace {

constexpr int kRoomsX = 3, kRoomsY = 2, kStoreys = 2;
constexpr double kRoomX = 5.0, kRoomY = 4.0, kRoomZ = 2.8, kWall = 0.2;  // metres
constexpr double kLength = kRoomsX * (kRoomX + kWall) + kWall;
constexpr double kWidth = kRoomsY * (kRoomY + kWall) + kWall;
constexpr double kHeight = kStoreys * (kRoomZ + kWall);
constexpr double kRidge = 3.0;  // above the eaves
constexpr double kEavesOverhang = 0.5;

using Points = std::vector<Eigen::Vector3d>;

/// Adds a convex polygon as one plane.
void add_face(const Points& corners, LabelledSurface* surface) {
  const int first = static_cast<int>(surface->vertices.size());
  const int plane = surface->planes.empty() ? 0 : surface->planes.back()[0] + 1;
  surface->vertices.insert(surface->vertices.end(), corners.begin(), corners.end());
  for (int i = 2; i < static_cast<int>(corners.size()); ++i) {
    surface->triangles.push_back({first, first + i - 1, first + i});
    surface->planes.push_back({plane, plane, plane});
  }
}

/// The six faces of a box, turned about the vertical through its centre.
void add_box(const Eigen::Vector3d& centre, const Eigen::Vector3d& size, double angle_rad,
             LabelledSurface* surface) {
  const auto corner = [&](int x, int y, int z) {
    const Eigen::Vector3d d = 0.5 * size.cwiseProduct(Eigen::Vector3d(x, y, z));
    const double c = std::cos(angle_rad), s = std::sin(angle_rad);
    return Eigen::Vector3d(centre +
                           Eigen::Vector3d(c * d.x() - s * d.y(), s * d.x() + c * d.y(), d.z()));
  };
  for (const int side : {-1, 1}) {
    add_face({corner(side, -1, -1), corner(side, 1, -1), corner(side, 1, 1), corner(side, -1, 1)},
             surface);
    add_face({corner(-1, side, -1), corner(1, side, -1), corner(1, side, 1), corner(-1, side, 1)},
             surface);
    add_face({corner(-1, -1, side), corner(1, -1, side), corner(1, 1, side), corner(-1, 1, side)},
             surface);
  }
}

/// A room's walls, floor and ceiling, and three pieces of furniture on its floor.
void add_room(const Eigen::Vector3d& low, Random* random, LabelledSurface* surface) {
  const Eigen::Vector3d size(kRoomX, kRoomY, kRoomZ);
  add_box(low + 0.5 * size, size, 0.0, surface);
  for (const double third : {1.0, 3.0, 5.0}) {
    const Eigen::Vector3d furniture(random->uniform(0.4, 1.2), random->uniform(0.4, 1.6),
                                    random->uniform(0.4, 2.0));
    const Eigen::Vector3d at(third / 6.0 * kRoomX, random->uniform(0.3, 0.7) * kRoomY,
                             0.5 * furniture.z());
    add_box(low + at, furniture, random->chance(0.5) ? 0.0 : random->uniform(0.0, M_PI), surface);
  }
}

void add_outside(LabelledSurface* surface) {
  add_box({0.5 * kLength, 0.5 * kWidth, 0.5 * kHeight}, {kLength, kWidth, kHeight}, 0.0, surface);
  const double drop = kEavesOverhang * kRidge / (0.5 * kWidth);
  for (const double eaves : {-kEavesOverhang, kWidth + kEavesOverhang}) {
    add_face({{-kEavesOverhang, eaves, kHeight - drop},
              {kLength + kEavesOverhang, eaves, kHeight - drop},
              {kLength + kEavesOverhang, 0.5 * kWidth, kHeight + kRidge},
              {-kEavesOverhang, 0.5 * kWidth, kHeight + kRidge}},
             surface);
  }
  for (const double x : {0.0, kLength}) {
    add_face({{x, 0.0, kHeight}, {x, kWidth, kHeight}, {x, 0.5 * kWidth, kHeight + kRidge}},
             surface);
  }
}

}  // namespace

Scan make_scan_scene(int num_points) {
  Random random(1);
  LabelledSurface surface;
  add_outside(&surface);
  for (int storey = 0; storey < kStoreys; ++storey) {
    for (int y = 0; y < kRoomsY; ++y) {
      for (int x = 0; x < kRoomsX; ++x) {
        add_room({kWall + x * (kRoomX + kWall), kWall + y * (kRoomY + kWall),
                  0.5 * kWall + storey * (kRoomZ + kWall)},
                 &random, &surface);
      }
    }
  }
  SampleOptions options;
  options.num_points = num_points;
  options.noise = 0.001;
  options.outlier_share = 0.01;
  Scan scan = sample_surface(surface, options);
  scan.labels.clear();
  return scan;
}

}  // namespace gable
