#pragma once

#include <gable/engine/scales/trajectory.h>
#include <gable/residuals/point_moments.h>

#include <span>
#include <utility>
#include <vector>

namespace gable {

/// Merges planes bottom-up, always the adjacent pair whose union has the least RMS distance from
/// one plane, as trajectories do (CVPR 2018, section 4), but never two that hold different seeds.
/// @param seed_of  per plane: the group that it is known to belong to, or -1
/// Numbers as in Trajectory. Stops when no pair may merge. Equal weights: the lowest numbers first.
std::vector<Merge> merge_planes(std::span<const PointMoments> moments,
                                std::span<const std::pair<int, int>> adjacent,
                                std::span<const int> seed_of);

/// The group of every plane: its own where it is known, else the one that merging joins it to.
/// Planes that touch nothing known form groups of their own, numbered after the known ones.
std::vector<int> attach_planes(std::span<const PointMoments> moments,
                               std::span<const std::pair<int, int>> adjacent,
                               std::span<const int> seed_of);

}  // namespace gable
