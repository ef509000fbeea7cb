#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

namespace gable {

inline constexpr int kNumKnownScales = 3;  ///< detail, structure, hull

/// A surface of triangles that know their plane at every structural scale: what scans with a known
/// truth are sampled from. At a coarser scale a triangle keeps its place, but belongs to the plane
/// that a coarser model has there: a chimney's faces to the roof, the roof's slopes to the top of a
/// block.
struct LabelledSurface {
  std::vector<Eigen::Vector3d> vertices;      ///< metres, z up
  std::vector<std::array<int, 3>> triangles;  ///< anticlockwise seen from outside
  /// Per triangle and scale (0: detail, 1: structure, 2: hull): the number of its plane, from 0.
  std::vector<std::array<int, kNumKnownScales>> planes;
};

}  // namespace gable
