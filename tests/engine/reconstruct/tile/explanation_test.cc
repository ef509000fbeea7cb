#include <gable/engine/reconstruct/tile/explanation.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>

namespace gable {
namespace {

using ::testing::HasSubstr;
using ::testing::MatchesRegex;
using ::testing::Not;

constexpr double kSigma = 0.2;
constexpr int kPixels = 400;

// A candidate whose J follows from its parts.
Candidate candidate(Foundation foundation, double squared_residuals, int parameters, double prior,
                    ValueSource source) {
  Candidate c;
  c.house = make_house(foundation);
  c.cost = {squared_residuals, parameters, prior, kPixels, 0.0};
  c.cost.total = squared_residuals / (kSigma * kSigma) + parameters * std::log(kPixels) + prior;
  c.source = source;
  c.stage = ChoiceStage::kFinished;
  return c;
}

// k ln N is 41.9 of 7 and 77.9 of 13 parameters.
TileBuilding chosen() {
  TileBuilding made;
  made.building.id = "b12_34";
  HouseChoice& choice = made.choice;
  choice.found = true;
  choice.first_values.resize(10);
  choice.first_values[7].source = choice.first_values[8].source = ValueSource::kDetectors;
  choice.first_values[9].source = ValueSource::kScales;
  choice.noise = kSigma;
  choice.foundation = {0.5f, 0.25f, 0.0f, 0.125f, 0.0625f, 0.0625f};
  choice.finalists = {candidate(Foundation::kI, 8.0, 7, 0.0, ValueSource::kDetectors),
                      candidate(Foundation::kI, 10.0, 7, 2.0, ValueSource::kClassical),
                      candidate(Foundation::kII, 8.4, 13, 30.0, ValueSource::kClassical)};
  choice.finalists[0].hypothesis = 7;
  choice.finalists[1].hypothesis = 0;
  choice.first_values[7].house = make_house(Foundation::kL);
  choice.first_values[7].origins = {"by the stars", "paced out", "guessed"};
  choice.given_up = {candidate(Foundation::kU, 90.0, 12, 0.0, ValueSource::kScales)};
  choice.given_up[0].hypothesis = 9;
  choice.given_up[0].stage = ChoiceStage::kPriced;
  choice.finalists[2].house.roofs[1] = make_rule(RuleKind::kRoofFlat);
  choice.finalists[2].house.dormers.resize(2, make_rule(RuleKind::kDormer));
  choice.best = candidate(Foundation::kI, 7.0, 10, 0.0, ValueSource::kDetectors);
  choice.best.house.chimneys = {make_rule(RuleKind::kChimney)};
  made.building.house = choice.best.house;
  made.building.quality.mad = 0.1234;
  return made;
}

// The line that begins with this after its indent.
std::string line_of(const std::string& text, const std::string& begin) {
  const size_t at = text.find("\n" + begin);
  if (at == std::string::npos) return "";
  return text.substr(at + 1, text.find('\n', at + 1) - at - 1);
}

TEST(Explanation, EveryFinalistHasItsPartsAndItsCost) {
  const std::string text = explain(chosen());
  EXPECT_TRUE(text.starts_with("b12_34\n")) << text;
  EXPECT_THAT(text, HasSubstr("N = 400 pixels, sigma = 0.20 m\n"));
  EXPECT_THAT(
      line_of(text, "    1 "),
      MatchesRegex(" +1 +I +gable +none +detectors +8 +200\\.0 +7 +41\\.9 +0\\.0 +241\\.9"));
  EXPECT_THAT(
      line_of(text, "    2 "),
      MatchesRegex(" +2 +I +gable +none +classical +1 +250\\.0 +7 +41\\.9 +2\\.0 +293\\.9"));
  EXPECT_THAT(line_of(text, "    3 "),
              MatchesRegex(" +3 +II +gable, flat +2 dormers +classical +- +210\\.0 +13 +77\\.9 "
                           "+30\\.0 +317\\.9"));
  EXPECT_EQ(line_of(text, "    4 "), "");
}

TEST(Explanation, SourcesAndProbabilitiesAreNamed) {
  TileBuilding made = chosen();
  EXPECT_THAT(
      explain(made),
      HasSubstr("first values: 7 from the classical search, 2 from the detectors, 1 from the "
                "structural scales\n"));
  EXPECT_THAT(explain(made),
              HasSubstr("probabilities of the foundation: I 0.500, II 0.250, III 0.000, "
                        "L 0.125, U 0.062, C 0.062\n"));
  made.choice.foundation.reset();
  EXPECT_THAT(explain(made), Not(HasSubstr("probabilities")));
}

TEST(Explanation, WhatWasGivenUpIsListedWithItsCost) {
  EXPECT_THAT(line_of(explain(chosen()), "    10 "),
              MatchesRegex(" +10 +U +gable, gable, gable +scales +before details +2321\\.9"));
  TileBuilding made = chosen();
  made.choice.given_up.clear();
  EXPECT_THAT(explain(made), Not(HasSubstr("given up")));
}

TEST(Explanation, EveryRuleOfTheWinnersFirstValuesHasItsOrigin) {
  const std::string text = explain(chosen());
  EXPECT_THAT(text, HasSubstr("first values of no. 1: hypothesis 8, L from detectors, since "
                              "rewritten\n"));
  EXPECT_THAT(line_of(text, "    azimuth"),
              MatchesRegex(" +azimuth +by the stars +azimuth 0\\.00 rad"));
  EXPECT_THAT(line_of(text, "    footprint_l"),
              MatchesRegex(" +footprint_l +paced out +corner_x .* m"));
  EXPECT_THAT(line_of(text, "    roof_gable"), MatchesRegex(" +roof_gable +guessed +eaves .* m"));
}

TEST(Explanation, TheLeadIsOverTheNextOfAnotherFoundation) {
  TileBuilding made = chosen();
  EXPECT_EQ(line_of(explain(made), "  lead"), "  lead: foundation I is 75.9 ahead of II, no. 3");
  made.choice.finalists.pop_back();
  EXPECT_EQ(line_of(explain(made), "  lead"),
            "  lead: no other foundation came so far as foundation I");
}

TEST(Explanation, FinalistsAreSortedWhateverTheirOrder) {
  const std::string expected = explain(chosen());
  TileBuilding made = chosen();
  std::swap(made.choice.finalists[0], made.choice.finalists[2]);
  EXPECT_EQ(explain(made), expected);
}

TEST(Explanation, WhatTheWinnerBecameIsTold) {
  TileBuilding made = chosen();
  // 10 ln 400 = 59.9; 175.0 + 59.9.
  EXPECT_EQ(line_of(explain(made), "  afterwards"),
            "  afterwards: 1 chimney added; refined once more, J 241.9 -> 234.9 (S/sigma^2 175.0, "
            "k 10, charges 0.0)");
  made.choice.best.house.chimneys.clear();
  made.choice.best.house.roofs[0] = make_rule(RuleKind::kRoofFlat);
  made.choice.finalists[0].house.garages.resize(2, make_rule(RuleKind::kGarageI));
  EXPECT_THAT(explain(made), HasSubstr("afterwards: 2 garages dropped, roofs now flat;"));
}

TEST(Explanation, RelationsToNeighboursAreNamedWithTheirMisfits) {
  TileBuilding made = chosen();
  EXPECT_THAT(explain(made), Not(HasSubstr("neighbours")));
  made.relations = {{NeighbourRelationKind::kPartyWall, "b9", 0.213, 0.004},
                    {NeighbourRelationKind::kEqualEaves, "b9", 0.12, 0.01},
                    {NeighbourRelationKind::kEqualRidges, "b7", 0.3, 0.2},
                    {NeighbourRelationKind::kEqualAzimuths, "b9", 0.0349, 0.0}};
  EXPECT_EQ(line_of(explain(made), "  refined together"),
            "  refined together with its neighbours: party wall with b9 (0.21 -> 0.00 m), eaves "
            "equal to b9 (0.12 -> 0.01 m), ridge equal to b7 (0.30 -> 0.20 m), azimuth equal to b9 "
            "(2.0 -> 0.0 degrees)");
}

TEST(Explanation, TheOutcomeHasItsReason) {
  TileBuilding made = chosen();
  EXPECT_EQ(line_of(explain(made), "  outcome"),
            "  outcome: a house of the grammar, foundation I, MAD 0.123 m");
  made.model.dropped = {"dormer 0: no room"};
  EXPECT_THAT(explain(made), HasSubstr("\n  left out: dormer 0: no room\n"));
  made.building.status = BuildingStatus::kExtrusion;
  made.building.house.reset();
  made.building.reason = "no house of the grammar explains the heights";
  made.choice.found = false;
  const std::string text = explain(made);
  EXPECT_EQ(line_of(text, "  outcome"),
            "  outcome: its outline extruded to one height, MAD 0.123 m, because no house of the "
            "grammar explains the heights");
  EXPECT_THAT(text, HasSubstr("no better than bare ground"));
}

TEST(Explanation, ClosedPlanesAreCounted) {
  TileBuilding made = chosen();
  made.building.status = BuildingStatus::kPlanes;
  made.building.house.reset();
  made.building.roof = RoofPartition{{{0, 0, 3}, {0, 0, 5}}, {}};
  made.building.reason = "no house of the grammar explains the heights";
  EXPECT_EQ(line_of(explain(made), "  outcome"),
            "  outcome: 2 planes closed over its outline, MAD 0.123 m, because no house of the "
            "grammar explains the heights");
}

TEST(Explanation, WhereNoHouseWasLookedForNothingIsCompared) {
  TileBuilding made = chosen();
  made.choice = {};
  made.building.status = BuildingStatus::kExtrusion;
  made.building.house.reset();
  made.building.reason = "only 2.0 square metres with heights";
  EXPECT_EQ(explain(made),
            "b12_34\n"
            "  first values: none, so no house was fitted\n"
            "  outcome: its outline extruded to one height, MAD 0.123 m, because only 2.0 square "
            "metres with heights\n");
}

}  // namespace
}  // namespace gable
