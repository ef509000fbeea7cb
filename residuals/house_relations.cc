#include <gable/residuals/house_relations.h>
#include <gable/residuals/linear_cost.h>
#include <glog/logging.h>

#include <algorithm>

namespace gable {
namespace {

// Collects rows over rules of a house; each rule becomes one parameter block, however often named.
class RelationBuilder {
 public:
  explicit RelationBuilder(const House& house) : derivation_(house.derivation()) {}

  void start_row(double constant = 0.0) { rows_.push_back({{}, constant}); }

  void add(int rule, int index, double coefficient) {
    CHECK(rule >= 0 && rule < static_cast<int>(derivation_.size()));
    const auto found = std::find(rules_.begin(), rules_.end(), rule);
    const int block = static_cast<int>(found - rules_.begin());
    if (found == rules_.end()) rules_.push_back(rule);
    rows_.back().terms.push_back({block, index, coefficient});
  }

  HouseRelation build() {
    std::vector<int> sizes;
    for (int rule : rules_) sizes.push_back(derivation_[rule]->size());
    return {std::make_unique<LinearCost>(sizes, std::move(rows_)), rules_};
  }

 private:
  std::vector<const Rule*> derivation_;
  std::vector<int> rules_;
  std::vector<LinearRow> rows_;
};

}  // namespace

HouseRelation equal_parameters(const House& house, int rule_a, int index_a, int rule_b, int index_b,
                               double weight) {
  RelationBuilder builder(house);
  builder.start_row();
  builder.add(rule_a, index_a, weight);
  builder.add(rule_b, index_b, -weight);
  return builder.build();
}

HouseRelation equal_eaves(const House& house, int component_a, int component_b, double weight) {
  return equal_parameters(house, house.roof_block(component_a), param::roof::kEaves,
                          house.roof_block(component_b), param::roof::kEaves, weight);
}

HouseRelation equal_ridges(const House& house, int component_a, int component_b, double weight) {
  RelationBuilder builder(house);
  builder.start_row();
  for (const auto& [component, sign] : {std::pair(component_a, 1.0), {component_b, -1.0}}) {
    const int rule = house.roof_block(component);
    builder.add(rule, param::roof::kEaves, sign * weight);
    if (house.roofs[component].kind != RuleKind::kRoofFlat) {
      builder.add(rule, param::roof::kRise, sign * weight);
    }
  }
  return builder.build();
}

HouseRelation symmetric_hips(const House& house, int component, double weight) {
  CHECK(house.roofs[component].kind == RuleKind::kRoofHip);
  const int rule = house.roof_block(component);
  return equal_parameters(house, rule, param::roof::kHipStart, rule, param::roof::kHipEnd, weight);
}

HouseRelation alike_dormers(const House& house, int dormer_a, int dormer_b, double weight) {
  namespace d = param::dormer;
  const int component = house.dormers[dormer_a].component;
  CHECK_EQ(component, house.dormers[dormer_b].component);
  const int across = house.roofs[component].ridge == Axis::kX ? d::kCenterY : d::kCenterX;
  RelationBuilder builder(house);
  for (int index : {static_cast<int>(d::kWidth), static_cast<int>(d::kDepth),
                    static_cast<int>(d::kEaves), static_cast<int>(d::kRise), across}) {
    builder.start_row();
    builder.add(house.dormer_block(dormer_a), index, weight);
    builder.add(house.dormer_block(dormer_b), index, -weight);
  }
  return builder.build();
}

HouseRelation parameter_priors(const House& house, const std::vector<ParameterPrior>& priors,
                               double weight) {
  RelationBuilder builder(house);
  for (const ParameterPrior& prior : priors) {
    CHECK_GT(prior.deviation, 0.0);
    builder.start_row(weight * prior.mean / prior.deviation);
    builder.add(prior.rule, prior.parameter, weight / prior.deviation);
  }
  return builder.build();
}

}  // namespace gable
