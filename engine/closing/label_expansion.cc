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

bool falls(double change, double from) { return change < -1e-9 * (1.0 + from); }

/// A labelling that knows what its cost becomes when sites change, and can go back.
class Labelling {
 public:
  Labelling(const LabelProblem& problem, const std::vector<int>& labels)
      : problem_(problem),
        labels_(labels),
        sites_(problem.num_labels, 0),
        touched_(labels.size(), 1),
        incident_(labels.size()),
        candidates_(problem.num_labels) {
    for (const int l : labels_) ++sites_[l];
    for (size_t e = 0; e < problem.pairs.size(); ++e) {
      incident_[problem.pairs[e].a].push_back(static_cast<int>(e));
      incident_[problem.pairs[e].b].push_back(static_cast<int>(e));
    }
    for (int i = 0; i < problem.num_sites(); ++i) {
      for (int l = 0; l < problem.num_labels; ++l) {
        if (problem.at(i, l) < problem.impossible) candidates_[l].push_back(i);
      }
    }
    cost_ = labelling_cost(problem, labels_);
  }

  const std::vector<int>& labels() const { return labels_; }
  double cost() const { return cost_; }
  int num_sites(int label) const { return sites_[label]; }
  const std::vector<int>& candidates(int label) const { return candidates_[label]; }
  const std::vector<int>& incident(int site) const { return incident_[site]; }
  int other(int pair, int site) const {
    const auto& [a, b] = problem_.pairs[pair];
    return a == site ? b : a;
  }

  /// Gives sites a label; the cost follows.
  void set(const std::vector<int>& sites, int label) {
    for (const int i : sites) set(i, label);
  }
  void set(int site, int label) {
    const int from = labels_[site];
    if (from == label) return;
    changes_.push_back({site, from, cost_});
    cost_ += problem_.at(site, label) - problem_.at(site, from);
    for (const int e : incident_[site]) {
      const bool first = problem_.pairs[e].a == site;
      const int beside = labels_[other(e, site)];
      if (beside != label) {
        cost_ +=
            first ? problem_.pair_cost(e, label, beside) : problem_.pair_cost(e, beside, label);
      }
      if (beside != from) {
        cost_ -= first ? problem_.pair_cost(e, from, beside) : problem_.pair_cost(e, beside, from);
      }
    }
    if (!problem_.charges.empty()) {
      if (sites_[from] == 1) cost_ -= problem_.charges[from];
      if (sites_[label] == 0) cost_ += problem_.charges[label];
    }
    relabel(site, label);
  }

  size_t mark() const { return changes_.size(); }
  /// Undoes what was set since a mark.
  void back_to(size_t mark) {
    while (changes_.size() > mark) {
      const Change change = changes_.back();
      changes_.pop_back();
      relabel(change.site, change.from);
      cost_ = change.cost;
    }
  }

  /// Whether anything at or beside the candidates of a label has changed since `time`.
  bool touched_since(int label, int64_t time) const {
    return std::any_of(candidates_[label].begin(), candidates_[label].end(),
                       [&](int i) { return touched_[i] > time; });
  }
  int64_t now() const { return time_; }

 private:
  struct Change {
    int site, from;
    double cost;  // before it
  };

  void relabel(int site, int label) {
    --sites_[labels_[site]];
    ++sites_[label];
    labels_[site] = label;
    touched_[site] = ++time_;
    for (const int e : incident_[site]) touched_[other(e, site)] = time_;
  }

  const LabelProblem& problem_;
  std::vector<int> labels_, sites_;
  std::vector<int64_t> touched_;
  std::vector<std::vector<int>> incident_, candidates_;
  std::vector<Change> changes_;
  double cost_ = 0.0;
  int64_t time_ = 1;
};

/// The sites that take label `alpha` in the best expansion of it, charges aside.
std::vector<int> best_takers(const LabelProblem& problem, const Labelling& labelling, int alpha) {
  const std::vector<int>& labels = labelling.labels();
  std::vector<int> takers;
  std::vector<int> node(labels.size(), -1);
  for (const int i : labelling.candidates(alpha)) {
    if (labels[i] == alpha) continue;
    // By the triangle inequality no pair gains more than this, whatever the site beside does, so
    // that most sites need not be asked.
    double gain = problem.at(i, labels[i]) - problem.at(i, alpha);
    for (const int e : labelling.incident(i)) gain += problem.pair_cost(e, labels[i], alpha);
    if (gain < 0.0) continue;
    node[i] = static_cast<int>(takers.size());
    takers.push_back(i);
  }
  if (takers.empty()) return takers;
  // What it costs a site to take alpha instead of keeping its label.
  std::vector<double> change(takers.size());
  MinimumCut cut(static_cast<int>(takers.size()));
  for (size_t k = 0; k < takers.size(); ++k) {
    const int i = takers[k];
    change[k] += problem.at(i, alpha) - problem.at(i, labels[i]);
    for (const int e : labelling.incident(i)) {
      const auto [a, b] = problem.pairs[e];
      const double keep = problem.pair_cost(e, labels[a], labels[b]);
      const int beside = labelling.other(e, i);
      if (node[beside] < 0) {
        change[k] += (a == i ? problem.pair_cost(e, alpha, labels[b])
                             : problem.pair_cost(e, labels[a], alpha)) -
                     keep;
        continue;
      }
      if (i != a) continue;
      const double b_takes = problem.pair_cost(e, labels[a], alpha);
      const double a_takes = problem.pair_cost(e, alpha, labels[b]);
      // Kolmogorov and Zabih 2004: two terms of one site and one of both, which the triangle
      // inequality keeps from being negative.
      change[k] += a_takes - keep;
      change[node[b]] -= a_takes;
      cut.add_arc(static_cast<int>(k), node[b], b_takes + a_takes - keep);
    }
  }
  for (size_t k = 0; k < takers.size(); ++k) {
    cut.add_terminals(static_cast<int>(k), std::max(0.0, change[k]), std::max(0.0, -change[k]));
  }
  cut.solve();
  size_t kept = 0;
  for (size_t k = 0; k < takers.size(); ++k) {
    if (!cut.on_source_side(static_cast<int>(k))) takers[kept++] = takers[k];
  }
  takers.resize(kept);
  return takers;
}

/// Expands the labels marked in `allowed` until none lowers the cost.
void expand_allowed(const LabelProblem& problem, const std::vector<uint8_t>& allowed,
                    Labelling* labelling) {
  std::vector<int64_t> tried(problem.num_labels, 0);
  for (int round = 0; round < kMaxRounds; ++round) {
    bool fell = false;
    for (int alpha = 0; alpha < problem.num_labels; ++alpha) {
      if (!allowed[alpha] || !labelling->touched_since(alpha, tried[alpha])) continue;
      const double cost = labelling->cost();
      const size_t mark = labelling->mark();
      labelling->set(best_takers(problem, *labelling, alpha), alpha);
      if (falls(labelling->cost() - cost, cost)) {
        fell = true;
      } else {
        labelling->back_to(mark);
      }
      tried[alpha] = labelling->now();
    }
    if (!fell) break;
  }
}

/// Labels that the sites of `gone` have now, and those of the sites beside them.
std::vector<uint8_t> labels_around(const LabelProblem& problem, const Labelling& labelling,
                                   const std::vector<int>& gone) {
  std::vector<uint8_t> around(problem.num_labels, 0);
  for (const int i : gone) {
    around[labelling.labels()[i]] = 1;
    for (const int e : labelling.incident(i)) around[labelling.labels()[labelling.other(e, i)]] = 1;
  }
  return around;
}

/// Gives every site of a label its next best allowed one; they come back. Nothing where one has
/// none.
std::vector<int> give_up(const LabelProblem& problem, const std::vector<uint8_t>& allowed, int gone,
                         Labelling* labelling) {
  std::vector<int> sites;
  for (const int i : labelling->candidates(gone)) {
    if (labelling->labels()[i] == gone) sites.push_back(i);
  }
  if (static_cast<int>(sites.size()) != labelling->num_sites(gone)) return {};
  for (const int i : sites) {
    int best = -1;
    for (int l = 0; l < problem.num_labels; ++l) {
      if (allowed[l] && (best < 0 || problem.at(i, l) < problem.at(i, best))) best = l;
    }
    labelling->set(i, best);
  }
  return sites;
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
  Labelling labelling(problem, *labels);
  expand_allowed(problem, allowed, &labelling);
  for (bool fell = !problem.charges.empty(); fell;) {
    fell = false;
    std::vector<int> order;
    for (int l = 0; l < problem.num_labels; ++l) {
      if (labelling.num_sites(l) > 0)
        order.push_back(l);
      else
        allowed[l] = 0;
    }
    std::stable_sort(order.begin(), order.end(),
                     [&](int a, int b) { return labelling.num_sites(a) < labelling.num_sites(b); });
    for (size_t k = 0; k < order.size() && order.size() > 1; ++k) {
      const int gone = order[k];
      if (std::count(allowed.begin(), allowed.end(), 1) < 2) break;
      allowed[gone] = 0;
      const double cost = labelling.cost();
      const size_t mark = labelling.mark();
      const std::vector<int> sites = give_up(problem, allowed, gone, &labelling);
      if (!sites.empty()) {
        expand_allowed(problem, labels_around(problem, labelling, sites), &labelling);
      }
      if (falls(labelling.cost() - cost, cost)) {
        fell = true;
        continue;
      }
      labelling.back_to(mark);
      allowed[gone] = 1;
    }
  }
  *labels = labelling.labels();
  return labelling_cost(problem, *labels);
}

}  // namespace gable
