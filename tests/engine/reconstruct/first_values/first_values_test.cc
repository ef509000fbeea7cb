#include <gable/engine/reconstruct/first_values/first_values.h>
#include <gtest/gtest.h>

namespace gable {
namespace {

TEST(FirstValues, OriginsFollowTheDerivation) {
  House house = make_house(Foundation::kII);
  house.dormers = {make_rule(RuleKind::kDormer)};
  house.chimneys = {make_rule(RuleKind::kChimney)};
  house.garages = {make_rule(RuleKind::kGarageI)};
  const std::vector<std::string> origins = origins_of(house, {"a", "f", "r", "d", "g"});
  const std::vector<std::string> expected = {"a", "f", "f", "r", "r", "d", "d", "g"};
  EXPECT_EQ(origins, expected);
  EXPECT_EQ(origins.size(), house.derivation().size());
}

TEST(FirstValues, SourcesHaveNames) {
  EXPECT_EQ(value_source_name(ValueSource::kClassical), "classical");
  EXPECT_EQ(value_source_name(ValueSource::kDetectors), "detectors");
  EXPECT_EQ(value_source_name(ValueSource::kScales), "scales");
}

}  // namespace
}  // namespace gable
