#include <gable/engine/scales/forest.h>
#include <gable/grammar/random.h>
#include <gtest/gtest.h>

#include <cmath>

namespace gable {
namespace {

// Two trees over features 0 and 17; leaves of 2 labels with 0, 1, 2 ... steps of cost.
Forest two_trees() {
  Forest forest;
  forest.num_labels = 2;
  forest.roots = {0, 3};
  forest.nodes = {{0.5f, 0, 2},  {0.0f, -1, 0}, {0.0f, -1, 1}, {0.25f, 17, 5},
                  {0.0f, -1, 2}, {0.75f, 0, 7}, {0.0f, -1, 3}, {0.0f, -1, 4}};
  forest.leaf_costs = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9};
  return forest;
}

TEST(Forest, TheCostOfALabelIsTheMeanOverTheLeavesThatAConfigurationReaches) {
  const Forest forest = two_trees();
  ASSERT_EQ(check(forest), "");
  ScaleFeatures low{}, middle{}, high{};
  low[0] = 0.5f, low[17] = 0.25f;  // up to the threshold is left
  middle[0] = 0.6f, middle[17] = 0.3f;
  high[0] = 0.8f, high[17] = 0.3f;
  const std::vector<double> costs = label_costs(forest, std::vector{low, middle, high});
  const auto mean = [](int a, int b) { return (a + b) / 2.0 / 32.0; };
  EXPECT_EQ(costs, (std::vector<double>{mean(0, 4), mean(1, 5), mean(2, 6), mean(3, 7), mean(2, 8),
                                        mean(3, 9)}));
}

TEST(Forest, ALeafKeepsTheLogarithmOfAProbabilityToHalfAStep) {
  EXPECT_EQ(leaf_cost(1.0), 0);
  Random random(1);
  for (int i = 0; i < 1000; ++i) {
    const double p = std::exp(-random.uniform(0.0, 7.9));
    EXPECT_NEAR(leaf_cost(p) * kLeafCostStep, -std::log(p), 0.5 * kLeafCostStep + 1e-12);
  }
  EXPECT_EQ(leaf_cost(1e-300), 255);
}

TEST(Forest, SaysWhatIsUnsound) {
  const auto broken = [](auto change) {
    Forest forest = two_trees();
    change(&forest);
    return check(forest);
  };
  EXPECT_EQ(broken([](Forest* f) { f->num_labels = 0; }), "num_labels must lie in [1, 64]");
  EXPECT_EQ(broken([](Forest* f) { f->roots.clear(); }), "there is no tree");
  EXPECT_EQ(broken([](Forest* f) { f->leaf_costs.pop_back(); }),
            "leaf_costs must hold num_labels bytes a leaf");
  EXPECT_EQ(broken([](Forest* f) { f->roots[1] = 4; }),
            "a tree must begin where the one before it ends");
  EXPECT_EQ(broken([](Forest* f) { f->roots.pop_back(); }), "there are nodes behind the last tree");
  EXPECT_EQ(broken([](Forest* f) { f->nodes.pop_back(); }), "the last tree is not whole");
  EXPECT_EQ(broken([](Forest* f) { f->nodes[1].next = 5; }),
            "leaves must be numbered in the order of their nodes");
  EXPECT_EQ(broken([](Forest* f) { f->nodes[0].feature = 18; }),
            "a test looks at a feature that does not exist");
  EXPECT_EQ(broken([](Forest* f) { f->nodes[0].threshold = NAN; }), "a threshold is not finite");
  for (const int next : {-1, 0, 1, 3, 100}) {  // a loop, no left child, another tree, nowhere
    EXPECT_EQ(broken([&](Forest* f) { f->nodes[0].next = next; }),
              "a right child must follow what lies below the left one");
  }
}

}  // namespace
}  // namespace gable
