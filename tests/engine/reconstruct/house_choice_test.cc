#include <gable/engine/reconstruct/house_choice.h>
#include <gtest/gtest.h>

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
  EXPECT_GE(choice.hypotheses, 1);
  EXPECT_GE(choice.noise, HouseChoiceOptions{}.least_noise);
  EXPECT_LE(choice.noise, HouseChoiceOptions{}.most_noise);
}

TEST(HouseChoice, FindsNothingOnOpenGround) {
  HeightImage image = image_of(box_house(12.0, 8.0, flat_roof(5.0)));
  image.height = image.ground;
  image.inside.assign(image.size(), 0);
  const HouseChoice choice = choose_house(image, {});
  EXPECT_FALSE(choice.found);
  EXPECT_EQ(choice.hypotheses, 0);
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
}

}  // namespace
}  // namespace gable
