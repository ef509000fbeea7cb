#pragma once

#include <gable/engine/scales/forest.h>
#include <gable/engine/scales/scale_features.h>
#include <gable/engine/scales/scale_labels.h>

#include <span>
#include <string>
#include <vector>

namespace gable {

/// How the configurations of a trajectory are labelled together.
struct ScaleChainOptions {
  double gamma = 0.5;  ///< weight of the pairwise term (CVPR 2018, eq. 2), [0, 1000]
};

/// Empty if the options are in range; otherwise names the violated bound.
std::string check(const ScaleChainOptions& options);

/// How differently two configurations look: the L2 norm over the four descriptors of the earth
/// mover's distances between their histograms (CVPR 2018, section 5, "Choice of phi"). The unit of
/// the ground distance is one bin, so that a descriptor counts up to 4 (five bins) or 3 (four) and
/// all four up to 7.07: it spans exp(-d/2) from 1 down to 0.03. In units of the histograms' ranges
/// the weight of eq. (4) would never fall below 0.37, and jumps would cost nearly the same
/// everywhere. A histogram without pairs (all 0) counts as equal to any other.
double feature_distance(const ScaleFeatures& a, const ScaleFeatures& b);

/// The cheapest labels of a chain by Viterbi's algorithm: the first is free, and from one
/// configuration to the next a label stays or rises by one (CVPR 2018, eqs. 2 and 5).
/// unary: num_labels values per configuration. jump[i]: what it costs to rise from configuration i
/// to i + 1, one fewer than there are configurations. Of equally cheap labellings the one that
/// rises later is returned.
std::vector<int> cheapest_labels(std::span<const double> unary, std::span<const double> jump,
                                 int num_labels);

/// The structural scales of a trajectory, given the features of its configurations: the labels that
/// minimise the energy of CVPR 2018, eq. (2), with the forest's label 0 for what comes before the
/// first scale.
ScaleLabels label_trajectory(const std::vector<ScaleFeatures>& features, const Forest& forest,
                             const ScaleChainOptions& options);

}  // namespace gable
