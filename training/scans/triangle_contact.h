#pragma once

#include <Eigen/Core>
#include <array>
#include <span>
#include <utility>
#include <vector>

namespace gable {

using TriangleCorners = std::array<Eigen::Vector3d, 3>;

/// Distance between two triangles in space, metres; 0 where they touch or cross.
double distance(const TriangleCorners& a, const TriangleCorners& b);

/// Pairs (a, b), a < b, sorted, of groups of triangles that come within `tolerance` metres of each
/// other: what a scanner sees as neighbours.
/// @param group_of  per triangle, the number of its group
std::vector<std::pair<int, int>> touching_groups(std::span<const TriangleCorners> triangles,
                                                 std::span<const int> group_of, double tolerance);

}  // namespace gable
