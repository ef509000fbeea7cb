#pragma once

#include <gable/engine/scales/scale_labels.h>
#include <gable/engine/scales/trajectory.h>

#include <vector>

namespace gable {

/// How well the shapes of every configuration of a trajectory agree with known planes: the panoptic
/// quality (Kirillov et al. 2019), the sum of intersection over union of all shapes and planes that
/// have more than half of their union in common, over the mean of their numbers. 1: the same.
/// Unlike measures that count elements, it sees a chimney as well as a wall.
/// truth: per element the number of its plane, -1 for none (an element that counts for nothing).
std::vector<double> agreement_with(const std::vector<int>& truth, const FirstShapes& first,
                                   const Trajectory& trajectory);

/// Where the scales of a trajectory begin, given the known planes of each scale, finest first. The
/// finest begins with the trajectory, as in the paper, where it has the first shapes; its planes
/// are not looked at. The others begin at the configurations that agree with their planes best in
/// sum, in this order along the trajectory. Of equals the one with the most shapes is taken, since
/// the first configuration of a scale represents it.
ScaleLabels known_scales(const std::vector<std::vector<int>>& truths, const FirstShapes& first,
                         const Trajectory& trajectory);

}  // namespace gable
