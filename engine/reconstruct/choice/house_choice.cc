#include <gable/engine/reconstruct/choice/derivation_rewrites.h>
#include <gable/engine/reconstruct/choice/grow_blocks.h>
#include <gable/engine/reconstruct/choice/house_choice.h>
#include <gable/engine/reconstruct/choice/mansard_roofs.h>
#include <gable/engine/reconstruct/choice/roof_simplification.h>
#include <gable/engine/reconstruct/first_values/classical_values.h>
#include <gable/grammar/height_field.h>
#include <glog/logging.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace gable {
namespace {

// Beyond this many inside pixels the first stage looks at every second pixel of every second row.
constexpr int kManyPixels = 400;

// Noise that the wide stage's costs are priced with, metres.
constexpr double kWideNoise = 0.2;

// What is this much dearer than the best is not rewritten, and a rewrite this much dearer than what
// it came from is followed no further.
constexpr double kWorthRewriting = 30.0;

// Residuals saturate at this many standard deviations: an outlier then costs as much as its
// likelihood under heights spread over 10 m.
constexpr double kOutlierScale = 2.6;

// Details are priced with a loss that saturates later, metres: pixels that stand out side by side
// are no independent outliers.
constexpr double kDetailScale = 0.65;

// Within a known outline nothing but the building is seen, and a loss that does not saturate tells
// a near miss from a far one, metres.
constexpr double kKnownOutlineScale = 0.3;

// What a real roof deviates from its planes by, and hence how much a rule must explain to pay when
// nothing saturates, metres.
constexpr double kKnownOutlineNoise = 0.42;

// Finalists this many times dearer than the best before details are given up.
constexpr double kWorthFinishing = 1.15;

// Finalists with all their rewrites.
constexpr size_t kMostFinalists = 16;

// Robust standard deviation of the heights around a house over the inside pixels it covers.
double noise_around(const HeightImage& image, const House& house, double fallback) {
  const HeightField field(house);
  std::vector<double> errors;
  for (int row = 0; row < image.rows; ++row) {
    for (int col = 0; col < image.cols; ++col) {
      const size_t i = image.index(row, col);
      if (!image.inside[i] || !is_evidence(image, i)) continue;
      const Eigen::Vector2d p = field.house_from_local(image.center_of(row, col));
      if (field.block_at_house(p) < 0) continue;
      errors.push_back(
          std::abs(field.at_house(p, image.spread, image.ground[i]) - image.height[i]));
    }
  }
  if (errors.size() < 10) return fallback;
  std::nth_element(errors.begin(), errors.begin() + errors.size() / 2, errors.end());
  return 1.4826 * errors[errors.size() / 2];
}

// Position of C in arrays by Foundation; houses are what comes before it.
constexpr int kC = static_cast<int>(Foundation::kC);

// Probabilities of the types given that it is a house of the grammar.
std::array<double, kNumFoundations> among_houses(
    const std::array<float, kNumFoundations>& probabilities) {
  double sum = 0.0;
  for (int i = 0; i < kC; ++i) sum += probabilities[i];
  std::array<double, kNumFoundations> among{};
  for (int i = 0; i < kC; ++i) among[i] = sum > 0.0 ? probabilities[i] / sum : 1.0 / kC;
  return among;
}

// Drops the hypotheses of improbable types unless that leaves none.
void drop_improbable(const std::array<float, kNumFoundations>& probabilities,
                     const HouseChoiceOptions& options, std::vector<FirstValue>* values) {
  const std::array<double, kNumFoundations> among = among_houses(probabilities);
  const auto improbable = [&](const FirstValue& v) {
    return among[static_cast<size_t>(v.house.foundation)] < options.skipped_probability;
  };
  if (std::all_of(values->begin(), values->end(), improbable)) return;
  std::erase_if(*values, improbable);
}

int count_inside(const HeightImage& image) {
  return static_cast<int>(std::count(image.inside.begin(), image.inside.end(), 1));
}

RefinementSummary refine(const HeightImage& image, std::vector<RefinementStage> stages,
                         bool deviations, House* house) {
  RefinementOptions options;
  options.stages = std::move(stages);
  options.function_tolerance = deviations ? 1e-4 : 1e-3;
  options.deviations = deviations;
  return refine_house(image, options, house);
}

// Places edges finely, drops what does not pay, and prices the result.
void finish(const HeightImage& image, const PenaltyOptions& penalty,
            const PenaltyOptions& detail_penalty, Candidate* c) {
  refine(image, {{0.25, LossKind::kGemanMcClure, 0.5, 1, 12}}, false, &c->house);
  drop_unpaid(image, detail_penalty, &c->house);
  simplify_roofs(image, penalty, &c->house);
  c->cost = penalised_cost(image, c->house, penalty);
}

// Puts the best few finalists, grown by more blocks, beside those they grew from.
void add_grown(const HeightImage& image, const HouseChoiceOptions& options,
               const LeftoverOptions& leftovers, const PenaltyOptions& penalty,
               std::vector<Candidate>* finalists) {
  std::stable_sort(
      finalists->begin(), finalists->end(),
      [](const Candidate& a, const Candidate& b) { return a.cost.total < b.cost.total; });
  const size_t count = std::min(finalists->size(), static_cast<size_t>(options.growing));
  for (size_t i = 0; i < count; ++i) {
    Candidate c = (*finalists)[i];
    GrowthOptions growth;
    growth.penalty = penalty;
    growth.detail_penalty = leftovers.penalty;
    growth.most_blocks = options.most_blocks;
    if (grow_blocks(image, growth, &c.house, &c.cost)) finalists->push_back(std::move(c));
  }
}

}  // namespace

std::string check(const HouseChoiceOptions& options) {
  if (options.per_foundation < 1 || options.per_foundation > 10) {
    return "per_foundation must lie in [1, 10]";
  }
  if (options.finalists < 1 || options.finalists > 20) return "finalists must lie in [1, 20]";
  if (!(options.hopeless > 1.0)) return "hopeless must be above 1";
  if (!(options.least_noise > 0.0)) return "least_noise must be positive";
  if (!(options.most_noise >= options.least_noise)) return "most_noise is below least_noise";
  if (!(options.type_weight >= 0.0 && options.type_weight <= 100.0)) {
    return "type_weight must lie in [0, 100]";
  }
  if (!(options.least_probability > 0.0 && options.least_probability <= 1.0)) {
    return "least_probability must lie in (0, 1]";
  }
  if (!(options.skipped_probability >= 0.0 && options.skipped_probability <= 1.0)) {
    return "skipped_probability must lie in [0, 1]";
  }
  if (options.most_blocks < 1 || options.most_blocks > 20) return "most_blocks must lie in [1, 20]";
  if (options.growing < 0 || options.growing > 20) return "growing must lie in [0, 20]";
  return "";
}

int HouseChoice::num_from(ValueSource source) const {
  return static_cast<int>(
      std::count_if(first_values.begin(), first_values.end(),
                    [&](const FirstValue& value) { return value.source == source; }));
}

std::array<double, kNumFoundationTypes> foundation_charges(
    const std::array<float, kNumFoundations>& probabilities, const HouseChoiceOptions& options) {
  const std::array<double, kNumFoundations> among = among_houses(probabilities);
  std::array<double, kNumFoundationTypes> charges{};
  for (int i = 0; i < kC; ++i) {
    const double p = std::clamp(among[i], options.least_probability, 1.0);
    charges[i] = -2.0 * options.type_weight * std::log(p);
  }
  charges[static_cast<size_t>(Foundation::kMany)] = charges[static_cast<size_t>(Foundation::kIII)];
  return charges;
}

RefinementStage last_stage(bool outline_known) {
  if (outline_known) return {0.25, LossKind::kSoftL1, kKnownOutlineScale, 1, 15};
  return {0.25, LossKind::kGemanMcClure, 0.5, 1, 15};
}

HouseChoice choose_house(const HeightImage& image, const HouseChoiceOptions& options,
                         const FirstValues& others) {
  CHECK(check(options).empty()) << check(options);
  HouseChoice choice;
  const int stride = count_inside(image) > kManyPixels ? 2 : 1;

  if (options.classical) choice.first_values = classical_values(image, options.per_foundation);
  PenaltyOptions penalty;
  choice.foundation = others.foundation;
  if (others.foundation) {
    penalty.foundation_charge = foundation_charges(*others.foundation, options);
    drop_improbable(*others.foundation, options, &choice.first_values);
  }
  choice.first_values.insert(choice.first_values.end(), others.houses.begin(), others.houses.end());
  if (choice.first_values.empty()) return choice;
  std::vector<Candidate> candidates;
  for (const FirstValue& value : choice.first_values) {
    candidates.push_back({value.house, {}, value.source, static_cast<int>(candidates.size())});
  }

  penalty.support = 0.25;
  penalty.loss = LossKind::kGemanMcClure;
  penalty.loss_scale = 0.5;
  // Ranked by what the wide stage minimises: edges are not in place yet.
  double least = std::numeric_limits<double>::infinity();
  for (Candidate& c : candidates) {
    const RefinementSummary summary =
        refine(image, {{1.5, LossKind::kSoftL1, 0.3, stride, 12}}, false, &c.house);
    c.cost = derivation_cost(image, c.house);
    c.cost.squared_residuals = 2.0 * summary.final_cost * stride * stride;
    c.cost.prior += penalty.foundation_charge[static_cast<size_t>(c.house.foundation)];
    c.cost.total += c.cost.squared_residuals / (kWideNoise * kWideNoise) +
                    penalty.foundation_charge[static_cast<size_t>(c.house.foundation)];
    least = std::min(least, c.cost.squared_residuals);
  }
  const auto cheaper = [](const Candidate& a, const Candidate& b) {
    return a.cost.total < b.cost.total;
  };
  std::stable_sort(candidates.begin(), candidates.end(), cheaper);

  // The best of each type first, then second ones, while there is room.
  std::vector<Candidate> finalists;
  std::vector<char> taken(candidates.size(), 0);
  for (int round = 0; round < 2; ++round) {
    for (size_t i = 0; i < candidates.size(); ++i) {
      const Candidate& c = candidates[i];
      if (static_cast<int>(finalists.size()) >= options.finalists) break;
      if (taken[i] || c.cost.squared_residuals > options.hopeless * least) continue;
      const bool known = std::any_of(finalists.begin(), finalists.end(), [&](const Candidate& f) {
        return f.house.foundation == c.house.foundation;
      });
      if (known != (round == 1)) continue;
      finalists.push_back(c);
      taken[i] = 1;
    }
  }
  for (size_t i = 0; i < candidates.size(); ++i) {
    if (!taken[i]) choice.given_up.push_back(candidates[i]);
  }
  for (Candidate& c : finalists) {
    refine(image, {{0.5, LossKind::kGemanMcClure, 0.5, 1, 12}}, false, &c.house);
  }
  double noise = options.most_noise;
  for (const Candidate& c : finalists) {
    noise = std::min(noise, noise_around(image, c.house, options.most_noise));
  }
  penalty.noise = std::clamp(shared_error(image) * noise, options.least_noise, options.most_noise);
  penalty.loss_scale = kOutlierScale * penalty.noise;
  choice.noise = penalty.noise;
  if (options.outline_known) {
    penalty.loss = LossKind::kSoftL1;
    penalty.loss_scale = kKnownOutlineScale;
    penalty.noise = std::max(penalty.noise, kKnownOutlineNoise);
  }

  LeftoverOptions leftovers;
  leftovers.penalty = penalty;
  if (!options.outline_known) leftovers.penalty.loss_scale = kDetailScale;
  // Details are dear to look for: only where they can still make a hypothesis the best.
  double cheapest = std::numeric_limits<double>::infinity();
  for (Candidate& c : finalists) {
    // Before details: the bulge of a broken side would come out as dormers.
    make_mansards(image, penalty, &c.house);
    c.cost = penalised_cost(image, c.house, penalty);
    c.stage = ChoiceStage::kPriced;
    cheapest = std::min(cheapest, c.cost.total);
  }
  std::erase_if(finalists, [&](const Candidate& c) {
    const bool dear = c.cost.total > kWorthFinishing * cheapest;
    if (dear) choice.given_up.push_back(c);
    return dear;
  });
  for (Candidate& c : finalists) {
    c.stage = ChoiceStage::kFinished;
    simplify_roofs(image, penalty, &c.house);
    if (add_leftovers(image, leftovers, &c.house) > 0) {
      refine(image, {{0.5, LossKind::kGemanMcClure, 0.5, 1, 8}}, false, &c.house);
    }
    finish(image, penalty, leftovers.penalty, &c);
  }
  add_grown(image, options, leftovers, penalty, &finalists);
  cheapest = std::numeric_limits<double>::infinity();
  for (const Candidate& c : finalists) cheapest = std::min(cheapest, c.cost.total);
  // Each rewrite may be rewritten once more: a III to an L with a garage, say.
  for (size_t i = 0; i < finalists.size() && finalists.size() < kMostFinalists; ++i) {
    if (finalists[i].cost.total > cheapest + kWorthRewriting) continue;
    for (House& other : rewrites(finalists[i].house, {})) {
      Candidate c = finalists[i];
      c.house = std::move(other);
      refine(image, {{0.5, LossKind::kGemanMcClure, 0.5, 1, 8}}, false, &c.house);
      finish(image, penalty, leftovers.penalty, &c);
      if (c.cost.total < finalists[i].cost.total + kWorthRewriting) {
        cheapest = std::min(cheapest, c.cost.total);
        finalists.push_back(c);
      }
    }
  }
  std::stable_sort(finalists.begin(), finalists.end(), cheaper);
  choice.finalists = finalists;
  choice.best = finalists.front();
  // What the first details hid.
  Candidate more = choice.best;
  if (add_leftovers(image, leftovers, &more.house) > 0) {
    refine(image, {{0.5, LossKind::kGemanMcClure, 0.5, 1, 8}}, false, &more.house);
    finish(image, penalty, leftovers.penalty, &more);
    if (more.cost.total < choice.best.cost.total + kWorthRewriting) choice.best = more;
  }
  simplify_roofs(image, penalty, &choice.best.house);
  choice.summary = refine(image, {last_stage(options.outline_known)}, true, &choice.best.house);
  choice.best.cost = penalised_cost(image, choice.best.house, penalty);
  const House nothing_there = [&] {
    House far = choice.best.house;
    far.dormers.clear();
    far.chimneys.clear();
    far.garages.clear();
    for (Rule& f : far.footprints) f[0] += 1e6;
    return far;
  }();
  choice.found = choice.best.cost.squared_residuals <
                 penalised_cost(image, nothing_there, penalty).squared_residuals;
  return choice;
}

}  // namespace gable
