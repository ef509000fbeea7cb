#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

namespace gable {

/// Triangles, anticlockwise, that cover a polygon: rings[0] is its outline, anticlockwise, the
/// others holes, clockwise. Their corners count the points of all rings, one ring after the other.
/// n + 2 h
/// - 2 triangles for n points and h holes, whatever the rings are like; they cover the polygon
/// exactly where the rings are simple and do not touch. Ear clipping in O(n r) for r reflex
/// corners, with holes joined to the outline by bridges (Eberly, Triangulation by Ear Clipping),
/// for outlines of thousands of points; `triangulate` gives better shaped triangles of few.
std::vector<std::array<int, 3>> triangulate_rings(
    const std::vector<std::vector<Eigen::Vector2d>>& rings);

}  // namespace gable
