#include <gable/training/scans/surface_shapes.h>
#include <glog/logging.h>

#include <algorithm>

namespace gable {

using Eigen::Vector2d;
using Eigen::Vector3d;

void add_box(SurfaceBuilder* builder, const Vector3d& low, const Vector3d& high,
             const std::array<int, 6>& structure, const std::vector<BoxSide>& hidden) {
  const auto corner = [&](int bits) {
    return Vector3d(bits & 1 ? high.x() : low.x(), bits & 2 ? high.y() : low.y(),
                    bits & 4 ? high.z() : low.z());
  };
  constexpr int kCorners[6][4] = {{2, 0, 4, 6}, {1, 3, 7, 5}, {0, 1, 5, 4},
                                  {3, 2, 6, 7}, {2, 3, 1, 0}, {4, 5, 7, 6}};
  for (int side = 0; side < 6; ++side) {
    if (std::count(hidden.begin(), hidden.end(), static_cast<BoxSide>(side)) > 0) continue;
    SurfaceBuilder::Ring ring;
    for (int bits : kCorners[side]) ring.push_back(corner(bits));
    builder->add_face(structure[side], ring);
  }
}

void add_box(SurfaceBuilder* builder, const Vector3d& low, const Vector3d& high, int structure,
             const std::vector<BoxSide>& hidden) {
  std::array<int, 6> all;
  all.fill(structure);
  add_box(builder, low, high, all, hidden);
}

void add_loft(SurfaceBuilder* builder, int structure, const SurfaceBuilder::Ring& from,
              const SurfaceBuilder::Ring& to) {
  CHECK_EQ(from.size(), to.size());
  for (size_t i = 0; i + 1 < from.size(); ++i) {
    const Vector3d &a = from[i], &b = from[i + 1], &c = to[i + 1], &d = to[i];
    const Vector3d normal = (c - a).cross(d - b);
    const double bend = normal.norm() > 0.0 ? std::abs(normal.normalized().dot(b - a)) : 0.0;
    if (bend < 5e-4) {
      builder->add_face(structure, {a, b, c, d});
    } else {
      builder->add_face(structure, {a, b, c});
      builder->add_face(structure, {a, c, d});
    }
  }
}

void add_patch(SurfaceBuilder* builder, int structure, int columns, int rows,
               const std::function<Vector3d(double, double)>& at) {
  const auto row = [&](int r) {
    SurfaceBuilder::Ring ring;
    for (int c = 0; c <= columns; ++c) {
      ring.push_back(at(static_cast<double>(c) / columns, static_cast<double>(r) / rows));
    }
    return ring;
  };
  for (int r = 0; r < rows; ++r) add_loft(builder, structure, row(r), row(r + 1));
}

void add_strips(SurfaceBuilder* builder, const std::vector<int>& structure,
                const SurfaceBuilder::Ring& curve, const Vector3d& sweep) {
  CHECK_EQ(structure.size() + 1, curve.size());
  for (size_t i = 0; i + 1 < curve.size(); ++i) {
    builder->add_face(structure[i],
                      {curve[i], curve[i] + sweep, curve[i + 1] + sweep, curve[i + 1]});
  }
}

int add_panel(SurfaceBuilder* builder, int structure, const Vector3d& origin, const Vector3d& u,
              const Vector3d& v, const std::vector<Vector2d>& outline,
              const std::vector<Inset>& insets) {
  const Vector3d inward = -u.cross(v);
  const auto at = [&](const Vector2d& p, double depth) -> Vector3d {
    return origin + p.x() * u + p.y() * v + depth * inward;
  };
  SurfaceBuilder::Ring outer;
  for (const Vector2d& p : outline) outer.push_back(at(p, 0.0));
  std::vector<SurfaceBuilder::Ring> holes;
  for (const Inset& inset : insets) {
    SurfaceBuilder::Ring rim, bottom;
    for (const Vector2d& p : inset.outline) {
      rim.push_back(at(p, 0.0));
      bottom.push_back(at(p, inset.depth));
    }
    builder->add_face(structure, bottom);
    for (size_t k = 0; k < rim.size(); ++k) {
      const size_t next = (k + 1) % rim.size();
      builder->add_face(structure, {rim[k], rim[next], bottom[next], bottom[k]});
    }
    holes.push_back(rim);
  }
  return builder->add_face(structure, outer, holes);
}

int add_panel(SurfaceBuilder* builder, int structure, const Vector3d& origin, const Vector3d& u,
              const Vector3d& v, const std::vector<Vector2d>& outline,
              const std::vector<Recess>& recesses) {
  std::vector<Inset> insets;
  for (const Recess& r : recesses) {
    insets.push_back({{{r.u0, r.v0}, {r.u1, r.v0}, {r.u1, r.v1}, {r.u0, r.v1}}, r.depth});
  }
  return add_panel(builder, structure, origin, u, v, outline, insets);
}

}  // namespace gable
