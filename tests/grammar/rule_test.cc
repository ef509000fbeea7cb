#include <gable/grammar/rule.h>
#include <gtest/gtest.h>

#include <set>
#include <string>

#include "grammar/sample_houses.h"

namespace gable {
namespace {

RuleKind kind(int i) { return static_cast<RuleKind>(i); }

TEST(Rule, EveryKindHasANameOfItsOwnThatLeadsBackToIt) {
  std::set<std::string_view> names;
  for (int i = 0; i < kNumRuleKinds; ++i) {
    RuleKind back = RuleKind::kAzimuth;
    ASSERT_TRUE(rule_kind_from_name(rule_name(kind(i)), &back)) << i;
    EXPECT_EQ(back, kind(i));
    names.insert(rule_name(kind(i)));
  }
  EXPECT_EQ(names.size(), static_cast<size_t>(kNumRuleKinds));
  RuleKind none = RuleKind::kAzimuth;
  EXPECT_FALSE(rule_kind_from_name("roof_onion", &none));
}

TEST(Rule, TablesFitARuleAndFirstValuesLieWithinBounds) {
  for (int i = 0; i < kNumRuleKinds; ++i) {
    const auto specs = parameter_specs(kind(i));
    EXPECT_GE(specs.size(), 1u);
    EXPECT_LE(specs.size(), static_cast<size_t>(kMaxRuleParameters));
    std::set<std::string_view> names;
    for (const ParameterSpec& spec : specs) {
      EXPECT_LT(spec.lower, spec.upper) << rule_name(kind(i)) << "." << spec.name;
      EXPECT_GE(spec.initial, spec.lower) << rule_name(kind(i)) << "." << spec.name;
      EXPECT_LE(spec.initial, spec.upper) << rule_name(kind(i)) << "." << spec.name;
      EXPECT_TRUE(spec.unit == "m" || spec.unit == "rad" || spec.unit == "1") << spec.unit;
      EXPECT_FALSE(spec.source.empty());
      names.insert(spec.name);
    }
    EXPECT_EQ(names.size(), specs.size()) << rule_name(kind(i));
  }
}

TEST(Rule, RoofsBeginWithTheEavesAndThoseWithARidgeGoOnWithTheRise) {
  int roofs = 0;
  for (int i = 0; i < kNumRuleKinds; ++i) {
    if (!is_roof(kind(i))) continue;
    ++roofs;
    const auto specs = parameter_specs(kind(i));
    EXPECT_EQ(specs[param::roof::kEaves].name, "eaves");
    if (kind(i) != RuleKind::kRoofFlat) {
      EXPECT_EQ(specs[param::roof::kRise].name, "rise");
    }
    EXPECT_EQ("roof_" + std::string(roof_name(kind(i))), rule_name(kind(i)));
    EXPECT_TRUE(is_well_formed(box_house(10.0, 8.0, make_rule(kind(i)))));
  }
  EXPECT_EQ(roofs, 4);
  EXPECT_FALSE(is_roof(RuleKind::kDormer));
}

}  // namespace
}  // namespace gable
