#include <gable/engine/evaluate/rand_index.h>
#include <gable/grammar/random.h>
#include <gtest/gtest.h>

#include <vector>

namespace gable {
namespace {

/// The same index from the four kinds of pairs, each pair looked at (Hubert and Arabie 1985).
double index_by_pairs(const std::vector<int>& a, const std::vector<int>& b) {
  double both = 0.0, only_a = 0.0, only_b = 0.0, neither = 0.0;
  for (size_t i = 0; i < a.size(); ++i) {
    for (size_t j = 0; j < i; ++j) {
      const bool in_a = a[i] == a[j], in_b = b[i] == b[j];
      (in_a ? (in_b ? both : only_a) : (in_b ? only_b : neither)) += 1.0;
    }
  }
  return 2.0 * (both * neither - only_a * only_b) /
         ((both + only_a) * (only_a + neither) + (both + only_b) * (only_b + neither));
}

TEST(AdjustedRandIndex, EqualsTheCountOverAllPairs) {
  Random random(5);
  for (int round = 0; round < 20; ++round) {
    std::vector<int> a, b;
    const int classes = random.integer(2, 12);
    for (int i = 0; i < 150; ++i) {
      a.push_back(random.integer(-1, classes));
      b.push_back(random.chance(0.7) ? a.back() : random.integer(-1, 4));
    }
    EXPECT_NEAR(adjusted_rand_index(a, b), index_by_pairs(a, b), 1e-12);
  }
}

TEST(AdjustedRandIndex, NamesOfClassesDoNotMatter) {
  EXPECT_EQ(adjusted_rand_index(std::vector{7, 7, -1, 3}, std::vector{0, 0, 9, 2}), 1.0);
}

TEST(AdjustedRandIndex, KnownValues) {
  EXPECT_NEAR(adjusted_rand_index(std::vector{0, 0, 1, 1}, std::vector{0, 0, 1, 2}), 4.0 / 7,
              1e-15);
  EXPECT_EQ(adjusted_rand_index(std::vector{0, 0, 1, 1}, std::vector{3, 3, 3, 3}), 0.0);
  EXPECT_EQ(adjusted_rand_index(std::vector{2, 2}, std::vector{3, 3}), 1.0);
  EXPECT_EQ(adjusted_rand_index(std::vector<int>(), std::vector<int>()), 1.0);
}

TEST(AdjustedRandIndex, IndependentLabelsScoreAboutNothing) {
  Random random(6);
  std::vector<int> a, b;
  for (int i = 0; i < 20000; ++i) {
    a.push_back(random.integer(0, 9));
    b.push_back(random.integer(0, 5));
  }
  EXPECT_NEAR(adjusted_rand_index(a, b), 0.0, 1e-3);
}

}  // namespace
}  // namespace gable
