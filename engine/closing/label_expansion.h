#pragma once

#include <functional>
#include <limits>
#include <vector>

namespace gable {

/// Two sites that would rather have the same label.
struct LabelPair {
  int a = 0, b = 0;
};

/// Which label each of a number of sites gets: the sum of what the labels cost at the sites, of
/// what different labels cost pairs of sites, and of a charge for every label that is used at all
/// is to be small.
struct LabelProblem {
  int num_labels = 0;
  std::vector<double> data;  ///< sites x labels, >= 0; of one site one after the other
  std::vector<LabelPair> pairs;
  /// What labels of pair `pair` cost, >= 0: a metric of the labels (0 for equal ones, symmetric,
  /// triangle inequality).
  std::function<double(int pair, int label_a, int label_b)> pair_cost;
  std::vector<double> charges;  ///< per label, >= 0; none: nothing is charged
  /// A site takes no label that costs it this much or more, so that labels for few of the sites are
  /// tried at these alone.
  double impossible = std::numeric_limits<double>::infinity();

  int num_sites() const { return num_labels ? static_cast<int>(data.size()) / num_labels : 0; }
  double at(int site, int label) const {
    return data[static_cast<size_t>(site) * num_labels + label];
  }
};

/// The cost of a labelling.
double labelling_cost(const LabelProblem& problem, const std::vector<int>& labels);

/// Lowers the cost of `labels` (one per site) until no expansion of a label and no label given up
/// lowers it. An expansion lets any number of sites take one label, the best such move found by a
/// minimum cut (Boykov, Veksler and Zabih 2001, "Fast Approximate Energy Minimization via Graph
/// Cuts"), so that without charges the result costs at most twice what is possible in pairs, and
/// two labels get the optimum. A label is given up where that saves more than it costs. Returns the
/// cost; it is never more than that of the labels given.
double expand_labels(const LabelProblem& problem, std::vector<int>* labels);

}  // namespace gable
