#include <gable/engine/closing/label_expansion.h>
#include <gable/engine/closing/minimum_cut.h>
#include <glog/logging.h>

#include <algorithm>
#include <cstdint>
#include <utility>

namespace gable {
namespace {

// Rounds over all labels: costs fall in every one, and few are ever needed.
constexpr int kMaxRounds = 20;

bool falls(double cost, double from) { return cost < from - 1e-9 * (1.0 + from); }

/// The labelling in which the best set of sites takes label `alpha`.
std::vector<int> expanded(const LabelProblem& problem, const std::vector<int>& labels, int alpha) {
  const int num_sites = problem.num_sites();
  // What it costs a site to take alpha instead of keeping its label.
  std::vector<double> change(num_sites);
  for (int i = 0; i < num_sites; ++i) {
    change[i] = problem.at(i, alpha) - problem.at(i, labels[i]);
  }
  MinimumCut cut(num_sites);
  for (size_t e = 0; e < problem.pairs.size(); ++e) {
    const auto [a, b] = problem.pairs[e];
    if (labels[a] == alpha && labels[b] == alpha) continue;
    const int pair = static_cast<int>(e);
    const double keep = problem.pair_cost(pair, labels[a], labels[b]);
    const double b_takes = problem.pair_cost(pair, labels[a], alpha);
    const double a_takes = problem.pair_cost(pair, alpha, labels[b]);
    // Kolmogorov and Zabih 2004: two terms of one site and one of both, which the triangle
    // inequality keeps from being negative.
    change[a] += a_takes - keep;
    change[b] -= a_takes;
    cut.add_arc(a, b, b_takes + a_takes - keep);
  }
  for (int i = 0; i < num_sites; ++i) {
    cut.add_terminals(i, std::max(0.0, change[i]), std::max(0.0, -change[i]));
  }
  cut.solve();
  std::vector<int> result = labels;
  for (int i = 0; i < num_sites; ++i) {
    if (!cut.on_source_side(i)) result[i] = alpha;
  }
  return result;
}

/// Expands the labels marked in `allowed` until none lowers the cost.
double expand_allowed(const LabelProblem& problem, const std::vector<uint8_t>& allowed,
                      std::vector<int>* labels) {
  double cost = labelling_cost(problem, *labels);
  for (int round = 0; round < kMaxRounds; ++round) {
    bool fell = false;
    for (int alpha = 0; alpha < problem.num_labels; ++alpha) {
      if (!allowed[alpha]) continue;
      std::vector<int> next = expanded(problem, *labels, alpha);
      const double next_cost = labelling_cost(problem, next);
      if (!falls(next_cost, cost)) continue;
      *labels = std::move(next);
      cost = next_cost;
      fell = true;
    }
    if (!fell) break;
  }
  return cost;
}

/// Labels that the sites of `gone` get in `next`, and those of the sites beside them.
std::vector<uint8_t> labels_around(const LabelProblem& problem, const std::vector<int>& labels,
                                   int gone, const std::vector<int>& next) {
  std::vector<uint8_t> around(problem.num_labels, 0);
  for (size_t i = 0; i < labels.size(); ++i) {
    if (labels[i] == gone) around[next[i]] = 1;
  }
  for (const LabelPair& pair : problem.pairs) {
    if (labels[pair.a] == gone) around[next[pair.b]] = 1;
    if (labels[pair.b] == gone) around[next[pair.a]] = 1;
  }
  return around;
}

/// The labels with every site of `gone` at its next best allowed label.
std::vector<int> without(const LabelProblem& problem, const std::vector<uint8_t>& allowed, int gone,
                         std::vector<int> labels) {
  for (int i = 0; i < problem.num_sites(); ++i) {
    if (labels[i] != gone) continue;
    int best = -1;
    for (int l = 0; l < problem.num_labels; ++l) {
      if (allowed[l] && (best < 0 || problem.at(i, l) < problem.at(i, best))) best = l;
    }
    labels[i] = best;
  }
  return labels;
}

}  // namespace

double labelling_cost(const LabelProblem& problem, const std::vector<int>& labels) {
  double cost = 0.0;
  std::vector<uint8_t> used(problem.num_labels, 0);
  for (size_t i = 0; i < labels.size(); ++i) {
    cost += problem.at(static_cast<int>(i), labels[i]);
    used[labels[i]] = 1;
  }
  for (size_t e = 0; e < problem.pairs.size(); ++e) {
    const int a = labels[problem.pairs[e].a], b = labels[problem.pairs[e].b];
    if (a != b) cost += problem.pair_cost(static_cast<int>(e), a, b);
  }
  for (size_t l = 0; l < problem.charges.size(); ++l) {
    if (used[l]) cost += problem.charges[l];
  }
  return cost;
}

double expand_labels(const LabelProblem& problem, std::vector<int>* labels) {
  CHECK_EQ(static_cast<int>(labels->size()), problem.num_sites());
  CHECK(problem.charges.empty() || static_cast<int>(problem.charges.size()) == problem.num_labels);
  if (labels->empty()) return 0.0;
  std::vector<uint8_t> allowed(problem.num_labels, 1);
  double cost = expand_allowed(problem, allowed, labels);
  if (problem.charges.empty()) return cost;
  for (bool fell = true; fell;) {
    fell = false;
    std::vector<int> sites(problem.num_labels, 0);
    for (const int l : *labels) ++sites[l];
    std::vector<int> order;
    for (int l = 0; l < problem.num_labels; ++l) {
      if (sites[l] > 0)
        order.push_back(l);
      else
        allowed[l] = 0;
    }
    std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return sites[a] < sites[b]; });
    for (size_t k = 0; k < order.size() && order.size() > 1; ++k) {
      const int gone = order[k];
      if (std::count(allowed.begin(), allowed.end(), 1) < 2) break;
      std::vector<uint8_t> fewer = allowed;
      fewer[gone] = 0;
      std::vector<int> next = without(problem, fewer, gone, *labels);
      const double next_cost =
          expand_allowed(problem, labels_around(problem, *labels, gone, next), &next);
      if (!falls(next_cost, cost)) continue;
      *labels = std::move(next);
      cost = next_cost;
      allowed = std::move(fewer);
      fell = true;
    }
  }
  return cost;
}

}  // namespace gable
