#include <gable/engine/reconstruct/choice/house_choice.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "engine/house_image.h"

namespace gable {
namespace {

Scene scene_of(Foundation foundation, uint64_t seed) {
  SceneOptions options;
  options.seed = seed;
  options.trees = 0;
  return make_scene(foundation, options);
}

constexpr Foundation kTypes[] = {Foundation::kI, Foundation::kII, Foundation::kIII, Foundation::kL,
                                 Foundation::kU};

TEST(HouseChoice, FindsTheFoundationOfMostScenesWithoutTrees) {
  int right = 0, close = 0;
  for (const Foundation type : kTypes) {
    for (uint64_t seed = 1; seed <= 2; ++seed) {
      const HeightImage image = image_of(scene_of(type, seed));
      const HouseChoice choice = choose_house(image, {});
      ASSERT_TRUE(choice.found);
      EXPECT_TRUE(is_well_formed(choice.best.house));
      EXPECT_EQ(choice.best.house.origin, image.origin);
      close += choice.summary.mad < 0.25;
      right += choice.best.house.foundation == type;
    }
  }
  EXPECT_GE(right, 8);
  EXPECT_GE(close, 8);
}

TEST(HouseChoice, IsTheSameToTheLastByteOnRepeat) {
  for (const Foundation type : {Foundation::kII, Foundation::kL}) {
    const HeightImage image = image_of(scene_of(type, 3));
    const HouseChoice a = choose_house(image, {}), b = choose_house(image, {});
    const auto rules = a.best.house.derivation(), again = b.best.house.derivation();
    ASSERT_EQ(rules.size(), again.size());
    for (size_t i = 0; i < rules.size(); ++i) {
      EXPECT_EQ(rules[i]->kind, again[i]->kind);
      EXPECT_EQ(rules[i]->ridge, again[i]->ridge);
      EXPECT_EQ(rules[i]->component, again[i]->component);
      EXPECT_EQ(
          std::memcmp(rules[i]->values.data(), again[i]->values.data(), sizeof(rules[i]->values)),
          0);
    }
    EXPECT_EQ(a.best.cost.total, b.best.cost.total);
    EXPECT_EQ(a.finalists.size(), b.finalists.size());
  }
}

TEST(HouseChoice, TakesTheFinalistOfTheLeastCost) {
  const HouseChoice choice = choose_house(image_of(scene_of(Foundation::kI, 2)), {});
  ASSERT_FALSE(choice.finalists.empty());
  for (size_t i = 1; i < choice.finalists.size(); ++i) {
    EXPECT_LE(choice.finalists[i - 1].cost.total, choice.finalists[i].cost.total);
  }
  EXPECT_EQ(choice.best.house.foundation, choice.finalists[0].house.foundation);
  EXPECT_GE(choice.num_hypotheses(), 1);
  EXPECT_GE(choice.noise, HouseChoiceOptions{}.least_noise);
  EXPECT_LE(choice.noise, HouseChoiceOptions{}.most_noise);
}

TEST(HouseChoice, EveryHypothesisIsAFinalistOrGivenUp) {
  const HouseChoice choice = choose_house(image_of(scene_of(Foundation::kII, 2)), {});
  std::vector<int> seen(choice.num_hypotheses(), 0);
  for (const Candidate& c : choice.given_up) {
    EXPECT_NE(c.stage, ChoiceStage::kFinished);
    ++seen[c.hypothesis];
  }
  for (const int count : seen) EXPECT_LE(count, 1);
  for (const Candidate& c : choice.finalists) {
    EXPECT_EQ(c.stage, ChoiceStage::kFinished);
    ++seen[c.hypothesis];  // rewrites as well, under the number of what they were made from
  }
  for (const int count : seen) EXPECT_GE(count, 1);
}

TEST(HouseChoice, FindsNothingOnOpenGround) {
  HeightImage image = image_of(box_house(12.0, 8.0, flat_roof(5.0)));
  image.height = image.ground;
  image.inside.assign(image.size(), 0);
  const HouseChoice choice = choose_house(image, {});
  EXPECT_FALSE(choice.found);
  EXPECT_EQ(choice.num_hypotheses(), 0);
}

/// What detectors might say: one house, and the foundation's probability, the rest shared evenly.
FirstValues detected(const House& house, Foundation foundation, float probability) {
  FirstValues values;
  values.foundation.emplace();
  values.foundation->fill((1.0f - probability) / 5.0f);
  (*values.foundation)[static_cast<size_t>(foundation)] = probability;
  values.houses.push_back({house, ValueSource::kDetectors, {}, std::log(probability)});
  return values;
}

TEST(FoundationCharges, AreTwiceTheNegativeLogOfTheProbabilityAmongHouses) {
  HouseChoiceOptions options;
  options.type_weight = 3.0;
  options.least_probability = 0.01;
  const auto charges = foundation_charges({0.2f, 0.1f, 0.08f, 0.02f, 0.0f, 0.6f}, options);
  EXPECT_NEAR(charges[0], 6.0 * std::log(2.0), 1e-5);
  EXPECT_NEAR(charges[1], 6.0 * std::log(4.0), 1e-5);
  EXPECT_NEAR(charges[2], 6.0 * std::log(5.0), 1e-5);
  EXPECT_NEAR(charges[3], 6.0 * std::log(20.0), 1e-5);
  EXPECT_NEAR(charges[4], 6.0 * std::log(100.0), 1e-5);  // bounded below
  EXPECT_EQ(charges[5], 0.0);
  EXPECT_EQ(charges[6], charges[2]);  // N as III
}

TEST(FoundationCharges, AreAllTheSameWhereOnlyCIsProbable) {
  const auto charges = foundation_charges({0.0f, 0.0f, 0.0f, 0.0f, 0.0f, 1.0f}, {});
  for (int i = 0; i < 5; ++i) EXPECT_EQ(charges[i], charges[0]);
}

TEST(HouseChoice, StartsFromWhatIsDetectedAloneAndSaysSo) {
  const Scene scene = scene_of(Foundation::kII, 2);
  const HeightImage image = image_of(scene);
  House start = scene.house;
  for (Rule& footprint : start.footprints) footprint[0] += 0.6;
  for (Rule& roof : start.roofs) roof[param::roof::kEaves] += 0.5;
  HouseChoiceOptions options;
  options.classical = false;
  const FirstValues values = detected(start, Foundation::kII, 0.9f);
  const HouseChoice choice = choose_house(image, options, values);
  ASSERT_TRUE(choice.found);
  EXPECT_EQ(choice.num_hypotheses(), 1);
  EXPECT_EQ(choice.best.house.foundation, Foundation::kII);
  EXPECT_LT(choice.summary.mad, 0.2);
  EXPECT_EQ(choice.best.source, ValueSource::kDetectors);
  for (const Candidate& c : choice.finalists) EXPECT_EQ(c.source, ValueSource::kDetectors);
  ASSERT_TRUE(choice.foundation.has_value());
  EXPECT_EQ(*choice.foundation, *values.foundation);
}

TEST(HouseChoice, NeitherSourceFindsNothing) {
  const HeightImage image = image_of(scene_of(Foundation::kI, 2));
  HouseChoiceOptions options;
  options.classical = false;
  EXPECT_FALSE(choose_house(image, options).found);
  const FirstValues empty;
  EXPECT_FALSE(choose_house(image, options, empty).found);
}

TEST(HouseChoice, AWrongDetectedHouseDoesNotSpoilTheChoice) {
  const Scene scene = scene_of(Foundation::kI, 2);
  const HeightImage image = image_of(scene);
  House wrong = scene.house;
  wrong.footprints[0][0] += 8.0;
  HouseChoiceOptions options;
  options.type_weight = 0.0;
  const FirstValues values = detected(wrong, Foundation::kI, 0.9f);
  const HouseChoice alone = choose_house(image, options);
  const HouseChoice both = choose_house(image, options, values);
  EXPECT_FALSE(alone.foundation.has_value());
  EXPECT_EQ(both.num_hypotheses(), alone.num_hypotheses() + 1);
  EXPECT_EQ(both.num_from(ValueSource::kDetectors), 1);
  EXPECT_LE(both.best.cost.total, alone.best.cost.total + 1e-6);
  EXPECT_EQ(both.best.house.foundation, alone.best.house.foundation);
}

/// Two blocks one after the other, the second one higher by `step` metres.
House stepped_house(double step) {
  House house = make_house(Foundation::kII);
  house.footprints = {rectangle_rule(-8.0, 1.0, -4.0, 4.0), rectangle_rule(1.0, 8.0, -4.0, 4.0)};
  house.roofs = {gable_roof(5.0, 2.5, Axis::kX), gable_roof(5.0 + step, 2.5, Axis::kX)};
  return house;
}

TEST(HouseChoice, ProbabilitiesTurnAChoiceThatTheHeightsLeaveOpen) {
  const House house = stepped_house(0.25);  // one rectangle or two
  const HeightImage image = image_of(house, {.noise = 0.1});
  HouseChoiceOptions options;
  const auto chosen = [&](Foundation foundation, double weight) {
    options.type_weight = weight;
    FirstValues values = detected(house, foundation, 0.98f);
    values.houses.clear();
    return choose_house(image, options, values);
  };
  const HouseChoice as_one = chosen(Foundation::kI, 100.0), as_two = chosen(Foundation::kII, 100.0);
  EXPECT_EQ(as_one.best.house.foundation, Foundation::kI);
  EXPECT_EQ(as_two.best.house.foundation, Foundation::kII);
  EXPECT_EQ(as_one.best.source, ValueSource::kClassical);
  // Without weight they do not count.
  EXPECT_EQ(chosen(Foundation::kI, 0.0).best.cost.total,
            chosen(Foundation::kII, 0.0).best.cost.total);
}

TEST(HouseChoice, HypothesesOfImprobableTypesCanBeSkippedButNeverAll) {
  const HeightImage image = image_of(scene_of(Foundation::kI, 2));
  HouseChoiceOptions options;
  FirstValues values;
  values.foundation = std::array<float, kNumFoundations>{0.95f, 0.01f, 0.01f, 0.01f, 0.01f, 0.01f};
  const int all = choose_house(image, options, values).num_hypotheses();
  options.skipped_probability = 0.1;
  const int some = choose_house(image, options, values).num_hypotheses();
  EXPECT_LT(some, all);
  EXPECT_GE(some, 1);
  options.skipped_probability = 1.0;
  EXPECT_EQ(choose_house(image, options, values).num_hypotheses(), all);
}

TEST(HouseChoice, CheckNamesTheViolatedBound) {
  const auto with = [](auto change) {
    HouseChoiceOptions options;
    change(&options);
    return check(options);
  };
  using Options = HouseChoiceOptions;
  EXPECT_EQ(check(Options{}), "");
  EXPECT_EQ(with([](Options* o) { o->per_foundation = 0; }), "per_foundation must lie in [1, 10]");
  EXPECT_EQ(with([](Options* o) { o->finalists = 21; }), "finalists must lie in [1, 20]");
  EXPECT_EQ(with([](Options* o) { o->hopeless = 1.0; }), "hopeless must be above 1");
  EXPECT_EQ(with([](Options* o) { o->least_noise = 0.0; }), "least_noise must be positive");
  EXPECT_EQ(with([](Options* o) { o->most_noise = 0.05; }), "most_noise is below least_noise");
  EXPECT_EQ(with([](Options* o) { o->type_weight = 101.0; }), "type_weight must lie in [0, 100]");
  EXPECT_EQ(with([](Options* o) { o->least_probability = 0.0; }),
            "least_probability must lie in (0, 1]");
  EXPECT_EQ(with([](Options* o) { o->skipped_probability = -0.1; }),
            "skipped_probability must lie in [0, 1]");
}

}  // namespace
}  // namespace gable
